// SPDX-License-Identifier: MIT
// Many bodies of the document's model at once: one array for each number, stepped by the widest
// vectors that the processor has.
#pragma once

#include "physics/geometry.h"
#include "physics/physics.h"

#include <cstddef>
#include <new>
#include <span>
#include <string_view>
#include <vector>

namespace hyrax {

/// Position [px] and velocity [px/s] of one body.
struct DocumentState {
    double x = 0.0;
    double y = 0.0;
    double vx = 0.0;
    double vy = 0.0;
    bool operator==(const DocumentState&) const = default;
};

/// What physics::update takes: the time since the previous frame [s] and the sizes of box and body.
struct DocumentFrame {
    double dt = 0.0;
    Size screen;
    Size object;
};

/// How a batch is stepped. A processor that has one of them has all those before it.
enum class Kernel { scalar, sse2, avx2, avx512 };

std::string_view name(Kernel kernel);
/// The widest kernel of this processor under this system; found at the first call.
Kernel best_kernel();
/// From Kernel::scalar to best_kernel().
std::span<const Kernel> available_kernels();

/// One array of a batch: a multiple of `lanes` numbers, from the start of a cache line.
class BatchColumn {
public:
    /// The numbers in the widest vector, and in a cache line.
    static constexpr std::size_t lanes = 8;

    double* data() { return numbers_.data(); }
    double& operator[](std::size_t index) { return numbers_[index]; }
    double operator[](std::size_t index) const { return numbers_[index]; }
    std::span<const double> first(std::size_t count) const { return {numbers_.data(), count}; }
    /// Room for one more than `count` numbers; new ones are 0.
    void make_room(std::size_t count) {
        if (count == numbers_.size()) {
            numbers_.resize(count + lanes);
        }
    }

private:
    template <class Number>
    struct CacheLines {
        using value_type = Number;
        static constexpr std::align_val_t alignment{lanes * sizeof(Number)};

        Number* allocate(std::size_t count) {
            return static_cast<Number*>(::operator new(count * sizeof(Number), alignment));
        }
        void deallocate(Number* numbers, std::size_t) { ::operator delete(numbers, alignment); }
        bool operator==(const CacheLines&) const = default;
    };

    std::vector<double, CacheLines<double>> numbers_;
};

/// Bodies of one kind in one box. After each step every number has the bits that an object of
/// class physics has; only of NaNs C++ does not say which one comes out.
class DocumentBatch {
public:
    explicit DocumentBatch(const PhysicsConstants& constants = {}) : constants_(constants) {}

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    void push_back(const DocumentState& body);
    /// The last body takes the index of the erased one. Wants index < size(), as get and set do.
    void erase(std::size_t index);
    void clear();
    DocumentState get(std::size_t index) const;
    void set(std::size_t index, const DocumentState& body);

    /// One number of all bodies; valid until a body comes or goes.
    std::span<const double> x() const { return x_.first(size_); }
    std::span<const double> y() const { return y_.first(size_); }
    std::span<const double> vx() const { return vx_.first(size_); }
    std::span<const double> vy() const { return vy_.first(size_); }

    const PhysicsConstants& constants() const { return constants_; }
    /// Takes effect with the next step.
    void set_constants(const PhysicsConstants& constants) { constants_ = constants; }

    /// One frame for all bodies, with the kernel that is the quickest for so many.
    void step(const DocumentFrame& frame);
    /// The same with a kernel of available_kernels(); others end the program.
    void step(const DocumentFrame& frame, Kernel kernel);

private:
    PhysicsConstants constants_;
    std::size_t size_ = 0;
    // From size_ to the next multiple of BatchColumn::lanes stand bodies that began as zeros. The
    // kernels step them along: they fall and bounce like others, with vx = 0.
    BatchColumn x_, y_, vx_, vy_;
};

/// What a kernel reads and writes.
struct BatchArrays {
    double *x, *y, *vx, *vy;
    std::size_t bodies;  ///< Vectors go on to the next multiple of their width.
};

/// What a kernel is given. It copies the arrays' addresses: a store to an array could otherwise,
/// for all that the compiler knows, change them.
struct BatchStep {
    BatchArrays arrays;
    double dt;    ///< [s]
    double fall;  ///< gravity * dt [px/s]
    double air_drag;
    double reflection;  ///< -restitution
    double ground_friction;
    double rest_threshold;  ///< [px/s]
    double right, bottom;   ///< The largest position [px]; negative if the body exceeds the box.
};

void step_scalar(const BatchStep& step);
void step_sse2(const BatchStep& step);
void step_avx2(const BatchStep& step);
void step_avx512(const BatchStep& step);

}  // namespace hyrax
