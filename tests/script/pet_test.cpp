// SPDX-License-Identifier: MIT
// Pets from a script: spawning, reading, verbs, filters, handles of pets that are gone.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

using namespace hyrax;

TEST_CASE("spawn gives a pet that can be read and changed at once") {
    FakeWorld world;
    world.load(R"(
        local p = hyrax.spawn{ kind = "rock", x = 10, y = 20, vx = 3, vy = -4, tag = "t" }
        assert(p.valid and p.kind == "rock" and p.owner == "test.lua" and p.tag == "t")
        assert(p.x == 10 and p.y == 20 and p.vx == 3 and p.vy == -4)
        assert(p.w == 40 and p.h == 40 and p.state == "fall" and p.facing == "right")
        assert(math.type(p.id) == "integer" and #hyrax.pets() == 1 and hyrax.pets()[1] == p)
        p:fling(1, 2)      assert(p.vx == 1 and p.vy == 2)
        p:push(10, 20)     assert(p.vx == 11 and p.vy == 22)
        p:stop()           assert(p.vx == 0 and p.vy == 0)
        p:move_to(7, 8)    assert(p.x == 7 and p.y == 8)
        p:reset()          assert(p.x == 10 and p.y == 20)
        p.tag = "new"      assert(p.tag == "new")
        assert(tostring(p):find("^pet %-?%d+$"))
    )");
    CHECK(world.errors() == "");
    REQUIRE(world.given<command::Spawn>().size() == 1);
    const command::Spawn spawn = world.given<command::Spawn>()[0];
    CHECK((spawn.key & script_made_key) != 0);
    CHECK(spawn.options.kind == "rock");
    CHECK(spawn.options.at == Vec2{10, 20});
    CHECK(spawn.options.velocity == Vec2{3, -4});
    CHECK(spawn.options.owner == "test.lua");
    CHECK(world.given<command::Fling>()[0].velocity == Vec2{1, 2});
    CHECK(world.given<command::Push>()[0].change == Vec2{10, 20});
    CHECK(world.given<command::Stop>().size() == 1);
    CHECK(world.given<command::MoveTo>()[0].position == Vec2{7, 8});
    CHECK(world.given<command::Reset>()[0].pet == spawn.key);
    CHECK(world.given<command::SetTag>()[0].tag == "new");
    CHECK(world.commands.size() == 7);
}

TEST_CASE("a pet without a place appears at the top of some screen, the same with the same seed") {
    const auto places = [](std::uint64_t seed) {
        FakeWorld world(ScriptLimits{.seed = seed});
        world.load("for i = 1, 20 do hyrax.spawn() end");
        std::vector<double> xs;
        for (const command::Spawn& spawn : world.given<command::Spawn>()) {
            REQUIRE(spawn.options.at.has_value());
            CHECK(spawn.options.at->y == 0);
            CHECK(spawn.options.at->x >= -1280);
            CHECK(spawn.options.at->x <= 1820);
            xs.push_back(spawn.options.at->x);
        }
        return xs;
    };
    CHECK(places(1) == places(1));
    CHECK(places(1) != places(2));
}

TEST_CASE("later runs see what the world made of it") {
    FakeWorld world;
    world.load(R"(
        p = hyrax.spawn{ x = 0, y = 0 }
        hyrax.every(1 / 60, function() print(p.y > 0, p.vy > 0) end)
    )");
    world.play(0.1);
    CHECK(world.errors() == "");
    CHECK(world.said().starts_with("true true\n"));
}

TEST_CASE("wrong arguments of spawn are named") {
    CHECK(errors_of("hyrax.spawn{ knd = 'hyrax' }").contains("did you mean 'kind'?"));
    CHECK(errors_of("hyrax.spawn{ x = 0/0 }").contains("hyrax.spawn: x must be a finite number"));
    CHECK(errors_of("hyrax.spawn{ vy = -1/0 }").contains("hyrax.spawn: vy must be a finite"));
    CHECK(
        errors_of("hyrax.spawn{ x = '1' }").contains("hyrax.spawn: x must be a number, got string")
    );
    CHECK(errors_of("hyrax.spawn(42)").contains("must be a table, got number"));
    CHECK(errors_of("hyrax.spawn{ 'hyrax' }").contains("options have names"));
    CHECK(errors_of("hyrax.spawn{ kind = 'hyrx' }").contains("did you mean 'hyrax'?"));
    CHECK(errors_of("hyrax.spawn{ kind = ('x'):rep(1e5) }").contains("at most 64 bytes"));
    CHECK(errors_of("hyrax.spawn{ tag = ('x'):rep(65) }").contains("at most 64 bytes"));
    CHECK(errors_of("hyrax.spawn{ tag = 'a\\nb' }").contains("without control characters"));
    CHECK(errors_of("hyrax.spawn{ tag = '\\xff' }").contains("must be UTF-8"));
    CHECK(errors_of("hyrax.spawn{ tag = true }").contains("hyrax.spawn: tag must be a string"));
}

TEST_CASE("wrong arguments of a pet's methods are named, and change nothing") {
    const auto error = [](const std::string& call) {
        FakeWorld world;
        world.load(
            "local p = hyrax.spawn{ x = 0, y = 0 } hyrax.on('ready', function() " + call + " end)"
        );
        CHECK(world.commands.size() == 1);
        return world.errors();
    };
    CHECK(error("p:fling(0/0, 1)").contains("test.lua:1: pet:fling: vx must be a finite number"));
    CHECK(error("p:fling(1, 1/0)").contains("pet:fling: vy must be a finite number"));
    CHECK(error("p:fling('1', 1)").contains("pet:fling: vx must be a number, got string"));
    CHECK(error("p:fling()").contains("pet:fling: vx must be a number, got no value"));
    CHECK(error("p.fling(1, 2, 3)").contains("expected a pet, got number"));
    CHECK(error("p.fling({}, 2, 3)").contains("expected a pet, got table"));
    CHECK(error("p:push(0, {})").contains("pet:push: dvy must be a number"));
    CHECK(error("p:move_to(0/0, 0)").contains("pet:move_to: x must be a finite number"));
    CHECK(error("p.tag = 5").contains("pet.tag must be a string"));
    CHECK(error("p.x = 5").contains("pet.x can only be read"));
    CHECK(error("p.speed = 5").contains("unknown field 'speed'"));
    CHECK(error("print(p.knd)").contains("did you mean 'kind'?"));
    CHECK(error("p[1] = 5").contains("unknown field"));
    CHECK(error("print(p[1])").contains("fields have names"));
}

TEST_CASE("velocities are shortened to the limit and keep their direction") {
    FakeWorld world;
    world.load(R"(
        local p = hyrax.spawn{ x = 0, y = 0 }
        p:fling(3e300, -4e300)
        assert(p.vx > 11999.9 and p.vx < 12000.1 and p.vy < -15999.9 and p.vy > -16000.1)
        p:fling(1.7e308, 1.7e308)
        assert(p.vx > 14142 and p.vx < 14143)
        p:fling(300, 400)
        p:push(1e9, 0)
        assert(p.vx <= 20000)
    )");
    CHECK(world.errors() == "");
}

TEST_CASE("filters") {
    FakeWorld world;
    world.add_pet({.tag = "a", .position = {500, 500}});
    world.add_pet({.kind = "rock", .tag = "b", .position = {600, 500}});
    world.load(R"(
        local mine = hyrax.spawn{ x = 0, y = 0, tag = "a" }
        assert(#hyrax.pets() == 1 and #hyrax.pets{ all = true } == 3)
        assert(#hyrax.pets{ tag = "a" } == 1 and #hyrax.pets{ all = true, tag = "a" } == 2)
        assert(#hyrax.pets{ all = true, kind = "rock" } == 1)
        -- the middle of the first is (550, 540)
        assert(#hyrax.pets{ all = true, near = { x = 550, y = 540, r = 0 } } == 1)
        assert(#hyrax.pets{ all = true, near = { x = 550, y = 540, r = 100 } } == 2)
        assert(hyrax.pet_at(10, 10) == mine and hyrax.pet_at(5000, 0) == nil)
        assert(hyrax.pet_at(599, 579).tag == "a" and hyrax.pet_at(600, 579).tag == "b")
        hyrax.fling({ all = true, tag = "a" }, 5, 6)
        assert(mine.vx == 5 and hyrax.pets{ all = true, kind = "rock" }[1].vx == 0)
        hyrax.fling(nil, 7, 8)
        assert(mine.vx == 7)
    )");
    CHECK(world.errors() == "");
    CHECK(world.given<command::Fling>().size() == 3);
    CHECK(errors_of("hyrax.pets{ al = true }").contains("did you mean 'all'?"));
    CHECK(errors_of("hyrax.pets{ all = 1 }").contains("hyrax.pets: all must be true or false"));
    CHECK(errors_of("hyrax.pets{ near = { x = 1, y = 2 } }").contains("needs x, y and r"));
    CHECK(errors_of("hyrax.pets{ near = { x = 1, y = 2, radius = 3 } }").contains("unknown option")
    );
    CHECK(errors_of("hyrax.fling({}, 1)").contains("hyrax.fling: vy must be a number"));
    CHECK(errors_of("hyrax.pet_at(1)").contains("hyrax.pet_at: y must be a number"));
}

TEST_CASE("the topmost of two pets is found") {
    FakeWorld world;
    world.add_pet({.tag = "below"});
    world.add_pet({.tag = "above"});
    world.load("assert(hyrax.pet_at(5, 5).tag == 'above')");
    CHECK(world.errors() == "");
}

TEST_CASE("verbs for all reach the pets of others only if they may") {
    const std::string text =
        "hyrax.spawn() hyrax.reset() hyrax.clear() assert(#hyrax.pets{all=true} == N)";
    FakeWorld may;
    may.add_pet();
    may.load("N = 0 " + text);
    CHECK(may.errors() == "");
    CHECK(may.given<command::Reset>().size() == 2);
    CHECK(may.given<command::Remove>().size() == 2);

    FakeWorld may_not;
    may_not.permissions = {};
    const PetKey pet = may_not.add_pet();
    may_not.load(
        "N = 1 " + text + " hyrax.on('ready', function() hyrax.pets{all=true}[1]:fling(1, 2) end)"
    );
    CHECK(may_not.errors().contains("pet:fling: this pet belongs to 'user'"));
    CHECK(may_not.given<command::Remove>().size() == 1);
    CHECK(may_not.find(pet) != nullptr);
}

TEST_CASE("a pet that is gone: valid, id and tag are read, everything else is a clean error") {
    FakeWorld world;
    world.load(R"(
        local p = hyrax.spawn{ tag = "ghost" }
        local id = p.id
        p:remove()
        local q = hyrax.spawn()
        assert(not p.valid and p.id == id and p.tag == "ghost" and q.valid and p ~= q)
        assert(pcall(p.remove, p) and #hyrax.pets() == 1)
        for _, field in ipairs{ "kind", "owner", "x", "y", "vx", "vy", "w", "h", "state", "facing" } do
            local ok, message = pcall(function() return p[field] end)
            assert(not ok and message:find("this pet is gone"), field)
        end
        for _, method in ipairs{ "fling", "push", "stop", "reset", "move_to", "on" } do
            local ok, message = pcall(p[method], p, method == "on" and "land" or 1, print)
            assert(not ok, method)
        end
        assert(not pcall(p.fling, p, 1, 1) and not pcall(function() p.tag = "x" end))
        assert(select(2, pcall(p.on, p, "land", print)):find("gone"))
    )");
    CHECK(world.errors() == "");
    CHECK(world.given<command::Remove>().size() == 1);
}

TEST_CASE("a pet taken away by the world is gone in the next run") {
    FakeWorld world;
    const PetKey key = world.add_pet({.tag = "mine"});
    world.load(R"(
        pet = hyrax.pets{ all = true }[1]
        hyrax.every(0.015, function() print(pet.valid, pet.tag, pet.id) end)
    )");
    world.skip(0.015);
    world.take_away(key);
    world.skip(0.015);
    CHECK(world.said() == "true mine 1\nfalse mine 1\n");
}

TEST_CASE("the same pet is the same handle, also as a key, until its removal was told") {
    FakeWorld world;
    world.load(R"(
        local seen = {}
        local p = hyrax.spawn()
        seen[p] = "first"
        hyrax.on("remove", function(pet) print(seen[pet], pet == p) end)
        hyrax.after(0.1, function()
            assert(seen[hyrax.pets()[1]] == "first")
            p:remove()
        end)
    )");
    world.play(0.3);
    CHECK(world.errors() == "");
    CHECK(world.said() == "first true\n");
}

TEST_CASE("keys of pets that an earlier host made are not given again") {
    FakeWorld world;
    world.add_pet();
    world.world.pets.back().key = script_made_key | 41U;
    world.load("hyrax.spawn()");
    CHECK(world.given<command::Spawn>()[0].key == (script_made_key | 42U));
}

TEST_CASE("handles protect their metatable") {
    CHECK(errors_of(R"(
        local p = hyrax.spawn()
        assert(getmetatable(p) == false and not pcall(setmetatable, p, {}))
        assert(getmetatable(hyrax.on("land", print)) == false)
        assert(not pcall(function() return p.__gc end) and not pcall(function() return p.__index end))
    )") == "");
}
