// SPDX-License-Identifier: MIT
#include "daemon/core/script_wire.h"

#include "daemon/core/script_wire_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace hyrax::wire {
namespace {

enum class Type : std::uint8_t { load, source, run, answer };

constexpr std::uint32_t known_events = (2U << std::to_underlying(last_event_kind)) - 1U;

bool is_control(char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < 0x20U || byte == 0x7FU;
}

bool breaks_lines(char letter) {
    return is_control(letter) && letter != '\n';
}

/// Appends one message; its length is filled in at the end.
class Writer {
public:
    Writer(Bytes& bytes, Type type) : bytes_(bytes), begin_(bytes.size()), end_(begin_) {
        whole(std::uint32_t{0});
        whole(version);
        whole(std::to_underlying(type));
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        bytes_.resize(end_);
        const auto length = static_cast<std::uint32_t>(end_ - begin_ - sizeof(std::uint32_t));
        std::memcpy(bytes_.data() + begin_, &length, sizeof length);
    }

    template <typename T>
    void whole(T value) {
        static_assert(std::is_arithmetic_v<T>);
        std::memcpy(room_for(sizeof value), &value, sizeof value);
    }
    void number(double value) { whole(value); }
    void finite(double value) { whole(value); }
    void finite(const Vec2& value) { fields(*this, value); }
    template <typename T>
    void positive(T value) {
        whole(value);
    }
    void made_key(PetKey value) { whole(value); }
    void length(int value) { whole(std::max(value, 0)); }
    void count(std::uint32_t value, std::size_t /*most*/) { whole(value); }
    void flag(bool value) { whole(std::uint8_t{value}); }
    template <typename Number, typename Unit>
    void time(std::chrono::duration<Number, Unit> value) {
        whole(std::int64_t{value.count()});
    }
    template <typename Enum>
    void choice(Enum value, Enum /*last*/) {
        whole(static_cast<std::uint8_t>(std::to_underlying(value)));
    }
    void events(EventMask mask) { whole(mask.bits() & known_events); }
    void text(std::string_view value, std::size_t longest) {
        const std::string_view cut = value.substr(0, longest);
        whole(static_cast<std::uint32_t>(cut.size()));
        std::ranges::copy(std::as_bytes(std::span(cut)), room_for(cut.size()));
    }
    void line(std::string_view value, std::size_t longest) {
        text(value, longest);
        const auto end = reinterpret_cast<char*>(bytes_.data() + end_);
        std::replace_if(end - std::min(value.size(), longest), end, is_control, '?');
    }
    void lines(std::string_view value, std::size_t longest) {
        text(value, longest);
        const auto end = reinterpret_cast<char*>(bytes_.data() + end_);
        std::replace_if(end - std::min(value.size(), longest), end, breaks_lines, '?');
    }
    template <typename T>
    void optional(const std::optional<T>& value) {
        flag(value.has_value());
        if (value) {
            fields(*this, *value);
        }
    }
    template <typename T>
    void list(const std::vector<T>& values, std::size_t most) {
        list(std::span(values), most);
    }
    template <typename T>
    void list(std::span<const T> values, std::size_t most) {
        const auto kept = values.first(std::min(values.size(), most));
        whole(static_cast<std::uint32_t>(kept.size()));
        for (const T& value : kept) {
            fields(*this, value);
        }
    }
    void finite(const std::optional<Vec2>& value) { optional(value); }
    void number(const std::optional<double>& value) { optional(value); }
    void sorted(const ScriptTable& /*table*/) {}
    void nested(const ScriptValue& value) {
        ++depth_;
        alternative(depth_ > deepest_value ? ScriptValue{}.data : value.data, {});
        --depth_;
    }
    template <typename... T>
    void alternative(const std::variant<T...>& value, const char* /*otherwise*/) {
        whole(static_cast<std::uint8_t>(value.index()));
        std::visit([this](const auto& which) { fields(*this, which); }, value);
    }

private:
    // A message is thousands of small fields: room is made for many of them at once.
    std::byte* room_for(std::size_t size) {
        if (size > bytes_.size() - end_) {
            grow(size);
        }
        return bytes_.data() + std::exchange(end_, end_ + size);
    }
    void grow(std::size_t size) {
        constexpr std::size_t spare = 4'096;
        bytes_.resize(std::max(2 * bytes_.size(), end_ + size + spare));
    }

