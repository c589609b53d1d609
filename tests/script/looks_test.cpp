// SPDX-License-Identifier: MIT
// How pets look and walk, from a script.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

std::string error_of_pet(const std::string& call) {
    return errors_of("local p = hyrax.spawn() " + call);
}

}  // namespace

TEST_CASE("walking, playing, speaking, scale and facing go out as commands and are read at once") {
    FakeWorld world;
    world.add_pet({.position = {100, 960}});
    world.load(R"(
        local p = hyrax.pets{ all = true }[1]
        p:walk_to(40)                          assert(p.state == "walk" and p.vx == -120 and p.facing == "left")
        p:walk_to(400, 50)                     assert(p.vx == 50 and p.facing == "right")
        p:play("cheer")
        p:play("idle", { loop = true, fps = 12 })
        p:say("hello")
        p:say("bye", 0.5)
        p.scale = 2                            assert(p.scale == 2)
        p.facing = "left"                      assert(p.facing == "left")
        local q = hyrax.spawn{ scale = 0.5 }   assert(q.scale == 0.5 and q.w == 50 and q.h == 40)
        q:walk_to(5)                           assert(q.state == "fall")
    )");
    CHECK(world.errors() == "");
    const auto walks = world.given<command::WalkTo>();
    REQUIRE(walks.size() == 3);
    CHECK(walks[0].x == 40);
    CHECK(walks[0].speed == 120);
    CHECK(walks[1].speed == 50);
    const auto plays = world.given<command::Play>();
    REQUIRE(plays.size() == 2);
    CHECK(plays[0].animation == "cheer");
    CHECK_FALSE(plays[0].loop.has_value());
    CHECK(plays[1].loop == true);
    CHECK(plays[1].fps == 12);
    CHECK(world.given<command::Say>()[0].seconds == 3);
    CHECK(world.given<command::Say>()[1].text == "bye");
    CHECK(world.given<command::SetScale>()[0].scale == 2);
    CHECK(world.given<command::Face>()[0].left);
    CHECK(world.given<command::Spawn>()[0].options.scale == 0.5);
}

TEST_CASE("wrong arguments of looks are named") {
    CHECK(error_of_pet("p:walk_to(0/0)").contains("pet:walk_to: x must be a finite number"));
    CHECK(error_of_pet("p:walk_to(1, 0)").contains("pet:walk_to: speed must be from 1 to 20000"));
    CHECK(error_of_pet("p:walk_to()").contains("pet:walk_to: x must be a number, got no value"));
    CHECK(error_of_pet("p:play('chear')").contains("did you mean 'cheer'?"));
    CHECK(error_of_pet("p:play('idle', { lop = true })").contains("did you mean 'loop'?"));
    CHECK(error_of_pet("p:play('idle', { fps = 0 })").contains("fps must be from 0.1 to 120, got 0")
    );
    CHECK(error_of_pet("p:play('idle', { loop = 1 })").contains("loop must be true or false"));
    CHECK(error_of_pet("p:say(('x'):rep(201))").contains("pet:say: text must have at most 200"));
    CHECK(error_of_pet("p:say('a\\nb')").contains("without control characters"));
    CHECK(error_of_pet("p:say('a', -1)").contains("pet:say: seconds must be from 0.1 to 3600"));
    CHECK(error_of_pet("p.scale = 5").contains("pet.scale must be from 0.25 to 4, got 5"));
    CHECK(error_of_pet("p.scale = 'x'").contains("pet.scale must be a number, got string"));
    CHECK(error_of_pet("p.facing = 'rigth'").contains("did you mean 'right'?"));
    CHECK(error_of_pet("p.facing = 1").contains("pet.facing must be a string, got number"));
    CHECK(error_of_pet("p:remove() p:say('x')").contains("pet:say: this pet is gone"));
    CHECK(error_of_pet("p:remove() p.scale = 1").contains("pet.scale: this pet is gone"));
    CHECK(errors_of("hyrax.spawn{ scale = 9 }").contains("scale must be from 0.25 to 4"));
    CHECK(errors_of("local p = hyrax.spawn{ kind = 'rock' } p:play('anything')") == "");
}

TEST_CASE("collide tells both pets, one's own handler first the pet it is about") {
    FakeWorld world;
    const PetKey a = world.add_pet({.tag = "a"});
    const PetKey b = world.add_pet({.tag = "b"});
    world.load(R"(
        hyrax.on("collide", function(p, q, speed) print(p.tag, q.tag, speed) end)
        local second = hyrax.pets{ all = true, tag = "b" }[1]
        second:on("collide", function(p, q, speed) print("b", p.tag, q.tag, speed) end)
        hyrax.task(function()
            local other, speed = hyrax.wait_for(second, "collide")
            print("waited", other.tag, speed)
        end)
    )");
    CHECK(world.listens(EventKind::collide));
    world.happens_between({.kind = EventKind::collide, .speed = 5.5}, a, b);
    world.run();
    CHECK(world.errors() == "");
    CHECK(world.said() == "a b 5.5\nb b a 5.5\nwaited a 5.5\n");
    world.happens_between({.kind = EventKind::collide, .speed = 5.5}, a, 77);
    world.run();
    CHECK_FALSE(world.said().ends_with("77\n"));
    CHECK(world.errors() == "");
}

TEST_CASE("a pet that a handler removes is known to those who hear of it later") {
    FakeWorld world;
    const PetKey a = world.add_pet({.owner = "test.lua", .tag = "a"});
    const PetKey b = world.add_pet({.owner = "test.lua", .tag = "b"});
    world.load(R"(
        hyrax.on("collide", function(p, q) q:remove() end)
        hyrax.on("collide", function(p, q) print("then", p.tag, q.tag, q.valid) end)
        local first = hyrax.pets{ tag = "a" }[1]
        hyrax.task(function()
            local other = hyrax.wait_for(first, "collide")
            print("waited", other.tag, other.valid)
        end)
    )");
    world.happens_between({.kind = EventKind::collide, .speed = 5.5}, a, b);
    world.run();
    CHECK(world.errors() == "");
    CHECK(world.said() == "then a b false\nwaited b false\n");
}
