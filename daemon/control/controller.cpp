// SPDX-License-Identifier: MIT
#include "daemon/control/controller.h"

#include "daemon/control/request_check.h"
#include "daemon/control/verb.h"
#include "daemon/core/framing.h"
#include "daemon/core/text_cursor.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

// Text from files may hold bytes that are no UTF-8.
std::string text_of(const json& answer) {
    return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string refusal_text(const Refusal& refusal) {
    constexpr std::size_t longest = 8192;
    return text_of({
        {"ok", false},
        {"error", {{"code", refusal.code}, {"message", shortened(refusal.message, longest)}}},
    });
}

std::string answer_text(const Outcome& outcome) {
    if (!outcome) {
        return refusal_text(outcome.error());
    }
    std::string answer = text_of({{"ok", true}, {"result", *outcome}});
    return answer.size() <= max_message
               ? answer
               : refusal_text({"too_long", "the answer would be too long; ask for less"});
}

double rounded(double value) {
    return std::round(value * 100.0) / 100.0;
}

json event_json(const Engine& engine, const Event& event, double seconds) {
    json told{
        {"event", event_names()[std::to_underlying(event.kind)]},
        {"seconds", std::round(seconds * 1000.0) / 1000.0},
    };
    if (event.kind == EventKind::monitors) {
        return told;
    }
    told["pet"] = pet_text(event.pet);
    if (const Pet* const pet = engine.find(event.pet)) {
        told["kind"] = engine.kinds()[pet->kind].name;
    }
    switch (event.kind) {
        case EventKind::remove:
            told["tag"] = event.tag;
            break;
        case EventKind::throw_pet:
            told["vx"] = rounded(event.velocity.x);
            told["vy"] = rounded(event.velocity.y);
            break;
        case EventKind::bounce:
            told["side"] = side_name(event.side);
            told["speed"] = rounded(event.speed);
            break;
        case EventKind::land:
            told["speed"] = rounded(event.speed);
            break;
        case EventKind::collide:
            told["other"] = pet_text(event.other);
            told["speed"] = rounded(event.speed);
            break;
        case EventKind::click:
            told["button"] = button_name(event.button);
            break;
        case EventKind::spawn:
        case EventKind::grab:
        case EventKind::monitors:
            break;
    }
    return told;
}

class Controller final : public ControlPort {
public:
    explicit Controller(SaveFile save) : save_(std::move(save)) {}

    ControlAnswer answer(Daemon& daemon, std::string_view text, std::size_t watchers) override {
        const std::expected<CheckedRequest, Refusal> request = check_request(text);
        if (!request) {
            return {refusal_text(request.error())};
        }
        VerbContext context{
            .daemon = daemon, .save = save_, .upload = upload_, .watchers = watchers
        };
        const Outcome outcome = request->verb->carry_out(context, request->arguments);
        if (context.waits) {
            waiting_[context.waits->evaluation] = *context.waits;
            return {.text = {}, .watch = {}, .evaluation = context.waits->evaluation};
        }
        return {answer_text(outcome), context.watch};
    }

    std::string evaluated(Daemon& daemon, const Evaluated& evaluated) override {
        const auto entry = waiting_.extract(evaluated.id);
        if (entry.empty()) {
            return refusal_text({"refused", evaluated.text});
        }
        const Waits& waits = entry.mapped();
        return answer_text(waits.finish(daemon, waits.script, evaluated));
    }

    std::string told(const Engine& engine, const Event& event, double seconds) override {
        return text_of(event_json(engine, event, seconds));
    }

private:
    SaveFile save_;
    Upload upload_;
    std::map<std::uint64_t, Waits> waiting_;  // By their evaluations.
};

}  // namespace

std::unique_ptr<ControlPort> make_controller(SaveFile save) {
    return std::make_unique<Controller>(std::move(save));
}

}  // namespace hyrax
