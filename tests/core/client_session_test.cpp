// SPDX-License-Identifier: MIT
#include "daemon/core/client_session.h"

#include <doctest/doctest.h>

#include <random>
#include <string>

using namespace hyrax;

namespace {

constexpr Ticks second = ticks_per_second;

// A client that has asked; what it asked has been taken.
ClientSession asked() {
    ClientSession session(1, 0);
    session.received(framed("{}"));
    REQUIRE(session.take_request() == "{}");
    return session;
}

}  // namespace

TEST_CASE("one request, one answer, and it is over") {
    ClientSession session(7, 0);
    CHECK(session.id() == 7);
    CHECK(session.wanted() == 4);
    session.received(framed("{}").substr(0, 5));
    CHECK_FALSE(session.take_request().has_value());
    CHECK(session.wanted() == 1);
    session.received("}");
    CHECK(session.take_request() == "{}");
    CHECK_FALSE(session.take_request().has_value());
    CHECK(session.wanted() == 1);  // Its leaving must be heard, however long the answer takes.
    CHECK(session.due() == never);
    CHECK(session.answer("[1]", Answer::last, second));
    CHECK(session.unsent() == framed("[1]"));
    session.sent(3, second);
    CHECK(session.unsent().size() == 4);
    CHECK_FALSE(session.is_over());
    session.sent(4, second);
    CHECK(session.is_over());
    CHECK_FALSE(session.is_watching());
}

TEST_CASE("a request that comes slowly is not waited for") {
    ClientSession session(1, 0);
    const std::string bytes = framed(std::string(100, ' '));
    for (int i = 0; i < 19; ++i) {
        session.received(bytes.substr(static_cast<std::size_t>(i), 1));
        session.check_time(i * second / 10);
        CHECK_FALSE(session.is_over());
    }
    CHECK(session.due() == 2 * second);
    session.check_time(2 * second);
    CHECK(session.is_over());
    CHECK(session.due() == never);
}

TEST_CASE("an answer that is read slowly is not waited for") {
    ClientSession session = asked();
    session.check_time(1000 * second);  // the daemon's own time is nobody's fault
    CHECK_FALSE(session.is_over());
    session.answer(std::string(50'000, ' '), Answer::last, 1000 * second);
    session.sent(1, 1001 * second);
    CHECK(session.due() == 1002 * second);
    session.check_time(1002 * second);
    CHECK(session.is_over());
}

TEST_CASE("who watches hears more, as long as it reads") {
    ClientSession session = asked();
    CHECK(session.answer("[0]", Answer::more, 0));
    session.sent(session.unsent().size(), 0);
    CHECK_FALSE(session.is_over());
    CHECK(session.is_watching());
    CHECK(session.due() == never);
    CHECK(session.wanted() == 1);
    CHECK(session.answer("[1]", Answer::more, 10 * second));
    CHECK(session.answer("[2]", Answer::more, 11 * second));
    CHECK(session.unsent() == framed("[1]") + framed("[2]"));
    CHECK(session.due() == 12 * second);
    session.sent(7, 11 * second);
    CHECK(session.unsent() == framed("[2]"));
    CHECK(session.due() == 13 * second);
    session.check_time(13 * second);
    CHECK(session.is_over());
    CHECK(session.is_watching());
}

TEST_CASE("who watches and does not read is dropped when too much waits for it") {
    ClientSession session = asked();
    std::size_t taken = 0;
    while (session.answer(std::string(1000, ' '), Answer::more, 0)) {
        ++taken;
    }
    CHECK(taken > 200);
    CHECK(taken < 300);
    CHECK(session.is_over());
    CHECK_FALSE(session.answer("[]", Answer::more, 0));
}

TEST_CASE("anything but silence behind the request ends it") {
    ClientSession session = asked();
    session.answer("[0]", Answer::more, 0);
    session.received("x");
    CHECK(session.is_over());
    ClientSession broken(1, 0);
    broken.received("\xFF\xFF\xFF\xFF");
    CHECK(broken.is_over());
    ClientSession gone(1, 0);
    gone.left();
    CHECK(gone.is_over());
    CHECK(gone.wanted() == 0);
}

TEST_CASE("no order of calls breaks a session") {
    std::minstd_rand random(11);
    for (int i = 0; i < 5'000; ++i) {
        ClientSession session(1, 0);
        Ticks now = 0;
        for (int step = 0; step < 40; ++step) {
            now += static_cast<Ticks>(random() % 1000) * ticks_per_ms / 2;
            switch (random() % 6) {
                case 0:
                    session.received(framed(std::string(2 + random() % 50, 'x')));
                    break;
                case 1:
                    session.received(std::string(random() % 6, static_cast<char>(random() % 256)));
                    break;
                case 2:
                    static_cast<void>(session.take_request());
                    break;
                case 3:
                    session.answer("[]", random() % 2 == 0 ? Answer::last : Answer::more, now);
                    break;
                case 4:
                    session.sent(session.unsent().size() / (1 + random() % 2), now);
                    break;
                default:
                    session.check_time(now);
            }
            CHECK(session.unsent().size() <= ClientSession::max_unread + 8);
            CHECK((!session.is_over() || session.wanted() == 0));
        }
    }
}
