// SPDX-License-Identifier: MIT
#include "daemon/core/slot_map.h"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <string>

using namespace hyrax;

TEST_CASE("an id finds its value until it is erased, and nothing afterwards") {
    SlotMap<std::string> map;
    const SlotId a = map.insert("a");
    const SlotId b = map.insert("b");
    CHECK(*map.find(a) == "a");
    CHECK(map.erase(a));
    CHECK_FALSE(map.erase(a));
    CHECK(map.find(a) == nullptr);
    const SlotId c = map.insert("c");
    CHECK(c.index == a.index);
    CHECK(map.find(a) == nullptr);
    CHECK(*map.find(c) == "c");
    CHECK(*map.find(b) == "b");
    CHECK(map.find(SlotId{}) == nullptr);
    CHECK(map.find(SlotId{77, 1}) == nullptr);
    CHECK(map.size() == 2);
}

TEST_CASE("random inserts and erases agree with a map of ids") {
    SlotMap<int> map;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> model;
    std::mt19937 random(11);
    for (int i = 0; i < 20'000; ++i) {
        if (model.empty() || random() % 5 < 3) {
            const SlotId id = map.insert(i);
            CHECK(model.emplace(std::pair{id.index, id.generation}, i).second);
        } else {
            auto victim = model.begin();
            std::advance(victim, static_cast<long>(random() % model.size()));
            CHECK(map.erase({victim->first.first, victim->first.second}));
            model.erase(victim);
        }
        if (model.size() > 50) {
            for (const auto& [id, value] : model) {
                map.erase({id.first, id.second});
            }
            model.clear();
        }
    }
    std::size_t visited = 0;
    map.for_each([&](SlotId id, int value) {
        ++visited;
        CHECK(model.at({id.index, id.generation}) == value);
    });
    CHECK(visited == model.size());
    CHECK(map.size() == model.size());
}
