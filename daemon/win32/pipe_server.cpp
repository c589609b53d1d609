// SPDX-License-Identifier: MIT
#include "daemon/win32/pipe_server.h"

#include "daemon/win32/pipe_name.h"
#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace hyrax::win32 {
namespace {

constexpr DWORD buffer_bytes = 4096;

// A call that goes on after it has returned. The system writes to it: it must not move.
struct Pending {
    OVERLAPPED state{};
    bool running = false;

    void prepare(HANDLE event) {
        state = {};
        state.hEvent = event;
        running = true;
    }
    /// What came of it, once it is done.
    std::optional<DWORD> take_result(HANDLE pipe, DWORD& bytes) {
        if (!running) {
            return std::nullopt;
        }
        const bool good = ::GetOverlappedResult(pipe, &state, &bytes, FALSE) != 0;
        const DWORD code = good ? ERROR_SUCCESS : ::GetLastError();
        if (code == ERROR_IO_INCOMPLETE) {
            return std::nullopt;
        }
        running = false;
        return code;
    }
    void cancel(HANDLE pipe) {
        if (running) {
            DWORD bytes = 0;
            ::CancelIoEx(pipe, &state);
            ::GetOverlappedResult(pipe, &state, &bytes, TRUE);
            running = false;
        }
    }
};

}  // namespace

struct PipeServer::Instance {
    KernelObject pipe;
    Pending connecting;
    Pending reading;
    Pending writing;
    std::array<char, buffer_bytes> in{};
    std::string out;  ///< What is being written.
    std::optional<ClientSession> session;
    Ticks linger_until = never;  ///< All is written: until the client has read it and left.

    bool lingers() const { return linger_until != never; }

    void read(HANDLE event) {
        const std::size_t wanted = lingers() ? 1 : session->wanted();
        if (reading.running || wanted == 0) {
            return;
        }
        reading.prepare(event);
        const auto most = static_cast<DWORD>(std::min<std::size_t>(wanted, in.size()));
        if (::ReadFile(pipe.raw(), in.data(), most, nullptr, &reading.state) == 0 &&
            ::GetLastError() != ERROR_IO_PENDING) {
            reading.running = false;
            session->left();
            linger_until = lingers() ? 0 : never;
        }
    }

    void write(HANDLE event) {
        if (writing.running || session->unsent().empty() || session->is_over()) {
            return;
        }
        out = session->unsent();
        writing.prepare(event);
        const auto bytes = static_cast<DWORD>(out.size());
        if (::WriteFile(pipe.raw(), out.data(), bytes, nullptr, &writing.state) == 0 &&
            ::GetLastError() != ERROR_IO_PENDING) {
            writing.running = false;
            session->left();
        }
    }

    void cancel() {
        connecting.cancel(pipe.raw());
        reading.cancel(pipe.raw());
        writing.cancel(pipe.raw());
    }
};

PipeServer::PipeServer() : ready_(::CreateEventW(nullptr, TRUE, FALSE, nullptr)) {}

Result<std::unique_ptr<PipeServer>> PipeServer::open(const std::wstring& name) {
    const Result<LocalMemory> security = pipe_security();
    if (!security) {
        return std::unexpected(security.error());
    }
    SECURITY_ATTRIBUTES attributes{sizeof(SECURITY_ATTRIBUTES), security->raw(), FALSE};
    std::unique_ptr<PipeServer> server(new PipeServer);
    if (!server->ready_) {
        return std::unexpected(system_error("cannot make an event"));
    }
    for (DWORD i = 0; i < most_clients; ++i) {
        const DWORD first = i == 0 ? FILE_FLAG_FIRST_PIPE_INSTANCE : 0;
        auto instance = std::make_unique<Instance>();
        instance->pipe = owned_file(::CreateNamedPipeW(
            name.c_str(),
            PIPE_ACCESS_DUPLEX | FILE_FLAG_OVERLAPPED | first,
            PIPE_TYPE_BYTE | PIPE_READMODE_BYTE | PIPE_WAIT | PIPE_REJECT_REMOTE_CLIENTS,
            most_clients,
            buffer_bytes,
            buffer_bytes,
            0,
            &attributes
        ));
        if (!instance->pipe) {
            return std::unexpected(system_error("cannot make the control pipe"));
        }
        server->instances_.push_back(std::move(instance));
        server->listen(*server->instances_.back());
    }
    return server;
}

