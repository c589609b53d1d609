// SPDX-License-Identifier: MIT
// The daemon: events in, frames out. Everything it knows of the machine is a Desktop.
#pragma once

#include "daemon/core/atlas.h"
#include "daemon/core/config.h"
#include "daemon/core/control_desk.h"
#include "daemon/core/desktop.h"
#include "daemon/core/engine.h"
#include "daemon/core/hand.h"
#include "daemon/core/hotkey_desk.h"
#include "daemon/core/pacer.h"
#include "daemon/core/plugins.h"
#include "daemon/core/presence.h"
#include "daemon/core/profile.h"
#include "daemon/core/remembered.h"
#include "daemon/core/script_bridge.h"
#include "daemon/core/script_stores.h"
#include "daemon/core/session_scripts.h"
#include "daemon/core/speech.h"
#include "daemon/core/stage.h"
#include "daemon/core/trace.h"
#include "daemon/core/world_clock.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

struct DaemonOptions {
    Profile profile;
    ImageDecoder decode;
    std::unique_ptr<ScriptHost> scripts;             ///< None: scripts are not run.
    std::unique_ptr<ControlPort> control = nullptr;  ///< None: nobody answers clients.
    std::optional<Trace> trace;
    std::vector<Request> requests;  ///< Carried out after the start-up pets have come.
    std::optional<double> fps;      ///< Instead of the config's.
    std::uint32_t seed = 1;         ///< For pets without a given place.
    TextPainter paint_text{};       ///< None: nobody speaks.
    bool welcome = true;            ///< The config's pets come at the start.
};

/// What the daemon has done, as far as it is asked.
struct Figures {
    double seconds = 0.0;      ///< Since the start, pauses left out.
    std::uint64_t frames = 0;  ///< Drawn, whether or not they differed from the one before.
    double frame_ns = 0.0;     ///< Mean time that drawing one took; 0 without a control channel.
};

/// A script that the daemon knows of.
struct ScriptStatus {
    std::string name;
    std::size_t bytes = 0;  ///< Of its text; 0 while it is off.
    bool on = false;
    bool ended = false;   ///< By its limits, or because its text has an error.
    std::string error{};  ///< The latest one.
    std::size_t pets = 0;
    ScriptUse use{};
};

class Daemon {
public:
    /// Reads the profile. What cannot be read is told in the log and the status, and replaced by
    /// defaults.
    Daemon(Desktop& desktop, DaemonOptions options);

    /// Until a Quit request; then end().
    void run();
    /// Ends the scripts and writes what they keep; run() comes back as soon as wait() does. For a
    /// session that ends: the process may not live to see run() do it.
    void end();
    /// Draws the frame that is due, if one is. For message loops that are not run()'s own: menus.
    void run_due();
    /// True once somebody has asked it to end: run() comes back as soon as wait() does.
    bool is_ending() const { return quitting_; }
    /// Does at once what an input asks for; the picture follows with the next frame.
    void handle(const Input& input);

    const Engine& engine() const { return engine_; }
    Engine& engine() { return engine_; }
    const Config& config() const { return config_; }
    const Profile& profile() const { return profile_; }

    // For people who write scripts: daemon_scripts.cpp
    std::vector<ScriptStatus> script_states() const;
    /// Of a script or plugin: what it uses, and how many pets it owns.
    ScriptUse use_of(const std::string& script) const { return scripts_.use_of(script); }
    std::size_t pets_of(const std::string& owner) const;
    /// The whole name: a developer's scripts can be named without what stands in front of it.
    [[nodiscard]] Result<std::string> find_script(std::string_view name) const;
    /// Adds a script that lasts until the daemon ends, or starts it anew; its whole name.
    [[nodiscard]] Result<std::string> run_script(std::string_view name, std::string text);
    /// False if nobody has run one of this name.
    bool stop_script(std::string_view name);
    void restart_script(const std::string& script);
    /// The number under which ControlPort::evaluated() hears of it; fails while many wait.
    [[nodiscard]] Result<std::uint64_t> evaluate(const std::string& script, std::string text);
    /// The latest error of a script or plugin; empty: none.
    std::string error_of(const std::string& script) const { return scripts_.error_of(script); }
    /// Empty while scripts may run.
    std::string why_scripts_rest() const;
    const std::vector<PluginEntry>& plugins() const { return plugins_; }
    Status status() const;
    Figures figures() const;
    const Frame& frame() const { return frame_; }

private:
    // daemon_input.cpp
    void on(const input::Pressed& pressed);
    void on(const input::Moved& moved);
    void on(const input::Released& released);
    void on(const input::Turned& turned);
    void on(const input::MenuWanted& wanted);
    void on(const input::PointerLost& lost);
    void on(const input::MonitorsChanged& changed);
    void on(const input::FrameLost& lost);
    void on(const input::FilesChanged& changed);
    void on(const input::SpritesRead& read);
    void on(const input::FactsChanged& changed);
    void on(const input::ScriptsHeard& heard);
    void on(const input::WindowsChanged& changed);
    void on(const input::HotkeyPressed& pressed);
    void on(const input::Asked& asked);
    void on(const input::Left& left);
    void on(const Request& request);

    void carry_out(const request::Spawn& spawn);
    void carry_out(const request::FlingAll& fling);
    void carry_out(const request::ResetAll& reset);
    void carry_out(const request::RemoveAll& remove);
    void carry_out(const request::Reload& reload);
    void carry_out(const request::Quit& quit);

