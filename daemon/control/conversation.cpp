// SPDX-License-Identifier: MIT
#include "daemon/control/conversation.h"

#include "daemon/core/framing.h"

#include <fmt/format.h>

namespace hyrax {

Result<void> Conversation::ask(std::string_view request) {
    if (request.size() > max_message) {
        return failure(
            fmt::format("the request has {} bytes, and {} is the most", request.size(), max_message)
        );
    }
    return connection_.write(framed(request));
}

Result<std::string> Conversation::answer() {
    const Result<std::optional<std::string>> text = receive(std::chrono::seconds(5));
    if (!text) {
        return std::unexpected(text.error());
    }
    if (!*text) {
        return failure("hyrax has closed the connection without an answer");
    }
    return **text;
}

Result<std::optional<std::string>> Conversation::more() {
    return receive(std::nullopt);
}

Result<std::optional<std::string>> Conversation::receive(
    std::optional<std::chrono::milliseconds> patience
) {
    FrameReader reader;
    while (reader.state() == FrameReader::State::unfinished) {
        const Result<std::string> bytes = connection_.read(reader.wanted(), patience);
        if (!bytes) {
            return std::unexpected(bytes.error());
        }
        if (bytes->empty()) {
            return reader.is_fresh() ? Result<std::optional<std::string>>(std::nullopt)
                                     : failure("hyrax has ended in the middle of an answer");
        }
        reader.feed(*bytes);
    }
    if (reader.state() == FrameReader::State::broken) {
        return failure("what answers does not speak as hyrax does");
    }
    return reader.take();
}

}  // namespace hyrax
