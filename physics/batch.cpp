// SPDX-License-Identifier: MIT
#include "physics/batch.h"

#include <array>

namespace hyrax {

namespace {

constexpr std::array kernels{Kernel::scalar, Kernel::sse2, Kernel::avx2, Kernel::avx512};
// In the same order.
constexpr std::array step_functions{&step_scalar, &step_sse2, &step_avx2, &step_avx512};

// A vector kernel spends the time of a full vector on a single body.
constexpr std::size_t fewest_for_vectors = 4;

Kernel detected_kernel() {
#ifdef __GNUC__
    // These ask the system as well: it must save the wide registers.
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f")) {
        return Kernel::avx512;
    }
    if (__builtin_cpu_supports("avx2")) {
        return Kernel::avx2;
    }
#endif
    // Every x86-64 has it. Visual C++ (untried) stays here.
    return Kernel::sse2;
}

}  // namespace

std::string_view name(Kernel kernel) {
    switch (kernel) {
        case Kernel::scalar:
            return "scalar";
        case Kernel::sse2:
            return "sse2";
        case Kernel::avx2:
            return "avx2";
        case Kernel::avx512:
            return "avx512";
    }
    return "";
}

Kernel best_kernel() {
    static const Kernel best = detected_kernel();
    return best;
}

std::span<const Kernel> available_kernels() {
    return std::span(kernels).first(static_cast<std::size_t>(best_kernel()) + 1);
}

void DocumentBatch::push_back(const DocumentState& body) {
    for (BatchColumn* column : {&x_, &y_, &vx_, &vy_}) {
        column->make_room(size_);
    }
    set(size_++, body);
}

void DocumentBatch::erase(std::size_t index) {
    --size_;
    set(index, get(size_));
    // What stood there may be at speeds that overflow some day.
    set(size_, {});
}

void DocumentBatch::clear() {
    *this = DocumentBatch(constants_);
}

DocumentState DocumentBatch::get(std::size_t index) const {
    return {.x = x_[index], .y = y_[index], .vx = vx_[index], .vy = vy_[index]};
}

void DocumentBatch::set(std::size_t index, const DocumentState& body) {
    x_[index] = body.x;
    y_[index] = body.y;
    vx_[index] = body.vx;
    vy_[index] = body.vy;
}

void DocumentBatch::step(const DocumentFrame& frame) {
    step(frame, size_ < fewest_for_vectors ? Kernel::scalar : best_kernel());
}

void DocumentBatch::step(const DocumentFrame& frame, Kernel kernel) {
    // Each product and negation gives the bits that the same operation gives in physics::update.
    step_functions[static_cast<std::size_t>(kernel)]({
        .arrays = {x_.data(), y_.data(), vx_.data(), vy_.data(), size_},
        .dt = frame.dt,
        .fall = constants_.gravity * frame.dt,
        .air_drag = constants_.air_drag,
        .reflection = -constants_.restitution,
        .ground_friction = constants_.ground_friction,
        .rest_threshold = constants_.rest_threshold,
        .right = static_cast<double>(frame.screen.width - frame.object.width),
        .bottom = static_cast<double>(frame.screen.height - frame.object.height),
    });
}

}  // namespace hyrax
