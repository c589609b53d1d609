// SPDX-License-Identifier: MIT
// Real scripts in a real process. Wine neither enforces nor reads back the job's limits and the
// integrity level: those are looked at on Windows alone.
#include "daemon/win32/child_process.h"

#include "daemon/core/remote_script_host.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/process.h"
#include "tests/support/attack_corpus.h"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

struct World {
    ChildProcess* channel = nullptr;
    std::unique_ptr<RemoteScriptHost> host;
    ScriptWorld world;
    std::vector<ScriptCommand> commands;
    std::string log;
    std::map<std::string, std::string> errors;  // By script, one a line.

    World() {
        auto process = std::make_unique<ChildProcess>(find_folders().value().program / "hyrax.exe");
        channel = process.get();
        host = std::make_unique<RemoteScriptHost>(std::move(process));
        world.kinds = {{"hyrax", {100, 80}}};
        world.monitors = {{{0, 0, 1920, 1080}, {0, 0, 1920, 1080}, true, "one"}};
    }

    void frame() {
        world.now += ticks_per_second / 60;
        host->watch(clock_now());
        if (!host->busy()) {
            host->run(world, {});
        }
        if (auto output = host->take_output()) {
            commands.insert(commands.end(), output->commands.begin(), output->commands.end());
            for (const ScriptLog& line : output->log) {
                log += line.text + "\n";
                if (line.level == LogLevel::error) {
                    errors[line.script] += line.text + "\n";
                }
            }
        }
    }
    // Frames until something is so, at most some 20 seconds; each waits for the event at most.
    template <typename Condition>
    bool until(Condition condition) {
        for (int i = 0; i < 1'000 && !condition(); ++i) {
            frame();
            ::WaitForSingleObject(channel->event(), 20);
        }
        return condition();
    }
};

}  // namespace

TEST_CASE("scripts run in a process of their own and their commands come back") {
    World world;
    world.host->load({{"a.lua", "hyrax.spawn{} print('here')"}});
    CHECK(world.until([&] { return !world.commands.empty(); }));
    CHECK(world.log == "here\n");
    CHECK(world.channel->process() != nullptr);
    world.host->load({});
    CHECK(world.until([&] { return world.channel->process() == nullptr; }));
}

TEST_CASE("a pattern bomb is found out, the others go on") {
    World world;
    world.host->load({
        {"good.lua", "hyrax.every(0.05, function() print('tick') end)"},
        {"bad.lua", "local s = ('a'):rep(3000) s:find(('.-'):rep(10) .. 'b')"},
    });
    CHECK(world.until([&] { return world.log.contains("bad.lua: "); }));
    CHECK(world.log.contains("stopped until it is loaded again"));
    world.log.clear();
    CHECK(world.until([&] { return world.log.contains("tick"); }));
}

TEST_CASE("every attack ends as its first line says, in a process of its own") {
    const std::string honest = "hyrax.every(0.05, function() print('tick') end)";
    for (const Attack& attack : attacks()) {
        CAPTURE(attack.name);
        World world;
        world.host->load({{attack.name, attack.text}, {"last.lua", honest}});
        const bool quiet = attack.end == Attack::End::ok;
        CHECK(world.until([&] {
            return quiet ? world.log.contains("tick")
                         : ended_as_it_must(attack, world.errors[attack.name]);
        }));
        world.log.clear();
        CHECK(world.until([&] { return world.log.contains("tick"); }));
        CAPTURE(world.errors[attack.name]);
        CHECK(ended_as_it_must(attack, world.errors[attack.name]));
    }
}

TEST_CASE("the process is confined as far as the system lets it be read back") {
    World world;
    world.host->load({{"a.lua", "print('here')"}});
    REQUIRE(world.until([&] { return !world.log.empty(); }));

    BOOL inside = FALSE;
    CHECK(::IsProcessInJob(world.channel->process(), world.channel->job(), &inside));
    CHECK(inside);

    if (runs_under_wine()) {
        return;  // Wine 8 reads back neither limits (zeros) nor the token's label (its own, 0x3000)
    }
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    REQUIRE(::QueryInformationJobObject(
        world.channel->job(), JobObjectExtendedLimitInformation, &limits, sizeof limits, nullptr
    ));
    const DWORD flags = limits.BasicLimitInformation.LimitFlags;
    CHECK((flags & JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE) != 0);
    CHECK((flags & JOB_OBJECT_LIMIT_ACTIVE_PROCESS) != 0);
    CHECK((flags & JOB_OBJECT_LIMIT_PROCESS_MEMORY) != 0);

    HANDLE opened = nullptr;
    REQUIRE(::OpenProcessToken(world.channel->process(), TOKEN_QUERY, &opened));
    const KernelObject token(opened);
    std::vector<std::byte> room(256);
    DWORD size = 0;
    REQUIRE(::GetTokenInformation(
        token.raw(), TokenIntegrityLevel, room.data(), static_cast<DWORD>(room.size()), &size
    ));
    const auto* const label = reinterpret_cast<const TOKEN_MANDATORY_LABEL*>(room.data());
    CHECK(*::GetSidSubAuthority(label->Label.Sid, 0) == DWORD{SECURITY_MANDATORY_LOW_RID});
}

TEST_CASE("the process dies with its job, and its end is seen") {
    World world;
    world.host->load({{"a.lua", "print('here')"}});
    REQUIRE(world.until([&] { return !world.log.empty(); }));
    ::TerminateJobObject(world.channel->job(), 1);
    CHECK(world.until([&] { return world.log.contains("ended its process"); }));
    world.log.clear();
    CHECK(world.until([&] { return world.log.contains("here"); }));
}
