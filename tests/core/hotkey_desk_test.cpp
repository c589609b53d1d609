// SPDX-License-Identifier: MIT
#include "daemon/core/hotkey_desk.h"

#include <doctest/doctest.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <map>
#include <memory>
#include <sstream>
#include <string>

using namespace hyrax;

namespace {

// Has a keyboard and nothing else.
class Keyboard final : public Desktop {
public:
    Ticks now() override { return 0; }
    std::vector<Input> wait(Ticks) override { return {}; }
    void present(const Frame&) override {}
    void use_renderer(Renderer) override {}
    std::vector<Monitor> monitors() override { return {}; }
    void show_status(const Status&) override {}
    void read_aside(std::unique_ptr<SpriteReading>) override {}
    std::unique_ptr<SpriteReading> sprites_read() override { return nullptr; }
    Result<void> take_hotkey(HotkeyId id, const KeyCombination& keys) override {
        if (text_of(keys) == "win+l") {
            return failure("another program has it");
        }
        CHECK(id >= 1);
        CHECK(id <= last_hotkey_id);
        CHECK(taken.emplace(id, text_of(keys)).second);
        return {};
    }
    void give_back_hotkey(HotkeyId id) override { CHECK(taken.erase(id) == 1); }

    HotkeyId id_of(const std::string& keys) const {
        for (const auto& [id, its] : taken) {
            if (its == keys) {
                return id;
            }
        }
        return 0;
    }

    std::map<HotkeyId, std::string> taken;
};

struct Scene {
    void ask(const std::string& script, std::uint64_t id, const std::string& keys) {
        desk.obey(keyboard, {script, id, keys, "label"});
    }
    void use(UserHotkey which, const std::string& keys) {
        wishes[static_cast<std::size_t>(which)] = *parse_keys(keys);
        desk.use(keyboard, wishes);
    }
    std::string warnings(const std::function<void()>& act) {
        std::ostringstream text;
        const auto before = spdlog::default_logger();
        auto sink = std::make_shared<spdlog::sinks::ostream_sink_st>(text);
        auto logger = std::make_shared<spdlog::logger>("test", std::move(sink));
        logger->set_formatter(std::make_unique<spdlog::pattern_formatter>(
            "%v", spdlog::pattern_time_type::local, "\n"
        ));
        spdlog::set_default_logger(std::move(logger));
        act();
        spdlog::set_default_logger(before);
        return text.str();
    }

    Keyboard keyboard;
    HotkeyDesk desk;
    UserHotkeys wishes;
};

}  // namespace

TEST_CASE("a hotkey belongs to the script that took it until that gives it back") {
    Scene scene;
    scene.ask("a.lua", 3, "ctrl+alt+h");
    scene.ask("b.lua", 3, "f5");
    const HotkeyId id = scene.keyboard.id_of("ctrl+alt+h");
    REQUIRE(id != 0);
    CHECK(scene.desk.task(id) == HotkeyTask(PressedHotkey{"a.lua", 3}));
    scene.ask("a.lua", 4, "");
    CHECK(scene.keyboard.taken.size() == 2);
    scene.ask("a.lua", 3, "");
    CHECK(scene.keyboard.taken.size() == 1);
    CHECK_FALSE(scene.desk.task(id));
    scene.ask("a.lua", 3, "ctrl+alt+h");
    CHECK(scene.keyboard.id_of("ctrl+alt+h") != id);  // a press that is on the way is nobody's
}

TEST_CASE("what cannot be had is told once, by script and keys") {
    Scene scene;
    CHECK(scene.warnings([&] {
        scene.ask("a.lua", 1, "win+l");
        scene.ask("a.lua", 2, "win+l");
    }) == "a.lua: hotkey win+l: another program has it\n");
    scene.ask("a.lua", 3, "f5");
    CHECK(scene.warnings([&] {
        scene.ask("b.lua", 1, "f5");
    }) == "b.lua: hotkey f5: a.lua has it already\n");
    CHECK(scene.warnings([&] { scene.ask("a.lua", 4, "nonsense"); }).contains("is no key"));
    scene.desk.keep(scene.keyboard, {{"a.lua", ""}});
    CHECK(scene.warnings([&] { scene.ask("a.lua", 1, "win+l"); }).contains("another program"));
    CHECK(scene.keyboard.taken.size() == 1);
}

