// SPDX-License-Identifier: MIT
#include "daemon/win32/tray_icon.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

/// A notification area that remembers what it was asked.
struct Shell {
    bool there = true;
    bool has_icon = false;
    std::vector<DWORD> actions;
    std::wstring tip;
    std::wstring title{};
    std::wstring notice{};

    bool operator()(DWORD action, NOTIFYICONDATAW& data) {
        actions.push_back(action);
        tip = data.szTip;
        if ((data.uFlags & NIF_INFO) != 0) {
            CHECK((data.dwInfoFlags & NIIF_RESPECT_QUIET_TIME) != 0);
            title = data.szInfoTitle;
            notice = data.szInfo;
        }
        const bool ok = there && (action == NIM_ADD ? !has_icon : has_icon);
        has_icon = (has_icon || (ok && action == NIM_ADD)) && !(ok && action == NIM_DELETE);
        return ok;
    }
};

TrayIcon icon_in(Shell& shell) {
    return {nullptr, WM_APP, std::ref(shell), 0};
}

}  // namespace

TEST_CASE("the icon is added with version 4 and goes with the program") {
    Shell shell;
    {
        const TrayIcon icon = icon_in(shell);
        CHECK(icon.shown());
        CHECK(icon.due() == never);
        CHECK(shell.actions == std::vector<DWORD>{NIM_MODIFY, NIM_ADD, NIM_SETVERSION});
    }
    CHECK_FALSE(shell.has_icon);
}

TEST_CASE("an icon that is there is changed, one that is lost is added again") {
    Shell shell;
    TrayIcon icon = icon_in(shell);
    shell.actions.clear();
    icon.renew(0);
    CHECK(shell.actions == std::vector<DWORD>{NIM_MODIFY, NIM_SETVERSION});

    shell.has_icon = false;
    icon.renew(0);
    CHECK(shell.has_icon);
}

TEST_CASE("a taskbar that comes late is waited for, but not for ever") {
    Shell shell{.there = false, .has_icon = false, .actions = {}, .tip = {}};
    TrayIcon icon = icon_in(shell);
    CHECK(icon.due() == 1 * ticks_per_second);
    icon.retry(icon.due());
    CHECK(icon.due() == 3 * ticks_per_second);
    int attempts = 2;
    for (; icon.due() != never; ++attempts) {
        icon.retry(icon.due());
    }
    CHECK(attempts == 7);
    CHECK_FALSE(icon.shown());

    shell.there = true;
    icon.renew(0);
    CHECK(icon.shown());
}

TEST_CASE("the tip begins with the name and holds what fits") {
    CHECK(tip_text({.pets = 1, .paused = false, .problem = {}}) == L"hyrax\n1 pet");
    CHECK(
        tip_text({.pets = 3, .paused = true, .problem = "config.json: bad"}) ==
        L"hyrax\n3 pets, paused\nconfig.json: bad"
    );
    CHECK(tip_text({.pets = 3, .paused = false, .problem = std::string(500, 'x')}).size() == 127);

    Shell shell;
    TrayIcon icon = icon_in(shell);
    shell.actions.clear();
    icon.set_tip(L"hyrax\n2 pets");
    icon.set_tip(L"hyrax\n2 pets");
    CHECK(shell.actions == std::vector<DWORD>{NIM_MODIFY});
    CHECK(shell.tip == L"hyrax\n2 pets");
}

TEST_CASE("a notice has a title, and both are cut to what fits") {
    Shell shell;
    TrayIcon icon = icon_in(shell);
    icon.notify(L"rain.lua", L"It rains.");
    CHECK(shell.title == L"rain.lua");
    CHECK(shell.notice == L"It rains.");
    icon.notify(std::wstring(100, L't'), std::wstring(400, L'n'));
    CHECK(shell.title.size() == 63);
    CHECK(shell.notice.size() == 255);
    icon.set_tip(L"hyrax");
    CHECK(shell.notice.size() == 255);  // told once
}
