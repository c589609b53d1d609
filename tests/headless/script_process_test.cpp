// SPDX-License-Identifier: MIT
// Real scripts in a real process, hostile ones among them, while an engine goes on. The daemon's
// side waits nowhere but in Scene::until, which gives the other process time.
#include "daemon/core/remote_script_host.h"
#include "daemon/core/script_bridge.h"
#include "daemon/headless/child_process.h"
#include "daemon/headless/confinement.h"
#include "tests/support/attack_corpus.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <sstream>

using namespace hyrax;

namespace {

using Sources = std::vector<ScriptSource>;

constexpr std::size_t pets = 50;
const std::string honest = "hyrax.every(0.05, function() print('tick') end)";
const std::string bomb = "local s = ('a'):rep(3000) s:find(('.-'):rep(10) .. 'b')";

// What a log would hold, while it lives.
class Log {
public:
    Log() : before_(spdlog::default_logger()) {
        auto sink = std::make_shared<spdlog::sinks::ostream_sink_st>(text_);
        auto logger = std::make_shared<spdlog::logger>("test", std::move(sink));
        logger->set_pattern("%l %v");
        spdlog::set_default_logger(std::move(logger));
    }
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;
    ~Log() { spdlog::set_default_logger(before_); }

    std::string text() const { return text_.str(); }
    bool has(std::string_view part) const { return text().contains(part); }
    void forget() { text_.str(""); }
    // Errors that begin with this name, without the level.
    std::string errors_of(const std::string& script) const {
        std::istringstream lines(text());
        std::string found;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("error " + script + ":")) {
                found += line.substr(6) + "\n";
            }
        }
        return found;
    }
    long count(std::string_view part) const {
        const std::string all = text();
        long found = 0;
        for (std::size_t at = all.find(part); at != std::string::npos;
             at = all.find(part, at + 1)) {
            ++found;
        }
        return found;
    }

private:
    std::shared_ptr<spdlog::logger> before_;
    std::ostringstream text_;
};

Ticks machine_now() {
    return std::chrono::steady_clock::now().time_since_epoch().count();
}

struct Scene {
    explicit Scene(std::vector<ScriptSource> sources) {
        engine.set_arena(
            Arena({{{0, 0, 1920, 1080}, {0, 0, 1920, 1080}, true, {}}}, FloorEdge::screen)
        );
        for (std::size_t i = 0; i < pets; ++i) {
            REQUIRE(engine.spawn({}));
        }
        bridge.load(std::move(sources));
    }

