// SPDX-License-Identifier: MIT
#include "daemon/win32/argument_packing.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace hyrax::win32;

TEST_CASE("arguments come out as they went in") {
    const std::vector<std::vector<std::string>> lists{
        {}, {""}, {"", ""}, {"--spawn", "hyrax"}, {"a b", "\xC3\xB6\"\\", ""}
    };
    for (const auto& arguments : lists) {
        const auto packed = pack_arguments(arguments);
        REQUIRE(packed);
        CHECK(unpack_arguments(*packed) == arguments);
    }
}

TEST_CASE("too much is refused on both sides") {
    const std::vector<std::string> long_one{std::string(max_packed_arguments, 'x')};
    CHECK_FALSE(pack_arguments(long_one));
    CHECK_FALSE(unpack_arguments(std::string(max_packed_arguments + 1, '\0')));
}

TEST_CASE("a block that was cut off is refused") {
    CHECK_FALSE(unpack_arguments(std::string("no zero at the end")));
}
