// SPDX-License-Identifier: MIT
// A desktop made of lists: inputs with times come in, frames are remembered, time is virtual.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/statistics.h"
#include "daemon/headless/window_list.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax {

/// Something that happens at a moment of the virtual clock.
struct TimedInput {
    Ticks time = 0;
    Input input;
    /// What the world does just before, such as a file that changes.
    std::function<void()> before = {};
};

struct RecordedAnswer {
    ClientId client = 0;
    std::string text;
    Answer which = Answer::last;
};

struct RecordedNotice {
    std::string title;
    std::string text;
    bool operator==(const RecordedNotice&) const = default;
};

/// Runs as fast as the machine can. Asked to wait for ever with nothing left to come, it quits.
class HeadlessDesktop : public Desktop {
public:
    HeadlessDesktop(std::vector<Monitor> monitors, Ticks end);

    /// Inputs may be added in any order; those of one moment keep theirs.
    void add(TimedInput input);
    /// Called before time moves on: true if something else happened first, which the daemon then
    /// hears of as an input::ScriptsHeard. So virtual time waits for scripts in another process.
    void before_time_moves(std::function<bool()> wait) { before_time_moves_ = std::move(wait); }
    /// Does not tell the daemon: add an input::MonitorsChanged for that.
    void set_monitors(std::vector<Monitor> monitors) { monitors_ = std::move(monitors); }

    /// Windows of other programs, in the order of time. Changes are told while they are of
    /// interest.
    void set_windows(std::vector<TimedWindows> windows) { windows_ = std::move(windows); }
    const WindowInterest& interest() const { return interest_; }

    Ticks now() override { return now_; }
    std::vector<Input> wait(Ticks deadline) override;
    void present(const Frame& frame) override;
    /// Frames are remembered, not drawn.
    void use_renderer(Renderer renderer) override { renderer_ = renderer; }
    std::vector<Monitor> monitors() override { return monitors_; }
    std::vector<DesktopWindow> windows() override;
    void watch_windows(const WindowInterest& interest) override;
    void show_status(const Status& status) override { statuses_.push_back(status); }
    void show_menu(MenuItems menu, Point) override { menus_.push_back(std::move(menu)); }
    void greet(const std::string& text) override { greetings_.push_back(text); }
    /// Where it was set, or pressed or moved last.
    std::optional<Point> pointer() override;
    /// The clock starts at noon of the first of January 2026, UTC.
    WallTime wall_time() override { return {1'767'268'800 + now_ / ticks_per_second, 0}; }
    void set_pointer(Point at) { pointer_ = at; }
    void notify(const std::string& title, const std::string& text) override {
        notices_.push_back({title, text});
    }
    Result<void> take_hotkey(HotkeyId id, const KeyCombination& keys) override;
    void give_back_hotkey(HotkeyId id) override { hotkeys_.erase(id); }
    /// Another program has these.
    void occupy(const KeyCombination& keys) { occupied_.push_back(keys); }
    void answer(ClientId client, std::string_view text, Answer which) override {
        answers_.push_back({client, std::string(text), which});
    }

    void follow(const Conduct& conduct) override { conduct_ = conduct; }
    /// How long reading sprite sets takes, none by default.
    void set_reading_time(Ticks span) { reading_time_ = span; }
    void read_aside(std::unique_ptr<SpriteReading> reading) override;
    std::unique_ptr<SpriteReading> sprites_read() override;

    const Conduct& conduct() const { return conduct_; }
    Renderer renderer() const { return renderer_; }
    const Frame& last_frame() const { return frame_; }
    std::size_t presents() const { return counters_.overlay.frames; }
    /// How often wait() came back because its deadline had come.
    std::size_t timer_wakeups() const { return counters_.timer_wakeups; }
    /// Frames are remembered, not drawn: nothing is presented.
    const DesktopCounters& counters() const { return counters_; }
    const std::vector<Status>& statuses() const { return statuses_; }
    const std::vector<MenuItems>& menus() const { return menus_; }
    const std::vector<std::string>& greetings() const { return greetings_; }
    const std::vector<RecordedNotice>& notices() const { return notices_; }
    /// Those that are taken now.
    const std::map<HotkeyId, KeyCombination>& hotkeys() const { return hotkeys_; }
    /// How often somebody asked for the list of windows.
    std::size_t window_readings() const { return window_readings_; }
    std::size_t pointer_readings() const { return pointer_readings_; }
    const std::vector<RecordedAnswer>& answers() const { return answers_; }

private:
    Ticks window_change() const;
    void follow_pointer(const Input& input);

    std::vector<Monitor> monitors_;
    std::function<bool()> before_time_moves_;
    std::unique_ptr<SpriteReading> reading_;
    Ticks reading_time_ = 0;
    Ticks read_at_ = never;  ///< When SpritesRead comes.
    std::vector<TimedWindows> windows_;
    WindowInterest interest_;
    Ticks told_ = 0;                  // Changes of windows up to here are known to the daemon.
    std::vector<TimedInput> inputs_;  ///< Sorted by time; those before next_ are done.
    std::size_t next_ = 0;
    Ticks now_ = 0;
    Ticks end_;
    Frame frame_;
    Renderer renderer_ = Renderer::blit;
    DesktopCounters counters_;
    std::vector<Status> statuses_;
    Conduct conduct_;
    std::vector<MenuItems> menus_;
    std::vector<std::string> greetings_;
    std::optional<Point> pointer_;
    std::vector<RecordedAnswer> answers_;
    std::vector<RecordedNotice> notices_;
    std::map<HotkeyId, KeyCombination> hotkeys_;
    std::vector<KeyCombination> occupied_;
    std::size_t window_readings_ = 0;
    std::size_t pointer_readings_ = 0;
};

/// The frame over the bounding box of the monitors, transparent where no pet is.
Image picture(const Frame& frame, const std::vector<Monitor>& monitors);

}  // namespace hyrax
