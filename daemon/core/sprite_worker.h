// SPDX-License-Identifier: MIT
// A thread that reads sprite sets while frames go on. There is none while nothing is read.
#pragma once

#include "daemon/core/sprite_reading.h"

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace hyrax {

/// Owned by one thread, which may destroy it at any time: that waits for the reading's end.
class SpriteWorker {
public:
    /// `wake` is called on the worker's thread once a reading is done.
    explicit SpriteWorker(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Only after take() has given back the one before.
    void begin(std::unique_ptr<SpriteReading> reading);
    /// A reading waits for take().
    bool done() const { return done_.load(std::memory_order_acquire); }
    /// The reading, if it is done; else null.
    std::unique_ptr<SpriteReading> take();

private:
    std::function<void()> wake_;
    std::unique_ptr<SpriteReading> reading_;
    std::atomic<bool> done_ = false;
    std::jthread thread_;  // The last member: it is waited for before the others go.
};

}  // namespace hyrax
