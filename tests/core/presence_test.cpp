// SPDX-License-Identifier: MIT
// Who is in the way of whom: every row of the policy.
#include "daemon/core/presence.h"

#include <doctest/doctest.h>

#include <limits>

using namespace hyrax;

namespace {

constexpr Rect main_bounds{0, 0, 1920, 1080};
constexpr Rect main_work{0, 0, 1920, 1040};
constexpr Rect side_bounds{1920, 0, 1280, 1024};

const Monitor main_monitor{
    .bounds = main_bounds, .work = main_work, .primary = true, .name = "main", .refresh_rate = 60
};
// Without a taskbar.
const Monitor side_monitor{
    .bounds = side_bounds, .work = side_bounds, .name = "side", .refresh_rate = 144
};

FrontWindow window(const Rect& bounds, std::string program = {}) {
    return {.bounds = bounds, .window_class = "Player", .program = std::move(program)};
}

Facts in_front(const FrontWindow& front) {
    return {.windows = {front}, .first_is_front = true};
}

constexpr Ticks ms = ticks_per_ms;

struct World {
    explicit World(PresenceSettings settings = {}) {
        presence.set_settings(std::move(settings));
        presence.set_monitors(std::vector{main_monitor, side_monitor});
    }
    const Decisions& tell(const Facts& facts, Ticks now) {
        presence.set_facts(facts);
        return presence.decide(now);
    }
    /// Once it has lasted.
    const Decisions& told(const Facts& facts) {
        tell(facts, 0);
        return presence.decide(60'000 * ms);
    }
    Presence presence;
};

using Rects = std::vector<Rect>;

}  // namespace

TEST_CASE("a window fills a monitor that it covers, taskbar and all") {
    CHECK(fills(window(main_bounds), main_monitor));
    CHECK(fills(window({-8, -8, 1936, 1096}), main_monitor));
    CHECK(fills(window({0, 0, 3200, 1080}), side_monitor));
    CHECK_FALSE(fills(window(main_work), main_monitor));
    CHECK_FALSE(fills(window({0, 1, 1920, 1079}), main_monitor));
    CHECK_FALSE(fills(window(main_bounds), side_monitor));
    CHECK_FALSE(fills(window({}), main_monitor));
}

TEST_CASE("maximised windows fill no monitor, even where no taskbar keeps room") {
    Monitor hiding = main_monitor;  // an auto-hide taskbar
    hiding.work = hiding.bounds;
    FrontWindow maximised = window(main_bounds);
    maximised.maximised = true;
    CHECK_FALSE(fills(maximised, hiding));
    FrontWindow captioned = window({-8, -8, 1936, 1096});
    captioned.captioned = true;
    CHECK_FALSE(fills(captioned, hiding));
    CHECK(fills(window(main_bounds), hiding));
    // Over a taskbar no maximised window goes.
    CHECK(fills(maximised, main_monitor));
}

TEST_CASE("the shell, hidden and cloaked windows fill nothing") {
    for (const char* name :
         {"Progman",
          "WorkerW",
          "Shell_TrayWnd",
          "Shell_SecondaryTrayWnd",
          "Windows.UI.Core.CoreWindow"}) {
        CAPTURE(name);
        FrontWindow shell = window(main_bounds);
        shell.window_class = name;
        CHECK_FALSE(fills(shell, main_monitor));
    }
    FrontWindow gone = window(main_bounds);
    gone.visible = false;
    CHECK_FALSE(fills(gone, main_monitor));
    FrontWindow cloaked = window(main_bounds);
    cloaked.cloaked = true;
    CHECK_FALSE(fills(cloaked, main_monitor));
}

TEST_CASE("a monitor is left after 300 ms of a full screen and used again after a second") {
    World world;
    const Facts film = in_front(window(side_bounds));
    CHECK(world.tell(film, 1000 * ms).kept_free.empty());
    CHECK(world.presence.due() == 1300 * ms);
    CHECK(world.presence.wary());
    CHECK(world.presence.decide(1299 * ms).kept_free.empty());
    CHECK(world.presence.decide(1300 * ms).kept_free == Rects{side_bounds});
    CHECK(world.presence.decisions().frozen == Rects{side_bounds});
    CHECK_FALSE(world.presence.decisions().note.empty());
    CHECK(world.presence.due() == never);
    CHECK(world.presence.wary());

    CHECK(world.tell({}, 5000 * ms).kept_free == Rects{side_bounds});
    CHECK(world.presence.due() == 6000 * ms);
    CHECK(world.presence.decide(5999 * ms).kept_free == Rects{side_bounds});
    CHECK(world.presence.decide(6000 * ms) == World().told({}));
    CHECK_FALSE(world.presence.wary());
    CHECK(world.presence.due() == never);
}

TEST_CASE("what does not last changes nothing") {
    World world;
    const Facts film = in_front(window(side_bounds));
    for (Ticks time = 0; time < 5000 * ms; time += 400 * ms) {
        CHECK(world.tell(film, time).kept_free.empty());
        CHECK(world.tell({}, time + 200 * ms).kept_free.empty());
    }
    world.told(film);
    for (Ticks time = 60'000 * ms; time < 65'000 * ms; time += 1000 * ms) {
        CHECK(world.tell({}, time).kept_free == Rects{side_bounds});
        CHECK(world.tell(film, time + 900 * ms).kept_free == Rects{side_bounds});
    }
}

TEST_CASE("hide, pause and stay") {
    const Facts game = in_front(window(main_bounds));
    const Decisions hide = World({.full_screen = FullScreenAct::hide}).told(game);
    CHECK(hide.kept_free == Rects{main_bounds});
    CHECK(hide.frozen == Rects{main_bounds});
    const Decisions pause = World({.full_screen = FullScreenAct::pause}).told(game);
    CHECK(pause.kept_free.empty());
    CHECK(pause.frozen == Rects{main_bounds});
    const Decisions stay = World({.full_screen = FullScreenAct::stay}).told(game);
    CHECK(stay.kept_free.empty());
    CHECK(stay.frozen.empty());
    CHECK(stay.note.empty());
}

TEST_CASE("a window over two monitors fills both") {
    const Decisions both = World().told(in_front(window({0, 0, 3200, 1080})));
    CHECK(both.kept_free == Rects{main_bounds, side_bounds});
}

TEST_CASE("a film keeps its screen while the user works on another one") {
    const FrontWindow film = window(side_bounds);
    const FrontWindow editor = window({100, 100, 800, 600});
    World world;
    CHECK(
        world.told({.windows = {editor, film}, .first_is_front = true}).kept_free ==
        Rects{side_bounds}
    );
    // Below a window that was called on its own screen it does not.
    const FrontWindow before_it = window({2000, 100, 800, 600});
    CHECK(World().told({.windows = {before_it, film}, .first_is_front = true}).kept_free.empty());
    // While the user is with us, with nobody or with the shell, it goes on.
    CHECK(World().told({.windows = {film}}).kept_free == Rects{side_bounds});
    FrontWindow desk = window({0, 0, 3200, 1080});
    desk.window_class = "Progman";
    CHECK(
        World().told({.windows = {desk, film}, .first_is_front = true}).kept_free ==
        Rects{side_bounds}
    );
}

TEST_CASE("what the shell says counts only where it can be trusted") {
    CHECK(World().told({.shell = ShellState::busy}) == World().told({}));
    const FrontWindow game = window({2000, 10, 800, 600});
    Facts exclusive = in_front(game);
    exclusive.shell = ShellState::exclusive;
    CHECK(World().told(exclusive).kept_free == Rects{side_bounds});
    CHECK(World().told({.shell = ShellState::exclusive}).kept_free == Rects{main_bounds});
    CHECK(
        World().told({.shell = ShellState::presenting}).kept_free == Rects{main_bounds, side_bounds}
    );
    CHECK(World({.full_screen = FullScreenAct::stay})
              .told({.shell = ShellState::presenting})
              .kept_free.empty());
}

TEST_CASE("rules for programs") {
    const PresenceSettings settings{
        .full_screen = FullScreenAct::hide,
        .rules =
            {
                {"Player.exe", FullScreenAct::stay},
                {"still.exe", FullScreenAct::pause},
                {"guarded.exe", FullScreenAct::hide_everywhere},
            }
    };
    CHECK(World(settings).presence.asks_for_programs());
    CHECK_FALSE(World().presence.asks_for_programs());
    CHECK(World(settings).told(in_front(window(main_bounds, "player.EXE"))).frozen.empty());
    const Decisions still = World(settings).told(in_front(window(main_bounds, "still.exe")));
    CHECK(still.frozen == Rects{main_bounds});
    CHECK(still.kept_free.empty());
    CHECK(
        World(settings).told(in_front(window(main_bounds, "other.exe"))).kept_free ==
        Rects{main_bounds}
    );
    CHECK(World(settings).told(in_front(window(main_bounds))).kept_free == Rects{main_bounds});

    SUBCASE("hide_everywhere holds at once, whatever the size of the window, and for a second more"
    ) {
        World world(settings);
        const Decisions& guarded =
            world.tell(in_front(window({100, 100, 640, 480}, "guarded.exe")), 1000 * ms);
        CHECK(guarded.windowless);
        CHECK(guarded.world_stands);
        CHECK(guarded.note.contains("guarded.exe"));
        CHECK(world.tell({}, 2000 * ms).windowless);
        CHECK(world.presence.due() == 3000 * ms);
        CHECK_FALSE(world.presence.decide(3000 * ms).windowless);
    }
}

TEST_CASE("frames: fewer on battery, fewest when saving") {
    CHECK(World().told({}).fps == std::numeric_limits<double>::infinity());
    CHECK(World().told({.on_battery = true}).fps == 30.0);
    CHECK(World().told({.on_battery = true, .battery_saver = true}).fps == 15.0);
    CHECK(World().told({.battery_saver = true}).fps == 15.0);
    CHECK(World().told({.remote_session = true}).fps == 15.0);
}

TEST_CASE("frames: no more than the fastest screen shows that has pets") {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const Rect on_main{main_bounds.x + 10, main_bounds.y + 10, 96, 96};
    const Rect on_side{side_bounds.x + 10, side_bounds.y + 10, 96, 96};
    World world;
    CHECK(world.presence.least_refresh_rate() == 60.0);
    CHECK(world.presence.refresh_rate_at({}) == unlimited);
    CHECK(world.presence.refresh_rate_at(Rects{on_main}) == 60.0);
    CHECK(world.presence.refresh_rate_at(Rects{on_side}) == 144.0);
    CHECK(world.presence.refresh_rate_at(Rects{on_main, on_side}) == 144.0);
    // The fast screen shows a game.
    world.told(in_front(window(side_bounds)));
    CHECK(world.presence.refresh_rate_at(Rects{on_main, on_side}) == 60.0);

    Presence ntsc;
    Monitor monitor = main_monitor;
    monitor.refresh_rate = 59;
    ntsc.set_monitors(std::vector{monitor});
    CHECK(ntsc.refresh_rate_at(Rects{on_main}) == 60.0);
    CHECK(ntsc.least_refresh_rate() == 60.0);
    monitor.refresh_rate = 75;
    ntsc.set_monitors(std::vector{monitor});
    CHECK(ntsc.refresh_rate_at(Rects{on_main}) == 75.0);
    for (const int unknown : {0, 1}) {
        monitor.refresh_rate = unknown;
        ntsc.set_monitors(std::vector{monitor});
        CHECK(ntsc.refresh_rate_at(Rects{on_main}) == unlimited);
        CHECK(ntsc.least_refresh_rate() == unlimited);
    }
}

TEST_CASE("an unseen session draws nothing; its time stands still or goes on") {
    for (const Facts& facts :
         {Facts{.locked = true},
          Facts{.disconnected = true},
          Facts{.display_off = true},
          Facts{.suspended = true}}) {
        const Decisions still = World().told(facts);
        CHECK(still.unseen);
        CHECK(still.world_stands);
        const Decisions running = World({.on_resume = OnResume::catch_up}).told(facts);
        CHECK(running.unseen);
        CHECK_FALSE(running.world_stands);
    }
    CHECK_FALSE(World().told({}).unseen);
    CHECK_FALSE(World().told({}).world_stands);
}

TEST_CASE("reduced motion, by the system's word or the user's") {
    CHECK_FALSE(World().told({}).calm);
    CHECK(World().told({.animations = false}).calm);
    CHECK(World().told({.animations = false}).note.contains("reduced motion"));
    CHECK(World({.reduced_motion = ReducedMotion::on}).told({}).calm);
    CHECK_FALSE(World({.reduced_motion = ReducedMotion::off}).told({.animations = false}).calm);
}

TEST_CASE("a monitor that stays keeps its state when others come and go") {
    World world;
    world.told(in_front(window(side_bounds)));
    world.presence.set_monitors(std::vector{side_monitor});
    CHECK(world.presence.decide(60'001 * ms).kept_free == Rects{side_bounds});
    world.presence.set_monitors(std::vector{main_monitor});
    CHECK(world.presence.decide(60'002 * ms).kept_free.empty());
    world.presence.set_monitors({});
    CHECK(world.presence.decide(60'003 * ms).kept_free.empty());
}