    void let_go(Ticks time, double max_speed);

    // daemon_menu.cpp
    MenuState menu_state();
    void open_pet_menu(PetId id, Point at);
    bool is_there(PetId id) const;
    void carry_out(const request::StopPet& stop);
    void carry_out(const request::ResetPet& reset);
    void carry_out(const request::SetScale& scale);
    void carry_out(const request::RemovePet& gone);
    void carry_out(const request::RemoveOthers& kept);

    // daemon_state.cpp
    void carry_out(const request::SetPaused& pause);
    void carry_out(const request::TogglePause& toggle);
    void carry_out(const request::Hide& hide);
    void carry_out(const request::Show& show);
    void carry_out(const request::SetQuiet& wish);
    void carry_out(const request::SetClickThrough& wish);
    void carry_out(const request::SetMonitor& wish);
    void carry_out(const request::Gather& gather);
    void carry_out(const request::SetScript& wish);
    void recall();
    void remember();
    void greet();
    void show_when_due(Ticks now);
    bool quiet() const { return remembered_.quiet.value_or(config_.quiet); }
    bool click_through() const { return remembered_.click_through.value_or(config_.click_through); }
    void keep_quiet();
    void settle();
    bool is_allowed(std::size_t monitor) const;

    // daemon_profile.cpp
    bool read_config();
    std::string stamp_of_sprites() const;
    void begin_reading_kinds(std::string stamp);
    void read_kinds();
    void use_kinds(Result<std::vector<ReadKind>> kinds);
    void follow_files();
    void read_scripts();
    void load_wanted_scripts();
    void use_monitors();

    // daemon_plugins.cpp
    void read_plugins();
    std::vector<ScriptSource> plugin_sources();
    void tell_of_plugins(std::vector<std::string> problems);
    const PluginEntry* plugin(const std::string& id) const;
    void carry_out(const request::SetPlugin& wish);
    void carry_out(const request::AllowPlugin& wish);
    void turn_off_given_up();

    // daemon_ledges.cpp
    void mind_windows();
    void read_windows();

    // daemon_presence.cpp
    void use_presence_settings();
    void heed_presence(Ticks now);
    double frame_rate() const;
    void choose_conduct(bool moving, bool animated);

    // daemon_system.cpp
    ScriptEyes script_eyes();
    bool is_loaded(std::string_view script) const;
    void carry_out(UserHotkey hotkey);
    void grant(const command::Notify& notice, Ticks now);
    void grant(const command::Hotkey& wish, Ticks now);

    void grant_wishes(Ticks now);
    void draw(Ticks now);
    void welcome();
    void report();
    std::string problem() const;

    Desktop& desktop_;
    Profile profile_;
    ImageDecoder decode_;
    std::optional<double> fps_;
    Config config_;
    std::optional<Config> last_read_;  ///< As it stood in the file.
    std::vector<SpriteSet> sets_;
    Atlas atlas_;
    Engine engine_;
    ScriptBridge scripts_;
    ControlDesk control_;
    Speeches speeches_;
    ScriptStores stores_;
    HotkeyDesk hotkeys_;
    std::map<std::string, Ticks, std::less<>> next_notices_;  ///< By script: not before then.
    std::vector<Rect> window_frames_;                         ///< As scripts see them.
    Ticks read_windows_again_ = 0;
    SessionScripts session_scripts_;
    std::optional<Trace> trace_;
    std::vector<Request> first_requests_;

    WindowInterest windows_;
    std::vector<Monitor> all_monitors_;
    std::vector<Monitor> monitors_;  ///< As far as pets may be on them.
    std::vector<ScriptSource> sources_;
    std::vector<std::string> script_names_;  ///< Those that are off as well.
    std::vector<PluginEntry> plugins_;
    std::string sprites_stamp_;      ///< stamp_of_sprites() before they were last read.
    bool reading_aside_ = false;     ///< The desktop has a reading.
    bool kinds_on_the_way_ = false;  ///< What it reads counts: nobody has read them since.
    bool all_scripts_anew_ = false;  ///< Though their texts are the same.
    std::string plugins_ask_;
    Remembered remembered_;
    Remembered saved_;  ///< As state.json has it.
    bool paused_ = false;
    Ticks show_at_ = never;
    std::optional<PetId> menu_pet_;  ///< The right button went down on it.
    WorldClock clock_;
    Pacer pacer_;
    Presence presence_;
    Conduct conduct_;
    Hand hand_;
    Frame frame_;
    bool frame_lost_ = false;
    std::uint64_t edition_ = 0;  ///< Of the sprite sets.
    Ticks next_frame_ = 0;
    Ticks begin_ = 0;
    Ticks drawing_ = 0;  ///< Time spent in draw().
    std::uint64_t frames_ = 0;
    bool changed_ = true;
    bool welcomed_ = false;
    bool quitting_ = false;
    bool ended_ = false;

    // What is wrong, one line each, by source; shown until that source is read without an error.
    std::string config_problem_;
    std::vector<std::string> kind_problems_;
    std::vector<std::string> script_problems_;
    std::vector<std::string> plugin_problems_;
    std::string place_problem_;
    Status shown_status_;
};

}  // namespace hyrax
