// SPDX-License-Identifier: MIT
#include "daemon/core/framing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

using namespace hyrax;

namespace {

using State = FrameReader::State;

std::string header(std::uint32_t length) {
    std::string bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>((length >> shift) & 0xFFU);
    }
    return bytes;
}

}  // namespace

TEST_CASE("a text travels with its length, the lowest byte first") {
    CHECK(framed("{}") == std::string("\x02\0\0\0{}", 6));
    CHECK(framed(std::string(258, 'x')).starts_with(std::string("\x02\x01\0\0x", 5)));
}

TEST_CASE("texts come together from pieces of any size, and no byte behind them is wanted") {
    for (const std::size_t length : {min_message, std::size_t{1000}, max_message}) {
        const std::string text(length, 'a');
        const std::string bytes = framed(text);
        for (const std::size_t piece : {std::size_t{1}, std::size_t{3}, bytes.size()}) {
            FrameReader reader;
            CHECK(reader.is_fresh());
            std::size_t at = 0;
            while (reader.state() == State::unfinished) {
                const std::size_t part = std::min(piece, reader.wanted());
                REQUIRE(part > 0);
                reader.feed(std::string_view(bytes).substr(at, part));
                at += part;
            }
            CHECK(at == bytes.size());
            CHECK(reader.state() == State::complete);
            CHECK(reader.wanted() == 0);
            CHECK(reader.take() == text);
            CHECK(reader.is_fresh());
            CHECK(reader.wanted() == 4);
        }
    }
}

TEST_CASE("lengths out of bounds break the reader before a byte of the text is taken") {
    for (const std::uint32_t length : {0U, 1U, 65537U, 0x80000000U, 0xFFFFFFFFU}) {
        FrameReader reader;
        CHECK(reader.feed(header(length)) == State::broken);
        CHECK(reader.wanted() == 0);
        CHECK(reader.feed("more") == State::broken);
    }
}

TEST_CASE("0, 1 and 3 bytes are unfinished") {
    for (const std::size_t count : {0U, 1U, 3U}) {
        FrameReader reader;
        CHECK(reader.feed(framed("{}").substr(0, count)) == State::unfinished);
        CHECK(reader.wanted() == 4 - count);
    }
}

TEST_CASE("no bytes in no pieces break the bounds") {
    std::minstd_rand random(3);
    for (int i = 0; i < 3'000; ++i) {
        std::string bytes;
        for (std::size_t n = random() % 40; n > 0; --n) {
            bytes += static_cast<char>(random() % 4 == 0 ? random() % 256 : 0);
        }
        bytes += random() % 2 == 0 ? framed(std::string(2 + random() % 300, 'b')) : "";
        FrameReader reader;
        for (std::size_t at = 0; at < bytes.size();) {
            const std::size_t part = 1 + random() % 7;
            reader.feed(std::string_view(bytes).substr(at, part));
            at += part;
            if (reader.state() == State::complete) {
                const std::string text = reader.take();
                CHECK(text.size() >= min_message);
                CHECK(text.size() <= max_message);
            }
            CHECK(reader.wanted() <= max_message);
        }
    }
}
