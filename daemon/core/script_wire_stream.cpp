// SPDX-License-Identifier: MIT
#include "daemon/core/script_wire.h"

#include <fmt/format.h>

#include <cstring>

namespace hyrax::wire {

void MessageStream::add(std::span<const std::byte> bytes) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(done_));
    done_ = 0;
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

Result<std::optional<std::span<const std::byte>>> MessageStream::next() {
    const auto rest = std::span<const std::byte>(bytes_).subspan(done_);
    std::uint32_t length = 0;
    if (rest.size() < sizeof length) {
        return std::nullopt;
    }
    std::memcpy(&length, rest.data(), sizeof length);
    if (length > longest_) {
        return failure(fmt::format(
            "broken message: its length is {} bytes, at most {} are allowed", length, longest_
        ));
    }
    if (rest.size() - sizeof length < length) {
        return std::nullopt;
    }
    done_ += sizeof length + length;
    return rest.subspan(sizeof length, length);
}

void MessageStream::clear() {
    bytes_.clear();
    done_ = 0;
}

}  // namespace hyrax::wire
