// SPDX-License-Identifier: MIT
#include "daemon/win32/pipe_server.h"

#include "daemon/control/connection.h"
#include "daemon/control/conversation.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/durable_file.h"
#include "daemon/win32/pipe_name.h"
#include "daemon/win32/single_instance.h"
#include "daemon/win32/text.h"
#include "daemon/win32/user.h"
#include "tests/support/temporary_folder.h"

#include <aclapi.h>
#include <doctest/doctest.h>
#include <sddl.h>

#include <atomic>
#include <string>
#include <thread>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

/// Answers every request with itself, as the daemon's one thread would, and counts its rounds.
class Echo {
public:
    explicit Echo(const std::filesystem::path& profile) {
        const std::wstring instance = instance_name(profile).value();
        auto server = PipeServer::open(pipe_name(instance).value());
        if (!server) {
            FAIL(server.error().message);
        }
        server_ = *std::move(server);
        thread_ = std::thread([this] { run(); });
    }
    ~Echo() { stop(); }
    void stop() {
        stopping_ = true;
        if (thread_.joinable()) {
            thread_.join();
        }
    }
    std::uint64_t rounds() const { return rounds_; }

private:
    void run() {
        std::vector<Input> inbox;
        while (!stopping_) {
            ::WaitForSingleObject(server_->event(), 10);
            server_->serve(clock_now(), inbox);
            for (const Input& each : std::exchange(inbox, {})) {
                if (const auto* asked = std::get_if<input::Asked>(&each)) {
                    server_->answer(asked->client, asked->text, Answer::last, clock_now());
                }
            }
            ++rounds_;
        }
        server_.reset();
    }

    std::unique_ptr<PipeServer> server_;
    std::atomic<bool> stopping_ = false;
    std::atomic<std::uint64_t> rounds_ = 0;
    std::thread thread_;
};

std::unique_ptr<Connection> connected(const std::filesystem::path& profile) {
    auto connection = make_control_system(0, nullptr)->connect(profile);
    if (!connection) {
        FAIL(connection.error().message);
    }
    return *std::move(connection);
}

std::string echoed(const std::filesystem::path& profile, std::string_view text) {
    const auto connection = connected(profile);
    Conversation conversation(*connection);
    REQUIRE(conversation.ask(text).has_value());
    const Result<std::string> answer = conversation.answer();
    return answer ? *answer : "failed: " + answer.error().message;
}

std::wstring text_of(PSECURITY_DESCRIPTOR descriptor, SECURITY_INFORMATION what) {
    wchar_t* text = nullptr;
    REQUIRE(
        ::ConvertSecurityDescriptorToStringSecurityDescriptorW(
            descriptor, SDDL_REVISION_1, what, &text, nullptr
        ) != 0
    );
    const LocalMemory owner(text);
    return text;
}

std::wstring security_of(const std::filesystem::path& profile, SECURITY_INFORMATION what) {
    const std::wstring name = pipe_name(instance_name(profile).value()).value();
    const KernelObject pipe =
        owned_file(::CreateFileW(name.c_str(), READ_CONTROL, 0, nullptr, OPEN_EXISTING, 0, nullptr)
        );
    PSECURITY_DESCRIPTOR descriptor = nullptr;
    const DWORD code = ::GetSecurityInfo(
        pipe.raw(), SE_KERNEL_OBJECT, what, nullptr, nullptr, nullptr, nullptr, &descriptor
    );
    REQUIRE(code == ERROR_SUCCESS);
    const LocalMemory memory(descriptor);
    return text_of(descriptor, what);
}

// Whether the first entry of the system's list keeps programs below medium integrity from writing.
bool asks_for_medium_integrity(PSECURITY_DESCRIPTOR descriptor) {
    BOOL present = FALSE;
    BOOL defaulted = FALSE;
    PACL list = nullptr;
    void* entry = nullptr;
    if (::GetSecurityDescriptorSacl(descriptor, &present, &list, &defaulted) == 0 || !present ||
        ::GetAce(list, 0, &entry) == 0) {
        return false;
    }
    auto* const label = static_cast<SYSTEM_MANDATORY_LABEL_ACE*>(entry);
    return label->Header.AceType == SYSTEM_MANDATORY_LABEL_ACE_TYPE &&
           label->Mask == SYSTEM_MANDATORY_LABEL_NO_WRITE_UP &&
           *::GetSidSubAuthority(&label->SidStart, 0) == SECURITY_MANDATORY_MEDIUM_RID;
}

}  // namespace

