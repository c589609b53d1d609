// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_worker.h"

#include "daemon/core/plugins.h"
#include "daemon/core/png_header.h"
#include "tests/support/png_header.h"
#include "tests/support/profile_folder.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <semaphore>
#include <string>

using namespace hyrax;

namespace {

std::string sprite_json(int width, int height) {
    const std::string size =
        "\"width\": " + std::to_string(width) + ", \"height\": " + std::to_string(height);
    return "{\"sheet\": \"sheet.png\", \"cell\": {" + size + "}, \"box\": {\"x\": 0, \"y\": 0, " +
           size + "}, \"animations\": {\"idle\": {\"frames\": [{\"cell\": 0, \"ms\": 100}]}}}";
}

void write_set(const TemporaryFolder& folder, const std::string& place, Size size) {
    folder.write(place + "/sprite.json", sprite_json(size.width, size.height));
    folder.write(place + "/sheet.png", png_header(size.width, size.height));
}

/// The only one, with one kind.
std::vector<PluginEntry> own_plugin(const TemporaryFolder& folder, PluginState state) {
    write_set(folder, "own/pet", {64, 64});
    Plugin plugin{.folder = folder.path() / "own", .id = "own"};
    plugin.kinds.push_back({"pet", "pet/sprite.json"});
    std::vector<PluginEntry> plugins(1);
    plugins[0] = {.id = "own", .plugin = std::move(plugin), .state = state};
    return plugins;
}

std::vector<ReadKind> read_by(SpriteReading& reading) {
    Result<std::vector<ReadKind>> kinds = reading.take();
    REQUIRE_MESSAGE(kinds, kinds.error().message);
    return *std::move(kinds);
}

/// A set of that size that has been read.
SpriteSet loaded(std::string name, Size size) {
    SpriteSet set = placeholder_sprite_set(std::move(name));
    set.sheet = Image(size);
    return set;
}

}  // namespace

TEST_CASE(
    "sprite reading: all sheets together have a limit, which counts before a picture is decoded"
) {
    const TemporaryFolder folder;
    constexpr Size large{4096, 4096};
    write_set(folder, "user/sprites/a", large);
    write_set(folder, "user/sprites/b", {4096, 4095});
    write_set(folder, "user/sprites/c", {4096, 2});
    write_set(folder, "user/sprites/d", {64, 64});
    const std::vector<PluginEntry> plugins = own_plugin(folder, PluginState::on);
    std::vector<Size> decoded;
    const ImageDecoder decode = [&](std::span<const std::byte> file) -> Result<Image> {
        decoded.push_back(*png_size(file));
        return Image(decoded.back());
    };
    SpriteReading reading(profile_in(folder), plugins, decode);
    reading.run();
    const std::vector<ReadKind> kinds = read_by(reading);
    REQUIRE(kinds.size() == 5);
    CHECK(kinds[0].set);
    CHECK(kinds[1].set);
    REQUIRE_FALSE(kinds[2].set);
    CHECK(kinds[2].set.error().message.ends_with(
        "sheet.png: has 8192 pixels, but there is room for 4096 more: all sheets together have at "
        "most 33554432"
    ));
    CHECK(kinds[3].set);
    CHECK(kinds[4].name == "own/pet");
    REQUIRE_FALSE(kinds[4].set);
    CHECK(kinds[4].set.error().message.contains("there is room for 0 more"));
    CHECK(decoded.size() == 3);
}

TEST_CASE("sprite reading: whoever wants room, the hyrax has it first") {
    const TemporaryFolder folder;
    write_set(folder, "user/sprites/big", {8192, 4096});
    write_set(folder, "user/sprites/hyrax", {64, 64});
    const ImageDecoder decode = [](std::span<const std::byte> file) -> Result<Image> {
        return Image(*png_size(file));
    };
    const std::vector<ReadKind> kinds = load_kinds(profile_in(folder), decode);
    REQUIRE(kinds.size() == 2);
    CHECK(kinds[0].name == "big");
    CHECK_FALSE(kinds[0].set);
    CHECK(kinds[1].set);
}

