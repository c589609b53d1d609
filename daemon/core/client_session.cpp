// SPDX-License-Identifier: MIT
#include "daemon/core/client_session.h"

namespace hyrax {

std::size_t ClientSession::wanted() const {
    if (step_ == Step::reading) {
        return reader_.wanted();
    }
    // It has nothing more to say, but its leaving must be heard.
    return step_ == Step::watching || step_ == Step::waiting ? 1 : 0;
}

void ClientSession::received(std::string_view bytes) {
    if (bytes.empty() || is_over()) {
        return;
    }
    if (step_ != Step::reading || reader_.feed(bytes) == FrameReader::State::broken) {
        step_ = Step::over;
    }
}

std::optional<std::string> ClientSession::take_request() {
    if (step_ != Step::reading || reader_.state() != FrameReader::State::complete) {
        return std::nullopt;
    }
    step_ = Step::waiting;
    deadline_ = never;
    return reader_.take();
}

bool ClientSession::answer(std::string_view text, Answer which, Ticks now) {
    const bool expected = step_ == Step::waiting || step_ == Step::watching;
    const std::size_t waiting = out_.size() - sent_;
    if (!expected || waiting + text.size() > max_unread) {
        step_ = Step::over;
        return false;
    }
    out_.erase(0, sent_);
    sent_ = 0;
    if (out_.empty()) {
        deadline_ = now + patience;
    }
    out_ += framed(text);
    watching_ = which == Answer::more;
    step_ = watching_ ? Step::watching : Step::answering;
    return true;
}

void ClientSession::sent(std::size_t bytes, Ticks now) {
    sent_ += bytes;
    // One answer has to be read in time; many are read as fast as the client likes, within bounds.
    if (bytes > 0 && step_ == Step::watching) {
        deadline_ = now + patience;
    }
    if (sent_ < out_.size()) {
        return;
    }
    out_.clear();
    sent_ = 0;
    deadline_ = never;
    if (step_ == Step::answering) {
        step_ = Step::over;
    }
}

void ClientSession::check_time(Ticks now) {
    if (now >= deadline_) {
        step_ = Step::over;
    }
}

}  // namespace hyrax
