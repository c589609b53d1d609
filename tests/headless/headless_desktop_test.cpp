// SPDX-License-Identifier: MIT
// The recorder itself, the command lines and the picture files.
#include "daemon/headless/headless_desktop.h"

#include "daemon/control/command_line.h"
#include "daemon/headless/monitor_list.h"
#include "daemon/headless/png_file.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <cstddef>

using namespace hyrax;

TEST_CASE("the clock goes to the next input, the deadline or the end, whichever is first") {
    HeadlessDesktop desktop({}, 100);
    desktop.add({30, input::FilesChanged{}});
    desktop.add({20, input::MonitorsChanged{}});
    CHECK(desktop.wait(10).empty());
    CHECK(desktop.now() == 10);
    const std::vector<Input> first = desktop.wait(never);
    CHECK(desktop.now() == 20);
    REQUIRE(first.size() == 1);
    CHECK(std::holds_alternative<input::MonitorsChanged>(first[0]));
    CHECK(desktop.wait(never).size() == 1);
    CHECK(desktop.now() == 30);
    const std::vector<Input> last = desktop.wait(never);
    CHECK(desktop.now() == 100);
    REQUIRE(last.size() == 1);
    CHECK(std::holds_alternative<Request>(last[0]));
    CHECK(desktop.timer_wakeups() == 1);
}

TEST_CASE("monitors are read from text") {
    const auto two = parse_monitors("1920x1080+0+0,1600x900-1600-200@1.25");
    REQUIRE(two);
    REQUIRE(two->size() == 2);
    CHECK((*two)[0].bounds == Rect{0, 0, 1920, 1080});
    CHECK((*two)[0].primary);
    CHECK((*two)[1].bounds == Rect{-1600, -200, 1600, 900});
    CHECK_FALSE((*two)[1].primary);
    CHECK((*two)[0].scale == 1.0);
    CHECK((*two)[1].scale == 1.25);
    CHECK(parse_monitors("")->empty());
    for (const char* wrong :
         {"1920",
          "1920x",
          "1920x1080",
          "1920x1080+0",
          "0x100+0+0",
          "-5x100+0+0",
          "1920x1080+0+0x",
          "99999x1+0+0",
          "1x1+999999+0",
          "1920x1080++0+0",
          "1920x1080+0+0@",
          "1920x1080+0+0@1.5x",
          "1920x1080+0+0@9",
          "1920x1080+0+0@nan",
          ","}) {
        CAPTURE(wrong);
        const auto refused = parse_monitors(wrong);
        REQUIRE_FALSE(refused);
        CHECK(refused.error().message.contains("expected WIDTHxHEIGHT+X+Y"));
    }
}

TEST_CASE("a picture survives a PNG file, premultiplied to within rounding") {
    const TemporaryFolder folder;
    Image image(Size{3, 2});
    image.pixels = {0xff112233U, 0x80402000U, 0U, 0xffffffffU, 0x08080808U, 0xff000000U};
    const std::filesystem::path path = folder.path() / "picture.png";
    REQUIRE(write_png(path, image));
    const std::string bytes = folder.read("picture.png");
    const auto read = decode_png(std::as_bytes(std::span(bytes)));
    REQUIRE(read);
    CHECK(read->size == image.size);
    CHECK(read->pixels == image.pixels);

    CHECK_FALSE(write_png(folder.path() / "no" / "such" / "folder.png", image));
    const auto cut = decode_png(std::as_bytes(std::span(bytes)).first(bytes.size() / 2));
    REQUIRE_FALSE(cut);
    CHECK(cut.error().message.contains("PNG"));
}

TEST_CASE("command lines") {
    const auto parsed = parse_headless_arguments(
        {"--seconds",
         "2.5",
         "--fps",
         "144",
         "--script",
         "a.lua",
         "--script",
         "b.lua",
         "--monitors",
         "800x600+0+0",
         "--trace",
         "t.csv",
         "--for-testing",
         "--spawn",
         "4",
         "--fling-all"}
    );
    const auto* line = std::get_if<HeadlessCommandLine>(&parsed);
    REQUIRE(line != nullptr);
    CHECK(line->seconds == 2.5);
    CHECK(line->fps == 144.0);
    CHECK(line->scripts.size() == 2);
    CHECK(line->common.trace == "t.csv");
    CHECK(line->common.for_testing);
    REQUIRE(line->common.requests.size() == 2);
    CHECK(std::get<request::Spawn>(line->common.requests[0]).count == 4);

    const auto help = parse_daemon_arguments({"--help"});
    REQUIRE(std::holds_alternative<Farewell>(help));
    CHECK(std::get<Farewell>(help).exit_code == 0);
    CHECK(std::get<Farewell>(help).text.contains("--profile"));

    for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
             {"--spwan", "3"},
             {"--spawn", "0"},
             {"--spawn", "many"},
             {"--seconds", "nan"},
             {"stray"}
         }) {
        CAPTURE(wrong[0]);
        const auto answer = parse_headless_arguments(wrong);
        REQUIRE(std::holds_alternative<Farewell>(answer));
        CHECK(std::get<Farewell>(answer).exit_code == 2);
    }
}

TEST_CASE("command line: what the tray offers is offered here as well") {
    const auto parsed =
        parse_daemon_arguments({"--gather", "--hide", "--show", "--quiet", "on", "--autostart"});
    const auto* line = std::get_if<DaemonCommandLine>(&parsed);
    REQUIRE(line != nullptr);
    CHECK(line->autostart);
    const std::vector<Request>& requests = line->common.requests;
    REQUIRE(requests.size() == 4);
    CHECK(std::holds_alternative<request::Gather>(requests[0]));
    CHECK(std::holds_alternative<request::Hide>(requests[1]));
    CHECK(std::holds_alternative<request::Show>(requests[2]));
    CHECK(std::holds_alternative<request::SetQuiet>(requests[3]));
    for (const bool quiet : {true, false}) {
        const auto one = parse_daemon_arguments({"--quiet", quiet ? "on" : "off"});
        REQUIRE(std::holds_alternative<DaemonCommandLine>(one));
        const auto& asked = std::get<DaemonCommandLine>(one).common.requests.at(0);
        CHECK(std::get<request::SetQuiet>(asked).quiet == quiet);
    }
    const auto through = parse_daemon_arguments({"--click-through", "on"});
    REQUIRE(std::holds_alternative<DaemonCommandLine>(through));
    const std::vector<Request>& wish = std::get<DaemonCommandLine>(through).common.requests;
    CHECK(std::get<request::SetClickThrough>(wish.at(0)).on);
    const auto wrong = parse_daemon_arguments({"--quiet", "perhaps"});
    REQUIRE(std::holds_alternative<Farewell>(wrong));
    CHECK(std::get<Farewell>(wrong).exit_code == 2);
    CHECK(std::get<Farewell>(wrong).text.contains("on"));
}
