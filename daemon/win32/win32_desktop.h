// SPDX-License-Identifier: MIT
// Windows behind the seam: a tray icon, a transparent overlay, the mouse, real clocks.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/result.h"
#include "daemon/win32/about_box.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/folder_watch.h"
#include "daemon/win32/message_window.h"
#include "daemon/win32/monitor_watch.h"
#include "daemon/win32/overlay.h"
#include "daemon/win32/pointer.h"
#include "daemon/win32/screens.h"
#include "daemon/win32/tray_icon.h"
#include "daemon/win32/tray_menu.h"

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
    std::filesystem::path config_file;    ///< Opened by the menu.
    std::wstring instance_name;           ///< SingleInstance::name()

    HANDLE scripts_event = nullptr;  ///< Comes as ScriptsHeard while it is signalled.

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
    void ask(Request request);
    void on_screens_hint();
    bool on_handed_over(LPARAM copy_data);
    void open_menu(Point anchor);
    void carry_out(MenuCommand command);
    void open_config();

    void begin_modal();
    void end_modal();
    void modal_tick();

    Win32DesktopOptions options_;
    std::function<void()> run_due_;
    std::vector<Input> inbox_;
    Status status_;
    std::uint64_t wakeups_ = 0;
    UINT taskbar_created_ = 0;
    int modal_depth_ = 0;
    bool in_modal_tick_ = false;
    bool menu_open_ = false;
    bool waiting_ = false;
    bool closing_ = false;

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