PipeServer::~PipeServer() {
    for (const std::unique_ptr<Instance>& instance : instances_) {
        instance->cancel();
    }
}

Ticks PipeServer::due() const {
    Ticks earliest = never;
    for (const std::unique_ptr<Instance>& instance : instances_) {
        if (instance->session) {
            earliest = std::min({earliest, instance->session->due(), instance->linger_until});
        }
    }
    return earliest;
}

/// Every call that begins resets the event, even if another one has just ended: only after a round
/// in which nothing has happened is it sure that nothing was missed.
void PipeServer::serve(Ticks now, std::vector<Input>& inbox) {
    ::ResetEvent(ready_.raw());
    bool happened = true;
    while (happened) {
        happened = false;
        for (const std::unique_ptr<Instance>& instance : instances_) {
            happened = step(*instance, now, inbox) || happened;
        }
    }
}

void PipeServer::answer(ClientId id, std::string_view text, Answer which, Ticks now) {
    for (const std::unique_ptr<Instance>& instance : instances_) {
        if (instance->session && instance->session->id() == id &&
            instance->session->answer(text, which, now)) {
            instance->write(ready_.raw());
        }
    }
}

/// True if anything has happened.
bool PipeServer::step(Instance& instance, Ticks now, std::vector<Input>& inbox) {
    DWORD bytes = 0;
    if (!instance.session) {
        const std::optional<DWORD> connected =
            instance.connecting.take_result(instance.pipe.raw(), bytes);
        if (connected) {
            begin(instance, now);
        }
        return connected.has_value();
    }
    ClientSession& session = *instance.session;
    const std::optional<DWORD> read = instance.reading.take_result(instance.pipe.raw(), bytes);
    if (read && *read == ERROR_SUCCESS && !instance.lingers()) {
        session.received({instance.in.data(), bytes});
    } else if (read) {
        session.left();
        instance.linger_until = instance.lingers() ? now : never;
    }
    if (std::optional<std::string> request = session.take_request()) {
        inbox.emplace_back(input::Asked{session.id(), *std::move(request)});
    }
    const std::optional<DWORD> written = instance.writing.take_result(instance.pipe.raw(), bytes);
    if (written && *written == ERROR_SUCCESS) {
        session.sent(bytes, now);
        // To end the connection now would throw away what the client has not read yet.
        instance.linger_until = session.is_over() ? now + ClientSession::patience : never;
    } else if (written) {
        session.left();
    }
    session.check_time(now);
    if (session.is_over() && (!instance.lingers() || now >= instance.linger_until)) {
        end(instance, inbox);
        return true;
    }
    instance.read(ready_.raw());
    instance.write(ready_.raw());
    return read || written;
}

void PipeServer::listen(Instance& instance) const {
    DWORD code = ERROR_NO_DATA;
    // A client that came and has gone already leaves the instance in a state to be cleared.
    for (int i = 0; i < 8 && code == ERROR_NO_DATA; ++i) {
        ::DisconnectNamedPipe(instance.pipe.raw());
        instance.connecting.prepare(ready_.raw());
        const bool done = ::ConnectNamedPipe(instance.pipe.raw(), &instance.connecting.state) != 0;
        code = done ? ERROR_SUCCESS : ::GetLastError();
    }
    if (code == ERROR_PIPE_CONNECTED) {
        // A client was quicker: the call has not begun, and nothing else would signal.
        instance.connecting.state.Internal = 0;
        ::SetEvent(ready_.raw());
    } else if (code != ERROR_SUCCESS && code != ERROR_IO_PENDING) {
        instance.connecting.running = false;
        spdlog::warn("{}", system_error("the control pipe serves one client less", code).message);
    }
}

void PipeServer::begin(Instance& instance, Ticks now) {
    instance.session.emplace(next_id_++, now);
    instance.linger_until = never;
    instance.read(ready_.raw());
}

void PipeServer::end(Instance& instance, std::vector<Input>& inbox) {
    if (instance.session->is_watching()) {
        inbox.emplace_back(input::Left{instance.session->id()});
    }
    instance.cancel();
    instance.session.reset();
    instance.linger_until = never;
    listen(instance);
}

}  // namespace hyrax::win32