    Bytes& bytes_;
    std::size_t begin_;
    std::size_t end_;  // Of what is written; what follows it is room.
    std::size_t depth_ = 0;
};

/// Reads fields until one is wrong; from then on nothing changes any more.
class Reader {
public:
    explicit Reader(std::span<const std::byte> rest) : rest_(rest) {}

    template <typename T>
    void whole(T& value) {
        static_assert(std::is_arithmetic_v<T>);
        if (sizeof value > rest_.size()) {
            fail("it ends too early");
        } else {
            std::memcpy(&value, rest_.data(), sizeof value);
            rest_ = rest_.subspan(sizeof value);
        }
    }
    void number(double& value) { whole(value); }
    void finite(double& value) {
        whole(value);
        demand(std::isfinite(value), "a number is not finite");
    }
    void finite(Vec2& value) {
        finite(value.x);
        finite(value.y);
    }
    template <typename T>
    void positive(T& value) {
        whole(value);
        demand(value > 0, "a limit is not positive");
    }
    void made_key(PetKey& value) {
        whole(value);
        demand((value & script_made_key) != 0, "a new pet has a key of the daemon's");
    }
    void length(int& value) {
        whole(value);
        demand(value >= 0, "a length is negative");
    }
    void count(std::uint32_t& value, std::size_t most) {
        whole(value);
        demand(value <= most, "there are too many of something");
    }
    void flag(bool& value) {
        std::uint8_t byte = 0;
        whole(byte);
        demand(byte <= 1, "a flag is neither 0 nor 1");
        value = byte == 1;
    }
    template <typename Number, typename Unit>
    void time(std::chrono::duration<Number, Unit>& value) {
        std::int64_t count = 0;
        whole(count);
        demand(count >= 0 && count <= 1'000'000, "a time is out of range");
        value = std::chrono::duration<Number, Unit>(count);
    }
    template <typename Enum>
    void choice(Enum& value, Enum last) {
        std::uint8_t byte = 0;
        whole(byte);
        demand(byte <= static_cast<std::uint8_t>(last), "there is no such choice");
        if (!failed()) {
            value = static_cast<Enum>(byte);
        }
    }
    void events(EventMask& mask) {
        std::uint32_t bits = 0;
        whole(bits);
        demand((bits & ~known_events) == 0, "there is no such event");
        mask = EventMask::from_bits(bits);
    }
    void text(std::string& value, std::size_t longest) {
        std::uint32_t size = 0;
        whole(size);
        demand(size <= longest, "a text is too long");
        demand(size <= rest_.size(), "a text is longer than its message");
        if (!failed()) {
            value.assign(reinterpret_cast<const char*>(rest_.data()), size);
            rest_ = rest_.subspan(size);
        }
    }
    void line(std::string& value, std::size_t longest) {
        text(value, longest);
        demand(std::ranges::none_of(value, is_control), "a control character is in a line");
    }
    void lines(std::string& value, std::size_t longest) {
        text(value, longest);
        demand(std::ranges::none_of(value, breaks_lines), "a control character is in a line");
    }
    template <typename T>
    void optional(std::optional<T>& value) {
        bool is_there = false;
        flag(is_there);
        if (is_there && !failed()) {
            fields(*this, value.emplace());
        }
    }
    template <typename T>
    void list(std::vector<T>& values, std::size_t most) {
        std::uint32_t size = 0;
        count(size, most);
        // Every item has at least one byte: no more memory than the message pays for.
        demand(size <= rest_.size(), "a list is longer than its message");
        for (std::uint32_t i = 0; i < size && !failed(); ++i) {
            fields(*this, values.emplace_back());
        }
    }
    void finite(std::optional<Vec2>& value) {
        optional(value);
        demand(
            !value || (std::isfinite(value->x) && std::isfinite(value->y)), "a number is not finite"
        );
    }
    void number(std::optional<double>& value) {
        bool is_there = false;
        flag(is_there);
        if (is_there && !failed()) {
            whole(value.emplace());
        }
    }
    void nested(ScriptValue& value) {
        ++values_;
        ++depth_;
        demand(values_ <= most_values, "there are too many values");
        // Too deep, there can only be nothing.
        const bool fits = depth_ <= deepest_value || (!rest_.empty() && rest_[0] == std::byte{0});
        demand(fits, "a value lies too deep in others");
        alternative(value.data, "there is no such value");
        --depth_;
    }
    void sorted(const ScriptTable& table) {
        const auto not_before = [](const ScriptField& a, const ScriptField& b) {
            return a.name >= b.name;
        };
        demand(
            std::ranges::adjacent_find(table, not_before) == table.end(),
            "the names of a table are not in order"
        );
    }
    template <typename... T>
    void alternative(std::variant<T...>& value, const char* otherwise) {
        std::uint8_t index = 0;
        whole(index);
        demand(index < sizeof...(T), otherwise);
        if (!failed()) {
            emplace(value, index, std::index_sequence_for<T...>{});
        }
    }

