// SPDX-License-Identifier: MIT
#include "daemon/win32/process.h"

#include "daemon/win32/single_instance.h"
#include "daemon/win32/text.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;
using namespace hyrax::win32;

TEST_CASE("text goes to UTF-16 and back") {
    const std::string text = "h\xC3\xBCrax \xF0\x9F\x90\xBE";
    CHECK(utf8(wide(text)) == text);
    CHECK(wide("").empty());
    CHECK(wide("\xFF") == L"\xFFFD");
}

TEST_CASE("a shortened text never ends in half a character") {
    const std::wstring text = L"ab\xD83D\xDC3E";
    CHECK(shortened(text, 4) == text);
    CHECK(shortened(text, 3) == L"ab");
    CHECK(shortened(text, 0).empty());
}

TEST_CASE("an error names what failed, the reason and the number") {
    const std::string message = system_error("cannot open x", ERROR_FILE_NOT_FOUND).message;
    CHECK(message.starts_with("cannot open x: "));
    CHECK(message.ends_with("(error 2)"));
}

TEST_CASE("the second of one profile is not the first") {
    const auto first = SingleInstance::claim("profile one");
    REQUIRE(first);
    CHECK(first->is_first());
    const auto second = SingleInstance::claim("Profile One");
    REQUIRE(second);
    CHECK_FALSE(second->is_first());
    CHECK(second->name() == first->name());
    const auto other = SingleInstance::claim("profile two");
    REQUIRE(other);
    CHECK(other->is_first());
}

TEST_CASE("the place is free again when the first is gone") {
    { const auto first = SingleInstance::claim("profile three"); }
    const auto next = SingleInstance::claim("profile three");
    REQUIRE(next);
    CHECK(next->is_first());
}

TEST_CASE("the folders are those of the user and of the program") {
    const auto folders = find_folders();
    REQUIRE(folders);
    CHECK_FALSE(folders->portable);
    CHECK(folders->profile.filename() == L"hyrax");
    CHECK(folders->state != folders->profile);
    CHECK(std::filesystem::exists(folders->program));
}
