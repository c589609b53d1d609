// SPDX-License-Identifier: MIT
// What scripts keep, as files.
#include "daemon/core/script_stores.h"

#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

using namespace hyrax;

namespace {

ScriptValue text(std::string value) {
    return {std::move(value)};
}

}  // namespace

TEST_CASE("fields are sorted, replaced and removed") {
    ScriptTable table;
    set_field(table, "b", {true});
    set_field(table, "a", text("x"));
    set_field(table, "c", {});
    REQUIRE(table.size() == 2);
    CHECK(table[0].name == "a");
    CHECK(*find_field(table, "b") == ScriptValue{true});
    CHECK(size_of(table) == 2 + 8 + 8 + 1);
    set_field(table, "b", {});
    CHECK(find_field(table, "b") == nullptr);
}

TEST_CASE("every value survives the file") {
    ScriptTable table;
    set_field(table, "whole", {std::int64_t{-7}});
    set_field(table, "large", {INT64_MAX});
    set_field(table, "broken", {0.1});
    set_field(table, "whole double", {3.0});
    set_field(table, "text", text("\u00e4 \"quoted\"\n\t\x01"));
    set_field(table, "list", {ScriptValue::List{{true}, {}, {ScriptTable{{"k", {false}}}}}});
    set_field(table, "empty", {ScriptValue::List{}});
    const Result<ScriptTable> back = parse_store(json_of(table), "x.json");
    REQUIRE(back);
    CHECK(*back == table);
}

TEST_CASE("files that are no store are refused with a reason") {
    CHECK(parse_store("{", "a.json").error().message == "a.json: is no JSON");
    CHECK(parse_store("[]", "a.json").error().message == "a.json: expected an object, got array");
    CHECK(parse_store("", "a.json").error().message == "a.json: is no JSON");
    CHECK(
        parse_store(std::string(5'000, '[') + std::string(5'000, ']'), "a.json").has_value() ==
        false
    );
}

TEST_CASE("names of files are safe everywhere") {
    CHECK(store_file_name("fountain.lua") == "fountain.lua.json");
    CHECK(store_file_name("rock-concert") == "rock-concert.json");
    CHECK(store_file_name("examples/fountain.lua") == "examples%2Ffountain.lua.json");
    CHECK(store_file_name("../x") == "%2E.%2Fx.json");
    CHECK(store_file_name("con.lua") == "%63on.lua.json");
    CHECK(store_file_name("COM1") == "%43OM1.json");
    CHECK(store_file_name("console.lua") == "console.lua.json");
    CHECK(store_file_name("\u00e4:b") == "%C3%A4%3Ab.json");
}

TEST_CASE("a store is written once a second at most, and at the end") {
    TemporaryFolder folder;
    ScriptStores stores(folder.path() / "store");
    CHECK(stores.next_write() == never);
    stores.set("a.lua", "n", {std::int64_t{1}}, 0);
    CHECK(stores.next_write() == 0);
    stores.write_due(0);
    CHECK(folder.read("store/a.lua.json") == "{\n \"n\": 1\n}\n");
    CHECK(stores.next_write() == never);
    stores.set("a.lua", "n", {std::int64_t{2}}, 5);
    CHECK(stores.next_write() == ticks_per_second);
    stores.write_due(ticks_per_second - 1);
    CHECK(folder.read("store/a.lua.json").contains("1"));
    stores.write_due(ticks_per_second);
    CHECK(folder.read("store/a.lua.json").contains("2"));
    stores.set("a.lua", "n", {std::int64_t{3}}, ticks_per_second + 1);
    stores.write_all();
    CHECK(folder.read("store/a.lua.json").contains("3"));

    ScriptStores later(folder.path() / "store");
    CHECK(*find_field(later.of("a.lua"), "n") == ScriptValue{std::int64_t{3}});
    CHECK(later.of("b.lua").empty());
}

TEST_CASE("a broken file is moved aside and the script begins anew") {
    TemporaryFolder folder;
    folder.write("store/a.lua.json", "{ broken");
    ScriptStores stores(folder.path() / "store");
    CHECK(stores.of("a.lua").empty());
    CHECK(folder.read("store/a.lua.json.broken") == "{ broken");
    stores.set("a.lua", "n", {true}, 0);
    stores.write_all();
    CHECK(folder.read("store/a.lua.json").contains("true"));
}

TEST_CASE("without a folder nothing is written") {
    ScriptStores stores({});
    stores.set("a.lua", "n", {true}, 0);
    CHECK(stores.next_write() == never);
    stores.write_all();
    CHECK(*find_field(stores.of("a.lua"), "n") == ScriptValue{true});
}
