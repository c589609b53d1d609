// SPDX-License-Identifier: MIT
// Windows behind the seam: a tray icon, a transparent overlay, the mouse, real clocks.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/result.h"
#include "daemon/core/sprite_worker.h"
#include "daemon/core/statistics.h"
#include "daemon/core/topmost.h"
#include "daemon/win32/about_box.h"
#include "daemon/win32/autostart.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/folder_watch.h"
#include "daemon/win32/front_watch.h"
#include "daemon/win32/hotkeys.h"
#include "daemon/win32/machine_watch.h"
#include "daemon/win32/message_window.h"
#include "daemon/win32/messages.h"
#include "daemon/win32/monitor_watch.h"
#include "daemon/win32/overlay.h"
#include "daemon/win32/pipe_server.h"
#include "daemon/win32/pointer.h"
#include "daemon/win32/screens.h"
#include "daemon/win32/tray_icon.h"
#include "daemon/win32/window_watch.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hyrax::win32 {

struct Win32DesktopOptions {
    std::filesystem::path profile;        ///< Changes below it come as FilesChanged.
    std::vector<std::wstring> unwatched;  ///< Names in the profile whose changes do not count.
    std::filesystem::path config_file;    ///< Opened by the menu, as are the next two.
    std::filesystem::path scripts_folder;
    std::filesystem::path log_file;
    std::filesystem::path executable;     ///< What starts with the session if the user wants that.
    std::wstring restart_arguments;       ///< For a start that Windows makes after an update.
    std::wstring instance_name;           ///< SingleInstance::name()
    std::unique_ptr<PipeServer> control;  ///< None: nobody can speak to the daemon by a pipe.

    HANDLE scripts_event = nullptr;  ///< Comes as ScriptsHeard while it is signalled.

    /// What the arguments of a second start ask for; must report mistakes itself.
    std::function<std::vector<Request>(const std::vector<std::string>&)> parse_arguments;
    /// A test may bring its own screens.
    std::function<std::vector<Monitor>()> monitors = read_monitors;
    bool for_testing = false;  ///< Another program may tell facts by test_fact_message.
};

class Win32Desktop final : public Desktop, private MessageHandler {
public:
    [[nodiscard]] static Result<std::unique_ptr<Win32Desktop>> create(Win32DesktopOptions options);
    ~Win32Desktop() override;

    /// While the menu is open or a box is dragged, the system's own loop holds wait(). Meanwhile
    /// this is called some 60 times a second, to take the input that has come, to do what is due
    /// and to present; not to wait. False: an open menu is to close, because the daemon ends.
    using ModalTick = std::function<bool(const std::vector<Input>& inbox)>;
    void on_modal_tick(ModalTick go_on) { go_on_ = std::move(go_on); }

    /// Called from wait() when the session ends: the process may be gone once the system has its
    /// answer. A Quit request follows.
    void on_session_end(std::function<void()> end) { end_session_ = std::move(end); }

    /// Called from wait() for each message `hyrax.statistics` (RegisterWindowMessage) that the
    /// daemon's window gets.
    void on_statistics_request(std::function<void()> tell) { tell_statistics_ = std::move(tell); }
    DesktopCounters counters() const;

    Ticks now() override;
    std::vector<Input> wait(Ticks deadline) override;
    void present(const Frame& frame) override;
    void use_renderer(Renderer renderer) override {
        overlay_.use_renderer(renderer);
        bubbles_.use_renderer(renderer);
    }
    std::vector<Monitor> monitors() override;
    std::vector<DesktopWindow> windows() override;
    void watch_windows(const WindowInterest& interest) override;
    void show_status(const Status& status) override;
    void follow(const Conduct& conduct) override;
    void answer(ClientId client, std::string_view text, Answer which) override;
    void show_menu(MenuItems menu, Point anchor) override;
    void greet(const std::string& text) override;
    void notify(const std::string& title, const std::string& text) override;
    Result<void> take_hotkey(HotkeyId id, const KeyCombination& keys) override;
    void give_back_hotkey(HotkeyId id) override;
    std::optional<Point> pointer() override;
    WallTime wall_time() override;
    void read_aside(std::unique_ptr<SpriteReading> reading) override;
    std::unique_ptr<SpriteReading> sprites_read() override { return worker_.take(); }

private:
    explicit Win32Desktop(Win32DesktopOptions options);
    Result<void> start();

    void drain_messages();
    void do_chores();
    Ticks chores_due() const;
    bool scripts_spoke() const;
    void sleep_until(Ticks due);

    std::optional<LRESULT> on_message(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
        override;
    std::optional<LRESULT> on_daemon_message(UINT message, WPARAM wparam, LPARAM lparam);
    // win32_desktop_presence.cpp
    Ticks presence_due() const;
    void look_around(Ticks time);
    void keep_on_top(Ticks time);
    void notice(UINT message, WPARAM wparam, LPARAM lparam);
    void take_test_fact(TestFact fact, LPARAM value);
    void tell_facts(Ticks time);
    std::vector<Monitor> read_screens() const;

    void end_session();
    void ask(Request request);
    void on_screens_hint();
    bool on_handed_over(LPARAM copy_data);
    void ask_for_menu(Point anchor);
    void open_menu();
    void give_back_focus(HWND former, bool of_tray);
    void carry_out(MenuAction action);
    void carry_out(const desktop_command::OpenConfig&);
    void carry_out(const desktop_command::OpenScripts&);
    void carry_out(const desktop_command::OpenLog&);
    void carry_out(const desktop_command::ShowAbout&);
    void carry_out(const desktop_command::SetAutostart& autostart);

    void begin_modal();
    void end_modal();
    void modal_tick();

    Win32DesktopOptions options_;
    ModalTick go_on_;
    std::function<void()> end_session_;
    std::function<void()> tell_statistics_;
    std::vector<Input> inbox_;
    DesktopCounters counters_;  ///< Without the overlay's.
    UINT taskbar_created_ = 0;
    UINT statistics_message_ = 0;
    int modal_depth_ = 0;
    bool in_modal_tick_ = false;
    bool menu_open_ = false;
    bool tray_menu_wanted_ = false;
    struct OfferedMenu {
        MenuItems items;
        Point anchor;
        bool of_tray = false;
    };
    std::optional<OfferedMenu> offered_menu_;
    bool waiting_ = false;
    bool closing_ = false;
    Facts facts_;
    Facts told_facts_;
    Conduct conduct_;
    TopmostKeeper topmost_;
    bool little_power_ = false;
    int wider_ = 0;  ///< [px], see TestFact.
    std::size_t most_screens_ = std::numeric_limits<std::size_t>::max();

    Autostart autostart_;
    Alarm alarm_;
    FolderWatch files_;
    MonitorWatch screens_;
    WindowWatch windows_;
    Window daemon_;
    SpriteWorker worker_;  ///< Is waited for when nothing of ours is seen any more.
    Overlay overlay_;
    Overlay bubbles_;
    bool bubbles_shown_ = false;
    Pointer pointer_;
    std::optional<AboutBox> about_;
    std::optional<TrayIcon> tray_;
    std::optional<Hotkeys> hotkeys_;
    std::optional<FrontWatch> front_;
    std::optional<MachineWatch> machine_;
};

}  // namespace hyrax::win32
