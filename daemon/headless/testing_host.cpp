// SPDX-License-Identifier: MIT
#include "daemon/headless/testing_host.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hyrax {

bool TestReport::passed() const {
    return !ended.empty() && open == 0 &&
           std::ranges::all_of(ended, [](const ScriptTest& test) { return test.problem.empty(); });
}

std::string tap(const TestReport& report) {
    std::string text;
    std::size_t number = 0;
    for (const ScriptTest& test : report.ended) {
        const bool passed = test.problem.empty();
        text += fmt::format(
            "{} {} - {} # {:.2f} s\n", passed ? "ok" : "not ok", ++number, test.name, test.seconds
        );
        if (!passed) {
            text += "# " + test.problem + "\n";
        }
    }
    text += fmt::format("1..{}\n", number + report.open);
    if (report.open > 0) {
        text += fmt::format("# {} cases did not end in time (--seconds)\n", report.open);
    }
    if (number + report.open == 0) {
        text += "# no case: hyrax.test.case(name, function) makes one\n";
    }
    return text;
}

TestingHost::TestingHost(
    std::unique_ptr<ScriptHost> host,
    std::string script,
    TestReport& report,
    std::function<void()> done
)
    : host_(std::move(host)), script_(std::move(script)), report_(report), done_(std::move(done)) {}

void TestingHost::load(std::vector<ScriptSource> sources) {
    std::erase_if(sources, [this](const ScriptSource& source) { return source.name != script_; });
    for (ScriptSource& source : sources) {
        source.testing = true;
    }
    host_->load(std::move(sources));
}

ScriptOutput TestingHost::run(const ScriptWorld& world, std::span<const ScriptEvent> events) {
    ScriptOutput output = host_->run(world, events);
    std::ranges::move(output.tests, std::back_inserter(report_.ended));
    if (!world.ending) {
        report_.open = output.open_tests;
    }
    if (report_.open == 0) {
        if (const auto done = std::exchange(done_, {})) {
            done();
        }
    }
    return output;
}

}  // namespace hyrax
