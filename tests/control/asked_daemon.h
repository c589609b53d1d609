// SPDX-License-Identifier: MIT
// The whole daemon, and clients that ask it.
#pragma once

#include "daemon/control/controller.h"
#include "daemon/core/files.h"
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace hyrax {

inline constexpr std::string_view one_pet = R"({
    "pets": {"start": [{"x": 900, "y": 400}]},
    // kept
    "physics": {"gravity": 1200}
})";

/// A daemon whose clients ask at moments of the virtual clock; the answers come in order.
class AskedDaemon {
public:
    explicit AskedDaemon(double seconds, std::string_view config = one_pet) : recorded(seconds) {
        recorded.config(config);
        recorded.control = make_controller(write_file_atomically);
    }
    void at(double seconds, std::string request) {
        recorded.at(seconds, input::Asked{next_client_++, std::move(request)});
    }
    void run() { recorded.run(); }
    nlohmann::json answer(std::size_t number) const {
        return nlohmann::json::parse(recorded.desktop.answers().at(number).text);
    }
    nlohmann::json result(std::size_t number) const {
        const nlohmann::json given = answer(number);
        REQUIRE_MESSAGE(given["ok"] == true, given.dump());
        return given["result"];
    }
    std::string refusal(std::size_t number) const {
        const nlohmann::json given = answer(number);
        REQUIRE_MESSAGE(given["ok"] == false, given.dump());
        return given["error"]["code"].get<std::string>() + ": " +
               given["error"]["message"].get<std::string>();
    }

    RecordedDaemon recorded;

private:
    ClientId next_client_ = 1;
};

}  // namespace hyrax
