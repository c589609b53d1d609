// SPDX-License-Identifier: MIT
#include "daemon/headless/window_list.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

using namespace hyrax;

namespace {

std::string error_of(std::string_view text) {
    const auto parsed = parse_windows(text, "w.csv");
    REQUIRE_FALSE(parsed.has_value());
    return parsed.error().message;
}

}  // namespace

TEST_CASE("window list: the lines of one time are all windows from then on") {
    const auto parsed = parse_windows(
        "# two windows, then one, then none\r\n"
        "0, 7, -100,200,300,400, active\r\n"
        "0,8,1,2,3,4,hidden overlay  bar maximised\n"
        "\n"
        "1.5,8,10,20,30,40\n"
        "2",
        "w.csv"
    );
    REQUIRE(parsed.has_value());
    REQUIRE(parsed->size() == 3);
    CHECK((*parsed)[0].time == 0);
    REQUIRE((*parsed)[0].windows.size() == 2);
    CHECK(
        (*parsed)[0].windows[0] ==
        DesktopWindow{.id = 7, .bounds = {-100, 200, 300, 400}, .active = true}
    );
    CHECK(
        (*parsed)[0].windows[1] ==
        DesktopWindow{
            .id = 8,
            .bounds = {1, 2, 3, 4},
            .active = false,
            .visible = false,
            .solid = false,
            .has_caption = false,
            .maximised = true,
        }
    );
    CHECK((*parsed)[1].time == from_seconds(1.5));
    CHECK((*parsed)[1].windows.size() == 1);
    CHECK((*parsed)[2].windows.empty());
}

TEST_CASE("window list: mistakes are named with their line") {
    CHECK(
        error_of("0,1,0,0,9,9\nsoon,2,0,0,9,9") ==
        "w.csv:2: the time must be seconds from 0 to 1000000, got \"soon\""
    );
    CHECK(error_of("nan").starts_with("w.csv:1: the time must be"));
    CHECK(error_of("-1").starts_with("w.csv:1: the time must be"));
    CHECK(error_of("2\n1") == "w.csv:2: times may not go back: 1 after 2");
    CHECK(error_of("0,x,0,0,9,9") == "w.csv:1: the window's id must be a whole number, got \"x\"");
    CHECK(
        error_of("0,1,0,0,9") == "w.csv:1: expected time,id,x,y,width,height with whole numbers of "
                                 "pixels, got \"\""
    );
    CHECK(error_of("0,1,0,0,-9,9").starts_with("w.csv:1: expected time,id,x,y,width,height"));
    CHECK(error_of("0,1,0,0,9,99999999").starts_with("w.csv:1: expected time,id,x,y,"));
    CHECK(
        error_of("0,1,0,0,9,9,active big") ==
        "w.csv:1: expected the words active, hidden, overlay, bar or maximised, got \"big\""
    );
}
