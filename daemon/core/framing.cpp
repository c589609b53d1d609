// SPDX-License-Identifier: MIT
#include "daemon/core/framing.h"

#include "daemon/core/check.h"

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

constexpr std::size_t header_size = 4;

bool fits(std::size_t length) {
    return length >= min_message && length <= max_message;
}

}  // namespace

std::string framed(std::string_view text) {
    HYRAX_CHECK(fits(text.size()));
    std::string bytes;
    bytes.reserve(header_size + text.size());
    for (std::size_t i = 0; i < header_size; ++i) {
        bytes += static_cast<char>((text.size() >> (8 * i)) & 0xFFU);
    }
    return bytes.append(text);
}

std::size_t FrameReader::wanted() const {
    if (state_ != State::unfinished) {
        return 0;
    }
    return header_bytes_ < header_size ? header_size - header_bytes_ : length_ - text_.size();
}

FrameReader::State FrameReader::feed(std::string_view bytes) {
    if (state_ != State::unfinished) {
        return state_;
    }
    bytes.remove_prefix(take_header(bytes));
    if (header_bytes_ < header_size) {
        return state_;
    }
    if (!fits(length_)) {
        return state_ = State::broken;
    }
    text_.append(bytes.substr(0, length_ - text_.size()));
    if (text_.size() == length_) {
        state_ = State::complete;
    }
    return state_;
}

std::string FrameReader::take() {
    std::string text = std::move(text_);
    *this = FrameReader();
    return text;
}

std::size_t FrameReader::take_header(std::string_view bytes) {
    std::size_t taken = 0;
    for (; header_bytes_ < header_size && taken < bytes.size(); ++taken, ++header_bytes_) {
        const std::size_t byte = static_cast<unsigned char>(bytes[taken]);
        length_ |= byte << (8 * header_bytes_);
    }
    return taken;
}

}  // namespace hyrax
