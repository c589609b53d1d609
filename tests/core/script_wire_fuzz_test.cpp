// SPDX-License-Identifier: MIT
// Damaged messages, both ways: they decode, or they do not, and nothing else happens. `./dev fuzz`
// damages many.
#include "tests/core/script_wire_samples.h"
#include "tests/support/fuzzing.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <utility>

using namespace hyrax;
using namespace hyrax::wire;

namespace {

// Of one seed.
constexpr long messages = 1'000;

Samples samples_of(std::uint64_t seed) {
    return Samples(static_cast<std::uint32_t>(seed));
}

void damage(Bytes& bytes, Samples& samples) {
    for (std::size_t times = 1 + samples.below(4); times > 0 && !bytes.empty(); --times) {
        const std::size_t at = samples.below(bytes.size());
        const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
        switch (samples.below(6)) {
            case 0:
                bytes[at] ^= std::byte{1} << samples.below(8);
                break;
            case 1:
                bytes[at] = static_cast<std::byte>(samples.below(256));
                break;
            case 2:
                bytes.erase(place, bytes.end());
                break;
            case 3:
                bytes.insert(place, 1 + samples.below(9), std::byte{0xFF});
                break;
            case 4: {
                const Bytes other = samples.message();
                bytes.insert(place, other.begin(), other.end());
                break;
            }
            default:
                bytes.erase(place);
        }
    }
}

Bytes encoded(const ToHost& message) {
    Bytes bytes;
    if (const auto* const run = std::get_if<Run>(&message)) {
        encode_run(bytes, run->number, run->world, run->events);
    } else if (const auto* const load = std::get_if<Load>(&message)) {
        encode(bytes, *load);
    } else {
        encode(bytes, std::get<ScriptSource>(message));
    }
    return bytes;
}

// The strongest thing that can be said of what passes: it means exactly what it says.
bool holds(std::span<const std::byte> message, long& passed) {
    bool good = true;
    if (const auto decoded = decode_to_host(message)) {
        ++passed;
        good = std::ranges::equal(body(encoded(*decoded)), message);
    }
    if (const auto decoded = decode_answer(message)) {
        ++passed;
        Bytes again;
        encode_answer(again, decoded->number, decoded->output);
        good = good && std::ranges::equal(body(again), message);
    }
    return good;
}

}  // namespace

TEST_CASE("damaged messages are refused or mean exactly what they say") {
    long passed = 0;
    const std::uint64_t seeds = fuzz(20, [&passed](std::uint64_t seed) {
        Samples samples = samples_of(seed);
        long broken = 0;
        for (long i = 0; i < messages; ++i) {
            Bytes bytes = samples.message();
            bytes.erase(bytes.begin(), bytes.begin() + 4);
            damage(bytes, samples);
            broken += holds(bytes, passed) ? 0 : 1;
        }
        CHECK(broken == 0);
    });
    // Some damage is to numbers and texts, which may be anything.
    const long all = static_cast<long>(seeds) * messages;
    CHECK(passed > all / 50);
    CHECK(passed < all);
}

TEST_CASE("a stream of noise ends in an error or waits for more") {
    fuzz(20, [](std::uint64_t seed) {
        Samples samples = samples_of(seed);
        for (long i = 0; i < messages / 20; ++i) {
            MessageStream stream(longest_to_daemon);
            Bytes noise = samples.message();
            damage(noise, samples);
            stream.add(noise);
            for (int taken = 0; taken < 100; ++taken) {
                const auto next = stream.next();
                if (!next || !*next) {
                    break;
                }
                long passed = 0;
                CHECK(holds(**next, passed));
            }
        }
    });
}
