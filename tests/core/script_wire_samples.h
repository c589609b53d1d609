// SPDX-License-Identifier: MIT
// Random plain data for the wire between daemon and scripts.
#pragma once

#include "daemon/core/script_wire.h"

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace hyrax::wire {

/// The same seed makes the same samples.
class Samples {
public:
    explicit Samples(std::uint32_t seed) : random_(seed) {}

    std::size_t below(std::size_t end) { return random_() % end; }
    bool flip() { return below(2) == 0; }
    double number() {
        constexpr double odd[] = {0.0, -0.0, 1e308, -1e-308, 20'000.0, 0.1};
        return odd[below(std::size(odd))] * (flip() ? 1.0 : 0.5);
    }
    double any_number() {
        return below(8) == 0 ? std::numeric_limits<double>::quiet_NaN() : number();
    }
    Vec2 vec() { return {number(), number()}; }
    std::string text(std::size_t longest = 40) {
        std::string text(below(longest + 1), '\0');
        for (char& letter : text) {
            letter = static_cast<char>(random_());
        }
        return text;
    }
    std::string line() { return "line " + std::to_string(random_()); }
    PetKey made_key() { return script_made_key | random_(); }

    ScriptValue value(int depth = 0) {
        switch (below(depth < 4 ? 7 : 5)) {
            case 0:
                return {};
            case 1:
                return {flip()};
            case 2:
                return {static_cast<std::int64_t>(random_())};
            case 3:
                return {number()};
            case 4:
                return {text()};
            case 5: {
                ScriptValue::List list;
                for (std::size_t i = below(4); i > 0; --i) {
                    list.push_back(value(depth + 1));
                }
                return {list};
            }
            default:
                return {table(depth + 1)};
        }
    }
    ScriptTable table(int depth = 0) {
        ScriptTable table;
        for (std::size_t i = below(4); i > 0; --i) {
            set_field(table, text(), value(depth + 1));
        }
        return table;
    }
    ScriptSource source() {
        ScriptSource source{.name = text(), .text = text(3'000), .version = text()};
        for (std::size_t i = below(3); i > 0; --i) {
            source.permissions.push_back(text());
        }
        source.config = table();
        source.store = table();
        source.file = text();
        for (std::size_t i = below(3); i > 0; --i) {
            source.modules.push_back({text(), text(300)});
        }
        source.keep_pets = flip();
        source.testing = flip();
        source.turn = random_();
        return source;
    }

    PetView pet() {
        return {
            .key = random_(),
            .kind = text(),
            .owner = text(),
            .tag = text(),
            .position = vec(),
            .velocity = vec(),
            .box = {static_cast<int>(below(500)), static_cast<int>(below(500))},
            .state = "fall",
            .faces_left = flip(),
            .scale = number(),
            .spawned_at = flip() ? std::optional(vec()) : std::nullopt,
        };
    }
    ScriptEvent event() {
        return {
            .event =
                {.kind = static_cast<EventKind>(below(std::to_underlying(last_event_kind) + 1U)),
                 .pet = {},
                 .side = static_cast<Side>(below(4)),
                 .button = static_cast<Button>(below(3)),
                 .speed = number(),
                 .velocity = vec(),
                 .tag = text()},
            .pet = random_(),
            .other = random_(),
        };
    }
    ScriptCommand command() {
        switch (below(17)) {
            case 0:
                return command::Spawn{
                    made_key(),
                    {.kind = text(),
                     .at = flip() ? std::optional(vec()) : std::nullopt,
                     .velocity = {any_number(), number()},
                     .owner = text(),
                     .tag = text(),
                     .scale = any_number(),
                     .opacity = any_number()}
                };
            case 1:
                return command::Fling{random_(), {any_number(), any_number()}};
            case 2:
                return command::Push{random_(), vec()};
            case 3:
                return command::Stop{random_()};
            case 4:
                return command::Reset{random_()};
            case 5:
                return command::MoveTo{random_(), vec()};
            case 6:
                return command::SetTag{random_(), text()};
            case 7:
                return command::WalkTo{random_(), any_number(), number()};
            case 8:
                return command::Play{
                    random_(),
                    text(),
                    flip() ? std::optional(flip()) : std::nullopt,
                    flip() ? std::optional(any_number()) : std::nullopt
                };
            case 9:
                return command::Say{random_(), text(), any_number()};
            case 10:
                return command::SetScale{random_(), any_number()};
            case 11:
                return command::Face{random_(), flip()};
            case 12:
                return command::Store{text(), text(), value()};
            case 13:
                return command::Notify{line(), line()};
            case 14:
                return command::Hotkey{text(), random_(), text(), text()};
            case 15:
                return command::Wind{text(), vec()};
            default:
                return command::Remove{random_()};
        }
    }
    ScriptWorld world() {
        ScriptWorld world{.now = static_cast<Ticks>(random_()), .pets = {}, .monitors = {}};
        for (std::size_t i = below(6); i > 0; --i) {
            world.pets.push_back(pet());
            world.kinds.push_back({.name = text(), .box = {3, 4}, .animations = {text(), text()}});
            world.windows.push_back({-1, 2, 3, static_cast<int>(below(99))});
            world.pressed_hotkeys.push_back({text(), random_()});
            world.evaluations.push_back({random_(), text(), text(500)});
        }
        world.cursor = flip() ? std::optional(vec()) : std::nullopt;
        world.ending = flip();
        if (flip()) {
            world.monitors.push_back({{-5, 6, 7, 8}, {1, 2, 3, 4}, flip(), text()});
        }
        return world;
    }
    std::vector<ScriptEvent> events() {
        std::vector<ScriptEvent> list;
        for (std::size_t i = below(6); i > 0; --i) {
            list.push_back(event());
        }
        return list;
    }
    ScriptOutput output() {
        ScriptOutput output;
        for (std::size_t i = below(8); i > 0; --i) {
            output.commands.push_back(command());
        }
        for (std::size_t i = below(4); i > 0; --i) {
            output.log.push_back({static_cast<LogLevel>(below(3)), line(), line()});
            output.ended.push_back(static_cast<std::uint32_t>(below(1'000)));
            output.tests.push_back({line(), line(), flip() ? line() : "", number()});
            output.evaluated.push_back({random_(), flip(), line() + "\n" + line(), line()});
        }
        if (flip()) {
            output.listening.add(EventKind::land);
            output.uses.push_back({line(), random_(), below(99), below(9), output.listening});
        }
        output.open_tests = below(9);
        output.next_wake = flip() ? never : static_cast<Ticks>(random_());
        return output;
    }
    Load load() {
        Load load{
            .limits = {}, .scripts = static_cast<std::uint32_t>(below(most_scripts)), .anew = flip()
        };
        load.limits.seed = random_();
        load.limits.pets = 1 + below(100);
        return load;
    }

    /// One message of any type.
    Bytes message() {
        Bytes bytes;
        switch (below(4)) {
            case 0:
                encode(bytes, load());
                break;
            case 1:
                encode(bytes, source());
                break;
            case 2:
                encode_run(bytes, random_(), world(), events());
                break;
            default:
                encode_answer(bytes, random_(), output());
        }
        return bytes;
    }

private:
    std::mt19937_64 random_;
};

/// Without the length in front.
inline std::span<const std::byte> body(const Bytes& message) {
    return std::span(message).subspan(sizeof(std::uint32_t));
}

}  // namespace hyrax::wire
