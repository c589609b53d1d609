// SPDX-License-Identifier: MIT
#include "daemon/control/client.h"

#include "daemon/control/conversation.h"

namespace hyrax {

Result<Talk> Client::ask(std::string_view request) const {
    Result<std::unique_ptr<Connection>> connection = system_.connect(profile_);
    if (!connection) {
        return std::unexpected(connection.error());
    }
    Conversation conversation(**connection);
    if (const Result<void> asked = conversation.ask(request); !asked) {
        return std::unexpected(asked.error());
    }
    Result<std::string> answer = conversation.answer();
    if (!answer) {
        return std::unexpected(answer.error());
    }
    return Talk{*std::move(connection), *std::move(answer)};
}

}  // namespace hyrax
