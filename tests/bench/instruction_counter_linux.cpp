// SPDX-License-Identifier: MIT
#include "tests/bench/instruction_counter.h"

#include <linux/perf_event.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax::bench {

// Valgrind finds both by their names. Without the barriers GCC would make a jump of the call in the
// one, which ends the counting too early, and nothing of the call of the other.
[[gnu::noinline]] void counted_block(const Work& work) {
    work();
    asm volatile("" ::: "memory");
}
[[gnu::noinline]] void end_of_count() {
    asm volatile("" ::: "memory");
}

namespace {

// Closes what perf_event_open gave.
class Counter {
public:
    explicit Counter(int file) : file_(file) {}
    ~Counter() { ::close(file_); }
    Counter(const Counter&) = delete;
    Counter& operator=(const Counter&) = delete;

    double count(const Work& work) const {
        ::ioctl(file_, PERF_EVENT_IOC_RESET, 0);
        ::ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
        work();
        ::ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
        std::uint64_t instructions = 0;
        const ssize_t size = ::read(file_, &instructions, sizeof instructions);
        return size == sizeof instructions ? static_cast<double>(instructions)
                                           : std::numeric_limits<double>::quiet_NaN();
    }

private:
    int file_;
};

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "hyrax-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) != nullptr) {
            path_ = name;
        }
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

bool run(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", 1, 0);
    pid_t child = 0;
    const int failed = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    return failed == 0 && ::waitpid(child, &status, 0) == child && status == 0;
}

// The sum that callgrind writes at the end of each file.
double total_of(const std::filesystem::path& file) {
    constexpr std::string_view label = "totals: ";
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(label)) {
            return std::strtod(line.c_str() + label.size(), nullptr);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

InstructionCounter hardware_counter() {
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
    attributes.disabled = 1;
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    const long file = ::syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0UL);
    if (file < 0) {
        return {};
    }
    const auto counter = std::make_shared<Counter>(static_cast<int>(file));
    return [counter](const Work& work) { return counter->count(work); };
}

InstructionCounter valgrind_counter(int argc, const char* const* argv) {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "counts").string();
    std::vector<std::string> arguments{
        "valgrind",
        "--tool=callgrind",
        "--log-file=/dev/null",
        "--toggle-collect=hyrax::bench::counted_block*",
        "--dump-before=hyrax::bench::end_of_count*",
        "--callgrind-out-file=" + out,
        std::filesystem::read_symlink("/proc/self/exe").string(),
        inside_valgrind_flag
    };
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    if (!run(arguments)) {
        return {};
    }
    std::vector<double> counts;
    for (int number = 1;; ++number) {
        const std::string file = out + "." + std::to_string(number);
        if (!std::filesystem::exists(file)) {
            break;
        }
        counts.push_back(total_of(file));
    }
    if (counts.empty()) {
        return {};
    }
    return [counts, next = std::size_t{0}](const Work&) mutable {
        return next < counts.size() ? counts[next++] : std::numeric_limits<double>::quiet_NaN();
    };
}

InstructionCounter counted_by_valgrind() {
    return [](const Work& work) {
        counted_block(work);
        end_of_count();
        return 0.0;
    };
}

}  // namespace hyrax::bench
