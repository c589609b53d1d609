// SPDX-License-Identifier: MIT
#include "daemon/headless/confinement.h"

#include <fmt/format.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

Result<void> failed(const char* what, int error) {
    return failure(fmt::format("cannot confine the script host: {}: {}", what, strerror(error)));
}

std::size_t mapped_now() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

Result<void> limit(__rlimit_resource resource, rlim_t most) {
    const rlimit both{most, most};
    if (::setrlimit(resource, &both) != 0) {
        return failed("setrlimit", errno);
    }
    return {};
}

struct ReleaseFilter {
    void operator()(void* filter) const { seccomp_release(filter); }
};

// What allocation, clocks, exceptions, abort() and the sanitizers need.
constexpr std::array harmless{
    SCMP_SYS(brk),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
    SCMP_SYS(futex),
    SCMP_SYS(getpid),
    SCMP_SYS(gettid),
    SCMP_SYS(madvise),
    SCMP_SYS(mremap),
    SCMP_SYS(munmap),
    SCMP_SYS(restart_syscall),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sched_yield),
    SCMP_SYS(sigaltstack),
};

Result<void> filter_calls(int wire) {
    const std::unique_ptr<void, ReleaseFilter> filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)));
    if (!filter) {
        return failed("seccomp_init", ENOMEM);
    }
    int error = 0;
    const auto allow = [&](int call, std::vector<scmp_arg_cmp> conditions = {}) {
        const auto count = static_cast<unsigned>(conditions.size());
        const int result =
            seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, count, conditions.data());
        error = error == 0 ? result : error;
    };
    for (const int call : harmless) {
        allow(call);
    }
    const scmp_arg_cmp is_wire{0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(wire), 0};
    allow(SCMP_SYS(read), {is_wire});
    allow(SCMP_SYS(write), {is_wire});
    const scmp_arg_cmp is_data{2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0};
    allow(SCMP_SYS(mmap), {is_data});
    allow(SCMP_SYS(mprotect), {is_data});
    // abort()
    const scmp_arg_cmp is_self{0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()), 0};
    allow(SCMP_SYS(tgkill), {is_self});
    error = error == 0 ? seccomp_load(filter.get()) : error;
    if (error != 0) {
        return failed("seccomp", -error);
    }
    return {};
}

}  // namespace

Result<void> confine(const Cage& cage) {
    const std::pair<__rlimit_resource, rlim_t> limits[] = {
        {RLIMIT_AS, mapped_now() + cage.more_memory},
        {RLIMIT_CORE, 0},
        {RLIMIT_FSIZE, 0},
        {RLIMIT_NPROC, 0},
        {RLIMIT_NOFILE, 0},  // those that are open stay so
    };
    for (const auto& [resource, most] : limits) {
        if (const Result<void> limited = limit(resource, most); !limited) {
            return limited;
        }
    }
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        return failed("no_new_privs", errno);
    }
    return filter_calls(cage.wire);
}

}  // namespace hyrax
