// SPDX-License-Identifier: MIT
#include "daemon/script/host_main.h"

#include "daemon/core/script_wire.h"
#include "daemon/script/script_host.h"

#include <fmt/format.h>

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

class Server {
public:
    Server(ScriptLink& link, const ScriptLimits& fixed)
        : link_(link), fixed_(fixed), host_(make_script_host(fixed)) {}

    int serve() {
        std::vector<std::byte> buffer(std::size_t{64} << 10U);
        while (const std::size_t size = link_.read(buffer)) {
            stream_.add(std::span(buffer).first(size));
            while (true) {
                const auto message = stream_.next();
                if (!message) {
                    return host_exit_not_understood;
                }
                if (!*message) {
                    break;
                }
                Result<wire::ToHost> order = wire::decode_to_host(**message);
                if (!order || !std::visit([this](auto& each) { return obey(each); }, *order)) {
                    return host_exit_not_understood;
                }
            }
            if (gone_) {
                break;
            }
        }
        return host_exit_ok;
    }

private:
    bool obey(const wire::Load& load) {
        ScriptLimits limits = load.limits;
        limits.processor_time = fixed_.processor_time;
        limits.pulse = fixed_.pulse;
        host_->set_limits(limits);
        if (load.anew) {
            host_->renew();
        }
        if (load.scripts == 0) {
            host_->load({});
        }
        missing_ = load.scripts;
        sources_.clear();
        return true;
    }

    bool obey(ScriptSource& source) {
        if (missing_ == 0) {
            return false;
        }
        sources_.push_back(std::move(source));
        if (--missing_ == 0) {
            host_->load(std::exchange(sources_, {}));
        }
        return true;
    }

    bool obey(const wire::Run& run) {
        if (missing_ != 0) {
            return false;
        }
        ScriptOutput output = host_->run(run.world, run.events);
        cut_log(output.log);
        answer_.clear();
        wire::encode_answer(answer_, run.number, output);
        gone_ = !link_.write(answer_);
        return true;
    }

    // Many scripts may say more at once than one message holds.
    static void cut_log(std::vector<ScriptLog>& log) {
        if (log.size() > wire::most_lines) {
            const std::size_t dropped = log.size() - wire::most_lines + 1;
            log.resize(wire::most_lines - 1);
            log.push_back(
                {LogLevel::warning, "script host", fmt::format("{} log lines dropped", dropped)}
            );
        }
    }

    ScriptLink& link_;
    const ScriptLimits fixed_;
    std::unique_ptr<ScriptHost> host_;
    wire::MessageStream stream_{wire::longest_to_host};
    std::vector<ScriptSource> sources_;
    std::uint32_t missing_ = 0;  // Sources that are still to come.
    wire::Bytes answer_;
    bool gone_ = false;
};

}  // namespace

int serve_scripts(ScriptLink& link, const ScriptLimits& fixed) {
    try {
        return Server(link, fixed).serve();
    } catch (const std::bad_alloc&) {
        return host_exit_out_of_memory;
    }
}

}  // namespace hyrax
