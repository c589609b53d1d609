// SPDX-License-Identifier: MIT
#include "daemon/core/nearest_name.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace hyrax;

namespace {

constexpr std::array<std::string_view, 7> names{
    "gravity", "restitution", "air_drag", "ground_friction", "rest_threshold", "vx", "x"
};

std::string nearest(std::string_view unknown) {
    return std::string(nearest_name(unknown, names).value_or("nothing"));
}

}  // namespace

TEST_CASE("nearest_name: one slip of each sort is found") {
    CHECK(nearest("gravitty") == "gravity");
    CHECK(nearest("gravty") == "gravity");
    CHECK(nearest("grabity") == "gravity");
    CHECK(nearest("gravity") == "gravity");
    CHECK(nearest("AIR_DRAG") == "air_drag");
    CHECK(nearest("air-drag") == "air_drag");
    CHECK(nearest("airDrag") == "air_drag");
    CHECK(nearest("vz") == "vx");
}

TEST_CASE("nearest_name: swapped neighbours count once") {
    // Three swaps are three edits of at most (7 + 1) / 3 = 2: too many. Two are just near enough,
    // and would be four if a swap counted twice.
    CHECK(nearest("rgaivty") == "gravity");
    CHECK(nearest("rgvaiyt") == "nothing");
}

TEST_CASE("nearest_name: what is too different is not guessed") {
    CHECK(nearest("") == "nothing");
    CHECK(nearest("y") == "nothing");
    CHECK(nearest("bounce") == "nothing");
    CHECK(nearest(std::string(1'000'000, 'g')) == "nothing");
    CHECK_FALSE(nearest_name("gravity", {}).has_value());
}

TEST_CASE("nearest_name: the first of several equally near names") {
    constexpr std::array<std::string_view, 3> equal{"vx", "vy", "vz"};
    CHECK(nearest_name("va", equal) == "vx");
}