    void frame() {
        now += ticks_per_second / 60;
        ++frames;
        bridge.watch(machine_now());
        engine.advance(now);
        bridge.run(engine, {}, now);
    }
    // Frames, with a moment for the other process after each, until something is so; at most about
    // a minute.
    bool until(const std::function<bool()>& condition) {
        for (int i = 0; i < 30'000 && !condition(); ++i) {
            frame();
            if (!process->wait(std::chrono::milliseconds(2))) {
                ::usleep(2'000);
            }
        }
        return condition();
    }

    Log log;
    ChildProcess* process = nullptr;
    RemoteScriptHost* host = nullptr;
    Engine engine{{{"hyrax", {100, 80}}}, {.max_pets = 200}, 1};
    ScriptBridge bridge{make_host()};
    Ticks now = 0;
    int frames = 0;

private:
    std::unique_ptr<ScriptHost> make_host() {
        auto channel = std::make_unique<ChildProcess>(HYRAX_HEADLESS_PROGRAM);
        process = channel.get();
        auto remote = std::make_unique<RemoteScriptHost>(std::move(channel));
        host = remote.get();
        return remote;
    }
};

bool no_children() {
    return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

int rounds(const char* variable, int usual) {
    const char* const given = std::getenv(variable);
    return given == nullptr ? usual : std::atoi(given);
}

// Runs the body in a forked process; its result is the exit code.
int forked(const std::function<int()>& body) {
    const pid_t pid = ::fork();
    if (pid == 0) {
        ::_exit(body());
    }
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

TEST_CASE("what a developer asks is answered by the process, or by its end") {
    Scene scene({{"a.lua", "count = 3"}, {"b.lua", ""}});
    const auto answer = [&scene](const char* script, const std::string& text) {
        scene.bridge.evaluate(script, text);
        std::vector<Evaluated> answers;
        REQUIRE(scene.until([&] {
            for (Evaluated& each : scene.bridge.take_evaluated()) {
                answers.push_back(std::move(each));
            }
            return !answers.empty();
        }));
        return answers.front();
    };
    CHECK(answer("a.lua", "count, 'x'").text == "3, \"x\"");
    CHECK(answer("a.lua", "nope.x").text.starts_with("eval:1: "));
    CHECK(answer("a.lua", "print 'hello'").printed == "hello\n");
    const Evaluated hung = answer("b.lua", bomb);
    CHECK_FALSE(hung.good);
    CHECK(hung.text.starts_with("b.lua: "));
    CHECK(scene.bridge.ended() == std::vector<std::string>{"b.lua"});
    CHECK(answer("b.lua", "1").text == "b.lua does not run");
    CHECK(answer("a.lua", "count").text == "3");
}

TEST_CASE("scripts in a process of their own move pets; no script, no process") {
    {
        Scene scene(Sources{{"a.lua", "hyrax.spawn{tag='mine'} hyrax.on('land', print)"}});
        CHECK(scene.process->id() == 0);
        CHECK(scene.until([&] { return scene.engine.size() == pets + 1; }));
        CHECK(scene.process->id() != 0);
        CHECK(scene.until([&] { return scene.log.has("a.lua: "); }));
        scene.bridge.load({});
        CHECK(scene.until([&] { return scene.process->id() == 0; }));
        CHECK(scene.engine.size() == pets + 1);
    }
    CHECK(no_children());
}

TEST_CASE("every attack ends as its first line says, in a process of its own") {
    for (const Attack& attack : attacks()) {
        CAPTURE(attack.name);
        Scene scene(Sources{{"first.lua", honest}, {attack.name, attack.text}, {"last.lua", honest}}
        );
        const auto errors = [&] { return scene.log.errors_of(attack.name); };
        const bool quiet = attack.end == Attack::End::ok;
        CHECK(scene.until([&] {
            return quiet ? scene.log.has("last.lua: tick") : ended_as_it_must(attack, errors());
        }));
        scene.log.forget();
        CHECK(scene.until([&] { return scene.log.has("first.lua: tick"); }));
        CHECK(scene.until([&] { return scene.log.has("last.lua: tick"); }));
        CAPTURE(errors());
        CHECK(errors().empty());
        CHECK(scene.engine.size() >= pets);
    }
    CHECK(no_children());
}

TEST_CASE("the end is heard in a process of its own, and costs little when scripts hang") {
    const std::string keeps =
        "hyrax.on('unload', function(why) hyrax.store.set('why', why) print(why) end)";
    Scene good(Sources{{"good.lua", honest + " " + keeps}});
    REQUIRE(good.until([&] { return good.log.has("good.lua: tick"); }));
    good.bridge.end(good.engine, {}, {good.now, machine_now()}, std::chrono::seconds(30));
    CHECK(good.log.has("good.lua: exit"));
    const auto wishes = good.bridge.take_wishes();
    REQUIRE(wishes.size() == 1);
    CHECK(std::get<command::Store>(wishes[0]).value == ScriptValue{std::string("exit")});

    Scene bad(Sources{{"bad.lua", bomb}});
    bad.frame();
    bad.bridge.end(bad.engine, {}, {bad.now, machine_now()}, std::chrono::milliseconds(20));
    CHECK(bad.bridge.take_wishes().empty());
}

TEST_CASE("frames go on while a script hangs in one library call") {
    Scene scene(Sources{{"bad.lua", bomb}});
    scene.frame();
    while (scene.frames < 600) {
        scene.frame();  // never waits for anybody
    }
    CHECK(scene.engine.size() == pets);
    CHECK(scene.now == 600 * (ticks_per_second / 60));
    CHECK(scene.until([&] { return scene.log.has("error bad.lua: gave no sign of life"); }));
    CHECK(scene.process->id() == 0);
}

TEST_CASE("a hundred scripts, ten of them hostile") {
    std::vector<ScriptSource> sources;
    for (int i = 0; i < 100; ++i) {
        sources.push_back({
            "s" + std::to_string(i) + ".lua",
            i % 10 == 3
                ? bomb
                : "hyrax.every(0.05, function() print('tick " + std::to_string(i) + ".') end)",
        });
    }
    Scene scene(std::move(sources));
    CHECK(scene.until([&] { return scene.log.count("gave no sign of life") == 10; }));
    for (int i = 0; i < 100; ++i) {
        const std::string name = "s" + std::to_string(i) + ".lua";
        CHECK(scene.log.errors_of(name).empty() == (i % 10 != 3));
    }
    scene.log.forget();
    CHECK(scene.until([&] { return scene.log.has("tick 0.") && scene.log.has("tick 99."); }));
    CHECK(scene.engine.size() == pets);
}

// HYRAX_KILL_ROUNDS=200 makes it long.
TEST_CASE("a process that is killed at any moment comes back, and no pet is lost") {
    {
        Scene scene(Sources{{"a.lua", honest}, {"b.lua", "hyrax.every(0.01, function() end)"}});
        std::mt19937 source(7);
        const auto below = [&source](unsigned end) {
            return static_cast<unsigned>(source()) % end;
        };
        for (int i = rounds("HYRAX_KILL_ROUNDS", 20); i > 0; --i) {
            REQUIRE(scene.until([&] { return scene.log.has("a.lua: tick"); }));
            for (unsigned frames = below(6); frames > 0; --frames) {
                scene.frame();
                ::usleep(below(2'000));
            }
            if (scene.process->id() != 0) {
                ::kill(scene.process->id(), SIGKILL);
            }
            scene.log.forget();
        }
        CHECK(scene.until([&] { return scene.log.has("a.lua: tick"); }));
        CHECK_FALSE(scene.log.has("error"));
        CHECK(scene.engine.size() == pets);
    }
    CHECK(no_children());
}

TEST_CASE("a process whose daemon dies dies with it, though it hangs") {
    auto* const child = static_cast<std::atomic<pid_t>*>(::mmap(
        nullptr,
        sizeof(std::atomic<pid_t>),
        PROT_READ | PROT_WRITE,
        MAP_SHARED | MAP_ANONYMOUS,
        -1,
        0
    ));
    REQUIRE(child != MAP_FAILED);
    const int result = forked([child] {
        Scene scene(Sources{{"bad.lua", bomb}});
        scene.frame();
        scene.until([&] { return scene.process->pulse().script.load() != 0; });
        *child = scene.process->id();
        ::raise(SIGKILL);
        return 0;
    });
    CHECK(result == -SIGKILL);
    REQUIRE(*child > 0);
    // It is nobody's child of ours: gone once its id is unknown, or a zombie of another's.
    bool gone = false;
    for (int i = 0; i < 500 && !gone; ++i) {
        std::string state;
        std::ifstream file("/proc/" + std::to_string(child->load()) + "/stat");
        file >> state >> state >> state;
        gone = !file || state == "Z" || state == "X";
        ::usleep(10'000);
    }
    CHECK(gone);
    ::munmap(child, sizeof *child);
}

TEST_CASE("inside its cage a process opens, starts and signals nothing") {
    const int failures = forked([] {
        int pipe[2] = {-1, -1};
        if (::pipe(pipe) != 0 || !confine({.wire = pipe[1]})) {
            return 100;
        }
        int wrong = 0;
        const auto refused = [&wrong](long result) {
            wrong += result == -1 && errno == EPERM ? 0 : 1;
        };
        refused(::open("/etc/passwd", O_RDONLY));
        refused(::open("/tmp/hyrax-cage", O_CREAT | O_WRONLY, 0600));
        refused(::socket(AF_INET, SOCK_STREAM, 0));
        refused(::socket(AF_UNIX, SOCK_STREAM, 0));
        refused(::fork());
        char* const arguments[] = {nullptr};
        refused(::execve("/bin/true", arguments, arguments));
        refused(::kill(::getppid(), 0));
        refused(::unlink("/tmp/hyrax-cage"));
        refused(::write(pipe[0], "x", 1));
        refused(::dup(pipe[1]));
        void* const code =
            ::mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        wrong += code == MAP_FAILED ? 0 : 1;
        // What is left: the wire, memory up to the cap.
        wrong += ::write(pipe[1], "x", 1) == 1 ? 0 : 1;
        void* const some =
            ::mmap(nullptr, 1U << 20U, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        void* const much =
            ::mmap(nullptr, 1UL << 31U, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        wrong += some != MAP_FAILED && much == MAP_FAILED ? 0 : 1;
        return wrong;
    });
    CHECK(failures == 0);
}