    void demand(bool good, const char* otherwise) {
        if (!good) {
            fail(otherwise);
        }
    }
    bool failed() const { return problem_ != nullptr; }
    template <typename T>
    Result<T> finished(T value) {
        demand(rest_.empty(), "something follows its end");
        if (failed()) {
            return failure(fmt::format("broken message: {}", problem_));
        }
        return value;
    }

private:
    template <typename Variant, std::size_t... index>
    void emplace(Variant& value, std::size_t wanted, std::index_sequence<index...>) {
        const auto read = [&]<std::size_t place>() {
            if (place == wanted) {
                fields(*this, value.template emplace<place>());
            }
        };
        (read.template operator()<index>(), ...);
    }

    void fail(const char* problem) {
        problem_ = failed() ? problem_ : problem;
        rest_ = {};
    }

    std::span<const std::byte> rest_;
    std::size_t values_ = 0;
    std::size_t depth_ = 0;
    const char* problem_ = nullptr;
};

/// Reads version and type.
Type opened(Reader& reader) {
    std::uint8_t spoken = 0;
    std::uint8_t type = 0;
    reader.whole(spoken);
    reader.demand(spoken == version, "it is of another version");
    reader.whole(type);
    reader.demand(type <= std::to_underlying(Type::answer), "there is no such message");
    return static_cast<Type>(type);
}

template <typename Message>
Result<ToHost> decoded(Reader& reader) {
    Message message;
    fields(reader, message);
    return reader.finished<ToHost>(std::move(message));
}

}  // namespace

void encode(Bytes& bytes, const Load& load) {
    Writer writer(bytes, Type::load);
    fields(writer, load);
}

void encode(Bytes& bytes, const ScriptSource& source) {
    Writer writer(bytes, Type::source);
    fields(writer, source);
}

void encode_run(
    Bytes& bytes,
    std::uint64_t number,
    const ScriptWorld& world,
    std::span<const ScriptEvent> events
) {
    Writer writer(bytes, Type::run);
    writer.whole(number);
    fields(writer, world);
    writer.list(events, most_events);
}

void encode_answer(Bytes& bytes, std::uint64_t number, const ScriptOutput& output) {
    Writer writer(bytes, Type::answer);
    writer.whole(number);
    fields(writer, output);
}

Result<ToHost> decode_to_host(std::span<const std::byte> message) {
    Reader reader(message);
    switch (opened(reader)) {
        case Type::load:
            return decoded<Load>(reader);
        case Type::source:
            return decoded<ScriptSource>(reader);
        case Type::run:
            return decoded<Run>(reader);
        case Type::answer:
            break;
    }
    return failure("broken message: an answer is no question");
}

Result<Answer> decode_answer(std::span<const std::byte> message) {
    Reader reader(message);
    reader.demand(opened(reader) == Type::answer, "it is no answer");
    Answer answer;
    fields(reader, answer);
    return reader.finished(std::move(answer));
}

}  // namespace hyrax::wire
