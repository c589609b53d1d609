// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_worker.h"

#include "daemon/core/check.h"

#include <system_error>
#include <utility>

namespace hyrax {

void SpriteWorker::begin(std::unique_ptr<SpriteReading> reading) {
    HYRAX_CHECK(reading_ == nullptr);
    reading_ = std::move(reading);
    const auto work = [this] {
        reading_->run();
        done_.store(true, std::memory_order_release);
        wake_();
    };
    try {
        thread_ = std::jthread(work);
    } catch (const std::system_error&) {
        work();  // The system gives no thread: late frames are better than old pictures.
    }
}

std::unique_ptr<SpriteReading> SpriteWorker::take() {
    if (!done()) {
        return nullptr;
    }
    if (thread_.joinable()) {
        thread_.join();
    }
    done_.store(false, std::memory_order_relaxed);
    return std::move(reading_);
}

}  // namespace hyrax
