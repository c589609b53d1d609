// SPDX-License-Identifier: MIT
#include "physics/batch.h"

#include "tests/support/batch_identity.h"

#include <doctest/doctest.h>

#include <cfenv>

using namespace hyrax;

namespace {

constexpr DocumentFrame full_hd{.dt = 1.0 / 60.0, .screen = {1920, 1080}, .object = {128, 128}};

// FNV-1a over the bytes of the numbers, the lowest first.
class Hash {
public:
    void add(double number) {
        auto bits = std::bit_cast<std::uint64_t>(number);
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) {
            value_ = (value_ ^ (bits & 0xff)) * 0x100000001b3;
        }
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

// Whole numbers all over the box.
DocumentState numbered_body(int number) {
    const double i = number;
    return {
        .x = std::fmod(i * 523.0, 1792.0),
        .y = std::fmod(i * 311.0, 952.0),
        .vx = std::fmod(i * 197.0, 2001.0) - 1000.0,
        .vy = std::fmod(i * 389.0, 1601.0) - 800.0,
    };
}

// Every body whose four numbers are special ones.
void push_special_bodies(DocumentBatch& batch, DocumentTwins& twins) {
    for (const double x : special_numbers) {
        for (const double y : special_numbers) {
            for (const double vx : special_numbers) {
                for (const double vy : special_numbers) {
                    batch.push_back({x, y, vx, vy});
                    twins.push_back({x, y, vx, vy});
                }
            }
        }
    }
}

}  // namespace

TEST_CASE("the kernels of this processor are named from the narrowest to the widest") {
    CHECK(available_kernels().front() == Kernel::scalar);
    CHECK(available_kernels().back() == best_kernel());
    CHECK(available_kernels().size() >= 2);
    CHECK(name(Kernel::avx512) == "avx512");
    for (const Kernel kernel : available_kernels()) {
        MESSAGE(name(kernel));
    }
}

TEST_CASE("every kernel gives the class's bits: random bodies, constants, boxes and steps") {
    for (const Kernel kernel : available_kernels()) {
        CAPTURE(name(kernel));
        CHECK(check_identity(kernel, 10'000'000) == 0);
    }
}

TEST_CASE("every kernel gives the class's bits: special numbers") {
    // The last three boxes are smaller than the body, in one or both directions, or just as large.
    constexpr std::array frames{
        full_hd,
        DocumentFrame{.dt = 0.0, .screen = {1920, 1080}, .object = {128, 128}},
        DocumentFrame{.dt = 1e300, .screen = {1920, 1080}, .object = {128, 128}},
        DocumentFrame{.dt = 1.0 / 60.0, .screen = {100, 1080}, .object = {128, 128}},
        DocumentFrame{.dt = 1.0 / 60.0, .screen = {0, 0}, .object = {128, 128}},
        DocumentFrame{.dt = 1.0 / 60.0, .screen = {128, 128}, .object = {128, 128}},
    };
    for (const Kernel kernel : available_kernels()) {
        for (const DocumentFrame& frame : frames) {
            CAPTURE(name(kernel));
            CAPTURE(frame.dt);
            CAPTURE(frame.screen.width);
            DocumentBatch batch;
            DocumentTwins twins({});
            push_special_bodies(batch, twins);
            for (int i = 0; i < 3; ++i) {
                batch.step(frame, kernel);
                twins.step(frame);
                REQUIRE(twins.differing(batch) == 0);
            }
        }
    }
}

TEST_CASE("batches of every size, and those that bodies have left, give the class's bits") {
    for (const Kernel kernel : available_kernels()) {
        CAPTURE(name(kernel));
        for (int size = 0; size <= 70; ++size) {
            CAPTURE(size);
            DocumentBatch batch;
            DocumentTwins twins({});
            for (int i = 0; i < size; ++i) {
                batch.push_back(numbered_body(i));
                twins.push_back(numbered_body(i));
            }
            RandomBits random(static_cast<std::uint64_t>(size));
            while (batch.size() > 0) {
                for (int i = 0; i < 4; ++i) {
                    batch.step(full_hd, kernel);
                    twins.step(full_hd);
                }
                REQUIRE(twins.differing(batch) == 0);
                const std::size_t leaving = random.below(batch.size());
                batch.erase(leaving);
                twins.erase(leaving);
                REQUIRE(twins.differing(batch) == 0);
            }
        }
    }
}

TEST_CASE("a step without a named kernel gives the class's bits, few bodies or many") {
    for (int size = 0; size <= 20; ++size) {
        DocumentBatch batch;
        DocumentTwins twins({});
        for (int i = 0; i < size; ++i) {
            batch.push_back(numbered_body(i));
            twins.push_back(numbered_body(i));
        }
        for (int i = 0; i < 100; ++i) {
            batch.step(full_hd);
            twins.step(full_hd);
        }
        CHECK(twins.differing(batch) == 0);
    }
}

TEST_CASE("the same run gives the same bits everywhere") {
    const auto hash_after_run = [](auto step) {
        DocumentBatch batch;
        for (int i = 0; i < 1001; ++i) {
            batch.push_back(numbered_body(i));
        }
        for (int i = 0; i < 600; ++i) {
            step(batch);
        }
        Hash hash;
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const DocumentState body = batch.get(i);
            for (const double number : {body.x, body.y, body.vx, body.vy}) {
                hash.add(number);
            }
        }
        return hash.value();
    };
    constexpr std::uint64_t golden = 14172854711536739167u;
    for (const Kernel kernel : available_kernels()) {
        CAPTURE(name(kernel));
        CHECK(hash_after_run([=](DocumentBatch& batch) { batch.step(full_hd, kernel); }) == golden);
    }
    CHECK(hash_after_run([](DocumentBatch& batch) { batch.step(full_hd); }) == golden);
}

TEST_CASE("the padding raises no floating-point exception but rounding") {
    for (const Kernel kernel : available_kernels()) {
        CAPTURE(name(kernel));
        DocumentBatch batch;
        batch.push_back(numbered_body(1));
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        batch.push_back({nan, nan, nan, nan});
        batch.erase(1);
        std::feclearexcept(FE_ALL_EXCEPT);
        for (int i = 0; i < 1000; ++i) {
            batch.step(full_hd, kernel);
        }
        CHECK(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW) == 0);
    }
}

TEST_CASE("bodies are kept, replaced, erased and cleared") {
    DocumentBatch batch({.gravity = 8.0});
    for (int i = 0; i < 20; ++i) {
        batch.push_back(numbered_body(i));
    }
    batch.set(7, {1.0, 2.0, 3.0, 4.0});
    CHECK(batch.get(7) == DocumentState{1.0, 2.0, 3.0, 4.0});
    CHECK(batch.get(6) == numbered_body(6));
    CHECK(batch.get(8) == numbered_body(8));

    batch.erase(3);
    CHECK(batch.size() == 19);
    CHECK(batch.get(3) == numbered_body(19));
    batch.erase(18);
    CHECK(batch.size() == 18);
    CHECK(batch.x().size() == 18);
    CHECK(batch.vy()[17] == numbered_body(17).vy);

    batch.clear();
    CHECK(batch.empty());
    CHECK(batch.constants().gravity == 8.0);
    batch.push_back(numbered_body(5));
    CHECK(batch.get(0) == numbered_body(5));
}

TEST_CASE("new constants take effect with the next step") {
    DocumentBatch batch;
    batch.push_back({});
    batch.set_constants({.gravity = 0.0});
    batch.step(full_hd);
    CHECK(batch.get(0) == DocumentState{});
}
