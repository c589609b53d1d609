// SPDX-License-Identifier: MIT
// Runs one script alone with hyrax.test, and collects what its cases tell.
#pragma once

#include "daemon/core/script_port.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hyrax {

/// What the cases of a script have told.
struct TestReport {
    std::vector<ScriptTest> ended;
    std::size_t open = 0;  ///< Cases that have not ended.
    bool passed() const;
};

/// In the Test Anything Protocol, version 12.
std::string tap(const TestReport& report);

class TestingHost final : public ScriptHost {
public:
    /// Of all scripts only `script` is loaded. `done` is called once, when its last case has ended
    /// or there is none; `report` must outlive this object.
    TestingHost(
        std::unique_ptr<ScriptHost> host,
        std::string script,
        TestReport& report,
        std::function<void()> done
    );

    void load(std::vector<ScriptSource> sources) override;
    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override;

private:
    std::unique_ptr<ScriptHost> host_;
    std::string script_;
    TestReport& report_;
    std::function<void()> done_;
};

}  // namespace hyrax
