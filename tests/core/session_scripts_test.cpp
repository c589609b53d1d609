// SPDX-License-Identifier: MIT
#include "daemon/core/session_scripts.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace hyrax;

TEST_CASE("scripts of a session are added, replaced and taken away") {
    SessionScripts scripts;
    CHECK(scripts.put("a.lua", "1") == "run:a.lua");
    CHECK(scripts.put("run:b.lua", "2") == "run:b.lua");
    REQUIRE(scripts.all().size() == 2);
    const std::uint64_t first = [&] {
        std::vector<ScriptSource> sources;
        scripts.adjust(sources, true);
        CHECK(sources.size() == 2);
        return sources[0].turn;
    }();
    CHECK(scripts.put("a.lua", "1") == "run:a.lua");
    std::vector<ScriptSource> sources{{.name = "file.lua", .text = "f"}};
    scripts.restart("file.lua");
    scripts.adjust(sources, true);
    REQUIRE(sources.size() == 3);
    CHECK(sources[0].turn != 0);
    CHECK(sources[1].turn != first);
    CHECK(sources[2].permissions.size() == script_permissions.size());

    sources = {{.name = "file.lua", .text = "f"}};
    scripts.adjust(sources, false);
    CHECK(sources.size() == 1);
    CHECK(scripts.remove("a.lua"));
    CHECK_FALSE(scripts.remove("a.lua"));
    CHECK_FALSE(scripts.remove("file.lua"));
    CHECK(scripts.remove("run:b.lua"));
    CHECK(scripts.all().empty());
}

TEST_CASE("a name must be one, and there is an end to how many") {
    SessionScripts scripts;
    CHECK_FALSE(scripts.put("", "").has_value());
    CHECK_FALSE(scripts.put("run:", "").has_value());
    CHECK_FALSE(scripts.put("a\nb", "").has_value());
    CHECK_FALSE(scripts.put(std::string(65, 'a'), "").has_value());
    for (std::size_t i = 0; i < SessionScripts::most; ++i) {
        CHECK(scripts.put("s" + std::to_string(i), "").has_value());
    }
    CHECK_FALSE(scripts.put("one more", "").has_value());
    CHECK(scripts.put("s1", "anew").has_value());
}
