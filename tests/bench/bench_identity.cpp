// SPDX-License-Identifier: MIT
#include "tests/bench/bench_identity.h"

#include "physics/batch.h"
#include "tests/support/batch_identity.h"

#include <fmt/format.h>

#include <cstdio>
#include <ostream>

namespace hyrax::bench {

bool identity(std::ostream& table, std::ostream& csv, std::uint64_t body_steps) {
    table << "| kernel | steps of a body | differ in a bit |\n| --- | --- | --- |\n";
    csv << "kernel,steps,differing\n";
    std::uint64_t all = 0;
    for (const Kernel kernel : available_kernels()) {
        fmt::print(stderr, "{}: {} steps\n", name(kernel), body_steps);
        const std::uint64_t differing = check_identity(kernel, body_steps);
        table << fmt::format("| {} | {} | {} |\n", name(kernel), body_steps, differing);
        csv << fmt::format("{},{},{}\n", name(kernel), body_steps, differing);
        all += differing;
    }
    return all == 0;
}

}  // namespace hyrax::bench