TEST_CASE("one script takes no more than its share, and all together no more than there are") {
    Scene scene;
    const auto keys = [](std::size_t i) {
        const char letter = static_cast<char>('a' + i % 26);
        return std::string(i < 26 ? "ctrl+" : i < 52 ? "alt+" : "ctrl+alt+") + letter;
    };
    std::size_t asked = 0;
    const std::string told = scene.warnings([&] {
        for (; asked < 20; ++asked) {
            scene.ask("greedy.lua", asked, keys(asked));
        }
    });
    CHECK(scene.keyboard.taken.size() == HotkeyDesk::most_of_a_script);
    CHECK(told.contains("greedy.lua: hotkey ctrl+q: a script can have 16 at a time"));
    CHECK(scene
              .warnings([&] {
                  for (; asked < 78; ++asked) {
                      scene.ask("s" + std::to_string(asked), 1, keys(asked));
                  }
              })
              .contains("all scripts together can have 64 at a time"));
    CHECK(scene.keyboard.taken.size() == HotkeyDesk::most);
}

TEST_CASE("who is not loaded any more keeps nothing, and after a loss nobody does") {
    Scene scene;
    scene.ask("a.lua", 1, "f5");
    scene.ask("b.lua", 1, "f6");
    scene.ask("b.lua", 2, "f7");
    scene.desk.keep(scene.keyboard, {{"a.lua", ""}});
    CHECK(scene.keyboard.taken.size() == 1);
    CHECK(scene.keyboard.id_of("f5") != 0);
    scene.use(UserHotkey::hide, "f8");
    scene.desk.give_back_scripts(scene.keyboard);
    CHECK(scene.keyboard.taken.size() == 1);
    scene.desk.give_back_all(scene.keyboard);
    CHECK(scene.keyboard.taken.empty());
}

TEST_CASE("numbers of hotkeys start again before they end") {
    Scene scene;
    scene.ask("a.lua", 1, "f5");
    for (int i = 0; i < 50'000; ++i) {
        scene.ask("a.lua", 2, "f6");
        scene.ask("a.lua", 2, "");
    }
    CHECK(scene.keyboard.taken.size() == 1);
}

TEST_CASE("the user's hotkeys come before those of scripts, and follow what is wished") {
    Scene scene;
    scene.ask("a.lua", 1, "f5");
    CHECK(scene.warnings([&] {
        scene.use(UserHotkey::gather, "f5");
    }) == "a.lua loses f5 to the user\n");
    const HotkeyId id = scene.keyboard.id_of("f5");
    CHECK(scene.desk.task(id) == HotkeyTask(UserHotkey::gather));
    CHECK(scene.warnings([&] {
        scene.ask("a.lua", 1, "f5");
    }) == "a.lua: hotkey f5: /hotkeys/gather has it already\n");
    CHECK(scene.warnings([&] {
        scene.use(UserHotkey::pause, "f5");
    }) == "config.json: /hotkeys/pause: f5: /hotkeys/gather has it already\n");
    scene.desk.keep(scene.keyboard, {});
    scene.use(UserHotkey::pause, "f6");
    CHECK(scene.keyboard.id_of("f5") == id);  // what has not changed is not taken anew
    scene.use(UserHotkey::gather, "f7");
    CHECK(scene.keyboard.id_of("f5") == 0);
    CHECK(scene.desk.task(scene.keyboard.id_of("f7")) == HotkeyTask(UserHotkey::gather));
    scene.desk.use(scene.keyboard, {});
    CHECK(scene.keyboard.taken.empty());
}

TEST_CASE("what another program has is tried again by the next call, and no script's share") {
    Scene scene;
    for (int i = 0; i < 2; ++i) {
        CHECK(scene.warnings([&] {
            scene.use(UserHotkey::quiet, "win+l");
        }) == "config.json: /hotkeys/quiet: win+l: another program has it\n");
    }
    scene.use(UserHotkey::quiet, "f5");
    for (std::uint64_t i = 0; i < HotkeyDesk::most_of_a_script; ++i) {
        scene.ask("a.lua", i, std::string("ctrl+") + static_cast<char>('a' + i));
    }
    CHECK(scene.keyboard.taken.size() == HotkeyDesk::most_of_a_script + 1);
}
