// SPDX-License-Identifier: MIT
// What of an archive may reach the disk.
#include "daemon/control/archive.h"

#include "daemon/core/plugin.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace hyrax;

namespace {

struct File {
    ArchiveEntry entry;
    std::string text{};
    std::size_t times = 1;  // The text comes so often.
};

/// An archive that says what a test wants.
class FakeArchive final : public Archive {
public:
    explicit FakeArchive(std::vector<File> files) : files_(std::move(files)) {}

    Result<bool> next(ArchiveEntry& entry) override {
        if (next_ == files_.size()) {
            return false;
        }
        entry = files_[next_++].entry;
        return true;
    }
    Result<void> read(const Sink& sink) override {
        const File& file = files_[next_ - 1];
        Result<void> taken;
        for (std::size_t i = 0; taken && i < file.times; ++i) {
            taken = sink(file.text);
            pieces += 1;
        }
        return taken;
    }

    std::size_t pieces = 0;

private:
    std::vector<File> files_;
    std::size_t next_ = 0;
};

std::string refusal(std::vector<File> files) {
    const TemporaryFolder folder;
    FakeArchive archive(std::move(files));
    const Result<void> unpacked = unpack(archive, folder.path());
    return unpacked ? "none" : unpacked.error().message;
}

}  // namespace

TEST_CASE("files come to lie where their names say") {
    const TemporaryFolder folder;
    FakeArchive archive({
        {{"plugin.json"}, "{}"},
        {{"lib/"}, ""},
        {{"lib/a.lua"}, "return 1"},
        {{"sprites/b/c.png"}, "x", 3},
    });
    REQUIRE(unpack(archive, folder.path()).has_value());
    CHECK(folder.read("plugin.json") == "{}");
    CHECK(folder.read("lib/a.lua") == "return 1");
    CHECK(folder.read("sprites/b/c.png") == "xxx");
}

TEST_CASE("only names that are safe on every system are taken") {
    for (const char* good : {"a", "a.lua", "a/b-c_d.png", "a b/c", "lib/", ".luarc.json"}) {
        CHECK_MESSAGE(safe_path(good).has_value(), good);
    }
    CHECK(safe_path("a/b.lua").value() == std::filesystem::path("a") / "b.lua");
    for (const char* bad :
         {"",     "/",        "/etc/passwd", "..",     "../a", "a/../b", "a/..", ".",
          "./a",  "a//b",     "C:/a",        "C:a",    "a\\b", "..\\a",  "con",  "a/nul.txt",
          "COM1", "a/lpt9.x", "a.",          "a ",     " a",   "a:b",    "a?",   "a*",
          "a\nb", "a\x7F",    "\xC3\xA4",    "a/b./c", "a|b",  "\"a\"",  "a<b>"}) {
        CHECK_FALSE_MESSAGE(safe_path(bad).has_value(), bad);
    }
    CHECK_FALSE(safe_path(std::string("a\0b", 3)).has_value());
    CHECK_FALSE(safe_path(std::string(101, 'a')).has_value());
    CHECK(refusal({{{"../x"}, "x"}}).contains("\"../x\": is no name that is safe"));
}

TEST_CASE("links, what is encrypted and names that some systems take for one are refused") {
    CHECK(refusal({{{"a", true}, "/etc/passwd"}}) == "\"a\": is a link");
    CHECK(refusal({{{"a", false, true}, "?"}}) == "\"a\": is encrypted");
    CHECK(refusal({{{"a.lua"}, ""}, {{"A.lua"}, ""}}).starts_with("\"A.lua\": comes twice"));
    CHECK(refusal({{{"a"}, ""}, {{"a/b"}, ""}}).contains("cannot be written"));
}

TEST_CASE("what is too much is noticed as it comes") {
    std::vector<File> many(most_plugin_files);
    for (std::size_t i = 0; i < many.size(); ++i) {
        many[i].entry.name = std::to_string(i);
    }
    CHECK(refusal(many) == "none");
    many.push_back({{"one-more"}});
    CHECK(refusal(many) == "holds more than 200 files");

    const TemporaryFolder folder;
    FakeArchive bomb({{{"bomb"}, std::string(1U << 20U, 'x'), 100}});
    const Result<void> unpacked = unpack(bomb, folder.path());
    REQUIRE_FALSE(unpacked.has_value());
    CHECK(unpacked.error().message == "holds more than 32 MiB");
    CHECK(bomb.pieces == 33);
}
