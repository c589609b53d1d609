// SPDX-License-Identifier: MIT
// Windows behind the seam: a tray icon, a transparent overlay, the mouse, real clocks.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/result.h"
#include "daemon/win32/about_box.h"
#include "daemon/win32/autostart.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/folder_watch.h"
#include "daemon/win32/message_window.h"
#include "daemon/win32/monitor_watch.h"
#include "daemon/win32/overlay.h"
#include "daemon/win32/pointer.h"
#include "daemon/win32/screens.h"
#include "daemon/win32/tray_icon.h"

#include <cstdint>
#include <filesystem>
#include <functional>
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
    std::filesystem::path executable;  ///< What starts with the session if the user wants that.
    std::wstring instance_name;        ///< SingleInstance::name()

    /// What the arguments of a second start ask for; must report mistakes itself.
    std::function<std::vector<Request>(const std::vector<std::string>&)> parse_arguments;
    /// A test may bring its own screens.
    std::function<std::vector<Monitor>()> monitors = read_monitors;
};

struct DesktopCounters {
    OverlayCounters overlay;
    std::uint64_t wakeups = 0;  ///< How often wait() slept and was woken.
};

class Win32Desktop final : public Desktop, private MessageHandler {
public:
    [[nodiscard]] static Result<std::unique_ptr<Win32Desktop>> create(Win32DesktopOptions options);
    ~Win32Desktop() override;

    /// While the menu is open or a box is dragged, the system's own loop holds wait(). Meanwhile
    /// this is called some 60 times a second, to do what is due and to present; not to wait.
    void on_modal_tick(std::function<void()> run_due) { run_due_ = std::move(run_due); }

    DesktopCounters counters() const { return {overlay_.counters(), wakeups_}; }

    Ticks now() override;
    std::vector<Input> wait(Ticks deadline) override;
    void present(const Frame& frame) override;
    std::vector<Monitor> monitors() override;
    void show_status(const Status& status) override;
    void show_menu(MenuItems menu, Point anchor) override;
    void greet(const std::string& text) override;
    std::optional<Point> pointer() override;
    WallTime wall_time() override;

private:
    explicit Win32Desktop(Win32DesktopOptions options);
    Result<void> start();

    void drain_messages();
    void do_chores();
    Ticks chores_due() const;
    void sleep_until(Ticks due);

    std::optional<LRESULT> on_message(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
        override;
    std::optional<LRESULT> on_daemon_message(UINT message, WPARAM wparam, LPARAM lparam);
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
    std::function<void()> run_due_;
    std::vector<Input> inbox_;
    std::uint64_t wakeups_ = 0;
    UINT taskbar_created_ = 0;
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

    Autostart autostart_;
    Alarm alarm_;
    FolderWatch files_;
    MonitorWatch screens_;
    Window daemon_;
    Overlay overlay_;
    Pointer pointer_;
    std::optional<AboutBox> about_;
    std::optional<TrayIcon> tray_;
};

}  // namespace hyrax::win32
