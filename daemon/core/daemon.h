// SPDX-License-Identifier: MIT
// The daemon: events in, frames out. Everything it knows of the machine is a Desktop.
#pragma once

#include "daemon/core/config.h"
#include "daemon/core/desktop.h"
#include "daemon/core/engine.h"
#include "daemon/core/hand.h"
#include "daemon/core/pacer.h"
#include "daemon/core/profile.h"
#include "daemon/core/script_bridge.h"
#include "daemon/core/script_stores.h"
#include "daemon/core/speech.h"
#include "daemon/core/stage.h"
#include "daemon/core/trace.h"
#include "daemon/core/world_clock.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hyrax {

struct DaemonOptions {
    Profile profile;
    ImageDecoder decode;
    std::unique_ptr<ScriptHost> scripts;  ///< None: scripts are not run.
    std::optional<Trace> trace;
    std::vector<Request> requests;  ///< Carried out after the start-up pets have come.
    std::optional<double> fps;      ///< Instead of the config's.
    std::uint32_t seed = 1;         ///< For pets without a given place.
    TextPainter paint_text{};       ///< None: nobody speaks.
    bool welcome = true;            ///< The config's pets come at the start.
};

class Daemon {
public:
    /// Reads the profile. What cannot be read is told in the log and the status, and replaced by
    /// defaults.
    Daemon(Desktop& desktop, DaemonOptions options);

    /// Until a Quit request.
    void run();
    /// Draws the frame that is due, if one is. For message loops that are not run()'s own: menus.
    void run_due();

    const Engine& engine() const { return engine_; }
    const Frame& frame() const { return frame_; }

private:
    // daemon_input.cpp
    void handle(const Input& input);
    void on(const input::Pressed& pressed);
    void on(const input::Moved& moved);
    void on(const input::Released& released);
    void on(const input::PointerLost& lost);
    void on(const input::MonitorsChanged& changed);
    void on(const input::FilesChanged& changed);
    void on(const Request& request);

    void carry_out(const request::Spawn& spawn);
    void carry_out(const request::FlingAll& fling);
    void carry_out(const request::ResetAll& reset);
    void carry_out(const request::RemoveAll& remove);
    void carry_out(const request::SetPaused& pause);
    void carry_out(const request::TogglePause& toggle);
    void carry_out(const request::Reload& reload);
    void carry_out(const request::Quit& quit);

    void let_go(Ticks time, double max_speed);

    // daemon_profile.cpp
    void read_config();
    void read_kinds();
    void read_scripts();
    void use_monitors();

    void grant_wishes(Ticks now);
    void draw(Ticks now);
    void welcome();
    void report();

    Desktop& desktop_;
    Profile profile_;
    ImageDecoder decode_;
    std::optional<double> fps_;
    Config config_;
    std::optional<Config> last_read_;  ///< As it stood in the file.
    std::vector<SpriteSet> sets_;
    Engine engine_;
    ScriptBridge scripts_;
    Speeches speeches_;
    ScriptStores stores_;
    std::optional<Trace> trace_;
    std::vector<Request> first_requests_;

    std::vector<Monitor> monitors_;
    std::vector<ScriptSource> sources_;
    WorldClock clock_;
    Pacer pacer_;
    Hand hand_;
    Frame frame_;
    Ticks next_frame_ = 0;
    bool changed_ = true;
    bool welcomed_ = false;
    bool quitting_ = false;

    // What is wrong, one line each, by source; shown until that source is read without an error.
    std::string config_problem_;
    std::vector<std::string> kind_problems_;
    std::vector<std::string> script_problems_;
    Status shown_status_;
};

}  // namespace hyrax