TEST_CASE("sprite reading: a plugin that is off is not read") {
    const TemporaryFolder folder;
    write_set(folder, "user/sprites/a", {64, 64});
    const std::vector<PluginEntry> plugins = own_plugin(folder, PluginState::off);
    SpriteReading one(profile_in(folder), plugins, [](std::span<const std::byte>) -> Result<Image> {
        return Image(Size{64, 64});
    });
    one.run();
    CHECK(read_by(one).size() == 1);
}

TEST_CASE("sprite reading: a set whose picture finds no memory stays as it was, the others come") {
    const TemporaryFolder folder;
    for (const char* name : {"ant", "cat", "hyrax"}) {
        write_set(folder, std::string("user/sprites/") + name, {64, 64});
    }
    int decoded = 0;
    const ImageDecoder decode = [&decoded](std::span<const std::byte>) -> Result<Image> {
        if (++decoded == 3) {
            throw std::bad_alloc();
        }
        return Image(Size{64, 64});
    };
    SpriteReading reading(profile_in(folder), {}, decode);
    reading.run();
    const LoadedKinds kinds = completed(
        read_by(reading),
        {loaded("ant", {8, 8}), loaded("cat", {8, 8}), loaded("hyrax", {8, 8})},
        profile_in(folder)
    );
    REQUIRE(kinds.sets.size() == 3);
    CHECK(kinds.sets[0].sheet.size == Size{64, 64});
    CHECK(kinds.sets[1].sheet.size == Size{8, 8});  // "cat" is read last
    CHECK(kinds.sets[2].sheet.size == Size{64, 64});
    REQUIRE(kinds.problems.size() == 1);
    CHECK(kinds.problems[0].contains("cat: cannot be read: "));
}

TEST_CASE("what stays as it was needs room, too") {
    const TemporaryFolder folder;
    std::vector<ReadKind> read;
    read.push_back({"a", loaded("a", {4096, 4096})});
    read.push_back({"b", failure("b is broken")});
    read.push_back({"c", failure("c is broken")});
    std::vector<SpriteSet> before;
    before.push_back(loaded("b", {4096, 4096}));
    before.push_back(loaded("c", {64, 64}));
    const LoadedKinds kinds = completed(std::move(read), std::move(before), profile_in(folder));
    REQUIRE(kinds.sets.size() == 3);
    CHECK(kinds.sets[1].name == "a");
    CHECK(kinds.sets[2].name == "b");  // the first one has taken what there was
}

TEST_CASE("sprite worker: it says when it is done, gives the reading back, and takes the next one"
) {
    const TemporaryFolder folder;
    write_set(folder, "user/sprites/a", {64, 64});
    std::binary_semaphore go{0};
    std::counting_semaphore<> woken{0};
    const ImageDecoder slow = [&go](std::span<const std::byte>) -> Result<Image> {
        go.acquire();
        return Image(Size{64, 64});
    };
    SpriteWorker worker([&woken] { woken.release(); });
    CHECK(worker.take() == nullptr);
    for (int i = 0; i < 3; ++i) {
        worker.begin(std::make_unique<SpriteReading>(
            profile_in(folder), std::span<const PluginEntry>(), slow
        ));
        CHECK_FALSE(worker.done());
        CHECK(worker.take() == nullptr);
        go.release();
        woken.acquire();
        CHECK(worker.done());
        const std::unique_ptr<SpriteReading> done = worker.take();
        REQUIRE(done != nullptr);
        CHECK(read_by(*done).size() == 1);
        CHECK_FALSE(worker.done());
        CHECK(worker.take() == nullptr);
    }
    // One that nobody takes is waited for.
    worker.begin(
        std::make_unique<SpriteReading>(profile_in(folder), std::span<const PluginEntry>(), slow)
    );
    go.release();
}