TEST_CASE("requests and answers of every size go through the pipe, one after the other") {
    const TemporaryFolder profile;
    Echo echo(profile.path());
    for (const std::size_t size : {2U, 100U, 4096U, 20'000U, 65'536U}) {
        CHECK(echoed(profile.path(), std::string(size, 'x')) == std::string(size, 'x'));
    }
    for (int i = 0; i < 50; ++i) {
        CHECK(echoed(profile.path(), "{}") == "{}");
    }
}

TEST_CASE("the pipe belongs to the user, who alone may open it") {
    const TemporaryFolder profile;
    Echo echo(profile.path());
    const std::wstring user = user_sid().value();
    CHECK(security_of(profile.path(), OWNER_SECURITY_INFORMATION) == L"O:" + user);
    const std::wstring access = security_of(profile.path(), DACL_SECURITY_INFORMATION);
    // One entry, protected. Wine shows generic rights as they are, Windows as those of files.
    CHECK(access.starts_with(L"D:P("));
    CHECK(access.ends_with(L";;;" + user + L")"));
    CHECK(access.find(L'(') == access.rfind(L'('));
    // Under Wine 8 another label reads back: this is what is asked for.
    CHECK(asks_for_medium_integrity(pipe_security().value().raw()));
}

TEST_CASE("nobody else can take the name while the daemon runs, and its end frees it") {
    const TemporaryFolder profile;
    const std::wstring name = pipe_name(instance_name(profile.path()).value()).value();
    {
        Echo echo(profile.path());
        CHECK_FALSE(PipeServer::open(name).has_value());
    }
    CHECK(PipeServer::open(name).has_value());
    CHECK_FALSE(make_control_system(0, nullptr)->connect(profile.path()).has_value());
}

TEST_CASE("broken and slow clients are dropped, and the others are served meanwhile") {
    const TemporaryFolder profile;
    Echo echo(profile.path());
    for (const std::string& bytes :
         {std::string(),
          std::string(1, '\2'),
          std::string("\2\0\0", 3),
          std::string(4, '\0'),
          std::string("\1\0\1\0", 4),
          std::string(100, '\xFF')}) {
        const auto client = connected(profile.path());
        if (!bytes.empty()) {
            CHECK(client->write(bytes).has_value());
        }
    }
    const auto huge = connected(profile.path());
    CHECK(huge->write(std::string("\1\0\1\0", 4)).has_value());
    CHECK(huge->read(1, std::chrono::seconds(5)) == "");

    const auto slow = connected(profile.path());
    CHECK(slow->write(std::string("\x40\0\0\0{", 5)).has_value());
    const Ticks begin = clock_now();
    const std::uint64_t first = echo.rounds();
    while (slow->write(" ").has_value() && clock_now() - begin < 10 * ticks_per_second) {
        CHECK(echoed(profile.path(), "{}") == "{}");
        ::Sleep(100);
    }
    const double seconds = to_seconds(clock_now() - begin);
    CHECK(seconds < 10.0);
    // Nobody was waited for.
    CHECK(static_cast<double>(echo.rounds() - first) > 10.0 * seconds);
}

TEST_CASE("an answer that was sent before the daemon ended can still be read") {
    const TemporaryFolder profile;
    Echo echo(profile.path());
    const auto client = connected(profile.path());
    Conversation conversation(*client);
    REQUIRE(conversation.ask("[1]").has_value());
    ::Sleep(300);
    echo.stop();
    const Result<std::string> answer = conversation.answer();
    CHECK((answer ? *answer : answer.error().message) == "[1]");
}

TEST_CASE("a file is replaced whole, and stays as it was while another program holds it") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "config.json";
    REQUIRE(save_file(file, "one").has_value());
    CHECK(folder.read("config.json") == "one");
    REQUIRE(save_file(file, "two").has_value());
    CHECK(folder.read("config.json") == "two");
    {
        const KernelObject holder = owned_file(
            ::CreateFileW(file.c_str(), GENERIC_READ, 0, nullptr, OPEN_EXISTING, 0, nullptr)
        );
        REQUIRE(holder);
        CHECK_FALSE(save_file(file, "three").has_value());
    }
    CHECK(folder.read("config.json") == "two");
    CHECK_FALSE(std::filesystem::exists(folder.path() / "config.json.new"));
}
