// SPDX-License-Identifier: MIT
#include "daemon/win32/autostart.h"

#include <windows.h>
#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

constexpr const wchar_t* test_key = L"Software\\hyrax-test";
constexpr const wchar_t* run_key = L"Software\\hyrax-test\\Run";
constexpr const wchar_t* approved_key = L"Software\\hyrax-test\\Explorer\\StartupApproved\\Run";

/// A part of the registry that is empty before and after.
struct Registry {
    Registry() { ::RegDeleteTreeW(HKEY_CURRENT_USER, test_key); }
    Registry(const Registry&) = delete;
    Registry& operator=(const Registry&) = delete;
    ~Registry() { ::RegDeleteTreeW(HKEY_CURRENT_USER, test_key); }

    static std::wstring entry() {
        std::array<wchar_t, 512> text{};
        DWORD size = sizeof text;
        const LSTATUS status = ::RegGetValueW(
            HKEY_CURRENT_USER, run_key, L"hyrax", RRF_RT_REG_SZ, nullptr, text.data(), &size
        );
        return status == ERROR_SUCCESS ? text.data() : L"none";
    }
    /// As the task manager does it.
    static void approve(BYTE first) {
        const std::array<BYTE, 12> state{first, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8};
        ::RegSetKeyValueW(
            HKEY_CURRENT_USER, approved_key, L"hyrax", REG_BINARY, state.data(), sizeof state
        );
    }
};

}  // namespace

TEST_CASE("autostart: off until asked for, a quoted command when on, gone when off again") {
    const Registry registry;
    const Autostart autostart(L"C:\\Program Files\\hyrax\\hyrax.exe", test_key);
    CHECK_FALSE(autostart.is_on());
    CHECK(Registry::entry() == L"none");
    REQUIRE(autostart.set(true));
    CHECK(autostart.is_on());
    CHECK(Registry::entry() == L"\"C:\\Program Files\\hyrax\\hyrax.exe\" --autostart");
    REQUIRE(autostart.set(false));
    CHECK_FALSE(autostart.is_on());
    CHECK(Registry::entry() == L"none");
    CHECK(autostart.set(false));
}

TEST_CASE("a restart goes on with the same profile, however its path is written") {
    using Path = std::filesystem::path;
    CHECK(restart_arguments({}) == L"--autostart");
    CHECK(restart_arguments(Path(L"C:\\my pets")) == L"--autostart --profile \"C:\\my pets\"");
    CHECK(restart_arguments(Path(L"D:\\")) == L"--autostart --profile \"D:\\\\\"");
}

TEST_CASE("autostart: what the user switches off in Windows' settings counts as off") {
    const Registry registry;
    const Autostart autostart(L"C:\\hyrax.exe", test_key);
    REQUIRE(autostart.set(true));
    for (const BYTE off : {BYTE{0x03}, BYTE{0x07}}) {
        Registry::approve(off);
        CHECK_FALSE(autostart.is_on());
    }
    for (const BYTE on : {BYTE{0x02}, BYTE{0x06}, BYTE{0x00}}) {
        Registry::approve(on);
        CHECK(autostart.is_on());
    }
    Registry::approve(0x03);
    REQUIRE(autostart.set(true));
    CHECK(autostart.is_on());
}
