// SPDX-License-Identifier: MIT
// How texts travel on the control channel: their length in bytes as four bytes, the lowest first,
// then the text. Pure: the transports bring and take bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hyrax {

/// Bounds of a text [bytes]. `{}` is the shortest that can mean anything.
inline constexpr std::size_t min_message = 2;
inline constexpr std::size_t max_message = 65536;

/// The text with its length in front. It must keep the bounds.
std::string framed(std::string_view text);

/// Puts one text together from bytes that come in pieces.
class FrameReader {
public:
    enum class State : std::uint8_t {
        unfinished,
        complete,
        broken,  ///< The length is out of bounds. Stays so.
    };

    /// So many bytes may be read next, so that none of what follows the text is read; 0 when it is
    /// complete or broken.
    std::size_t wanted() const;
    /// At most wanted() bytes; more are ignored.
    State feed(std::string_view bytes);
    State state() const { return state_; }
    /// Nothing of a text has come yet.
    bool is_fresh() const { return header_bytes_ == 0; }
    /// The text that is complete; then reads the next one.
    std::string take();

private:
    std::size_t take_header(std::string_view bytes);

    State state_ = State::unfinished;
    std::size_t header_bytes_ = 0;  ///< 4 once the length is known.
    std::size_t length_ = 0;
    std::string text_;
};

}  // namespace hyrax
