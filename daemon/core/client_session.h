// SPDX-License-Identifier: MIT
// One client of the control channel, from its first byte to its last: one request, one answer, or
// many answers. Pure: a transport brings and takes the bytes, and asks whether they are late.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/framing.h"
#include "physics/ticks.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hyrax {

class ClientSession {
public:
    /// A request must be complete, and an answer be read, within this time.
    static constexpr Ticks patience = 2 * ticks_per_second;
    /// A client that leaves more than this unread is dropped [bytes].
    static constexpr std::size_t max_unread = 256U << 10U;

    ClientSession(ClientId id, Ticks now) : id_(id), deadline_(now + patience) {}

    ClientId id() const { return id_; }

    /// So many bytes may be read from the client now.
    std::size_t wanted() const;
    /// What the client has sent. Anything behind its request ends the session.
    void received(std::string_view bytes);
    /// The client has closed its side.
    void left() { step_ = Step::over; }
    /// The request, once, when it is complete.
    std::optional<std::string> take_request();

    /// An answer; Answer::more keeps the client. False: it has not been taken, the session is over.
    bool answer(std::string_view text, Answer which, Ticks now);
    /// What waits to be sent.
    std::string_view unsent() const { return std::string_view(out_).substr(sent_); }
    void sent(std::size_t bytes, Ticks now);

    /// The last answer is sent, or something went wrong: the connection has to be closed.
    bool is_over() const { return step_ == Step::over; }
    /// More answers were meant to come.
    bool is_watching() const { return watching_; }
    /// When check_time() may end the session; `never` while nothing is expected of the client.
    Ticks due() const { return is_over() ? never : deadline_; }
    /// Ends the session when its time is over.
    void check_time(Ticks now);

private:
    enum class Step : std::uint8_t { reading, waiting, answering, watching, over };

    ClientId id_;
    Step step_ = Step::reading;
    Ticks deadline_;
    FrameReader reader_;
    std::string out_;
    std::size_t sent_ = 0;
    bool watching_ = false;
};

}  // namespace hyrax
