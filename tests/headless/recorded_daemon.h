// SPDX-License-Identifier: MIT
// The whole daemon on the recorded desktop, with real JSON, real sprite sets and real Lua.
#pragma once

#include "daemon/core/daemon.h"
#include "daemon/core/files.h"
#include "daemon/headless/headless_desktop.h"
#include "daemon/headless/png_file.h"
#include "daemon/script/script_host.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax {

inline Monitor screen(Rect bounds) {
    return {.bounds = bounds, .work = bounds, .primary = true, .name = {}};
}

/// That remembers, and has what is shipped.
inline Profile profile_in(const TemporaryFolder& folder) {
    return {
        .config = folder.path() / "config.json",
        .user = folder.path(),
        .shipped = HYRAX_SOURCE_DIR,
        .more_scripts = {},
        .state = folder.path() / "state.json",
    };
}

/// Files first, then inputs, then run().
class RecordedDaemon {
public:
    explicit RecordedDaemon(
        double seconds, std::vector<Monitor> monitors = {screen({0, 0, 1920, 1080})}
    )
        : desktop(std::move(monitors), from_seconds(seconds)) {}

    void config(std::string_view text) const { folder.write("config.json", text); }
    void script(std::string_view name, std::string_view text) const {
        folder.write(std::string("scripts/").append(name), text);
    }
    void at(double seconds, Input input) { desktop.add({from_seconds(seconds), std::move(input)}); }
    void change_file(double seconds, std::string name, std::string text) {
        desktop.add({
            from_seconds(seconds),
            input::FilesChanged{},
            [this, name = std::move(name), text = std::move(text)] { folder.write(name, text); },
        });
    }
    /// Looks at the daemon at a moment.
    void look(double seconds, std::function<void(const Daemon&)> see) {
        desktop.add({
            from_seconds(seconds),
            input::Released{.at = {}, .button = Button::middle},  // means nothing to the daemon
            [this, see = std::move(see)] { see(*daemon); },
        });
    }

    void run() {
        DaemonOptions options{
            .profile = profile_in(folder),
            .decode = decode_png,
            .scripts = make_script_host({}),
            .control = std::move(control),
            .trace = {},
            .requests = std::move(requests),
            .fps = {},
            .paint_text = [](std::string_view line) -> Result<Image> {
                return Image(Size{static_cast<int>(line.size()) * 7, 14});
            },
        };
        daemon.emplace(desktop, std::move(options));
        daemon->run();
    }

    TemporaryFolder folder;
    HeadlessDesktop desktop;
    std::vector<Request> requests;
    std::unique_ptr<ControlPort> control;
    std::optional<Daemon> daemon;
};

/// What it remembers.
inline std::string state_of(const RecordedDaemon& recorded) {
    return read_text_file(recorded.folder.path() / "state.json", 1U << 20U).value_or("none");
}

inline const Pet& only_pet(const Daemon& daemon) {
    const Pet* found = nullptr;
    daemon.engine().for_each([&found](PetId, const Pet& pet) { found = &pet; });
    REQUIRE(found != nullptr);
    return *found;
}

}  // namespace hyrax
