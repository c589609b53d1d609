// SPDX-License-Identifier: MIT
// Values behind ids with generations: an id of something removed is recognised, never followed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hyrax {

/// Names a value in a SlotMap. The default id names nothing.
struct SlotId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;  ///< 0 only in the id of nothing.
    bool operator==(const SlotId&) const = default;
};

/// Keeps values in slots that are used again under a new generation. Iteration is in slot order,
/// which depends on the history of calls alone. References stay valid until the next insert.
template <typename T>
class SlotMap {
public:
    SlotId insert(T value) {
        if (free_.empty()) {
            slots_.emplace_back();
            free_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
        }
        const std::uint32_t index = free_.back();
        free_.pop_back();
        Slot& slot = slots_[index];
        slot.value = std::move(value);
        ++size_;
        return {index, slot.generation};
    }

    /// False when the id is stale.
    bool erase(SlotId id) {
        if (find(id) == nullptr) {
            return false;
        }
        Slot& slot = slots_[id.index];
        slot.value.reset();
        // A generation that would wrap to one already handed out retires the slot.
        if (++slot.generation != 0) {
            free_.push_back(id.index);
        }
        --size_;
        return true;
    }

    /// Null when the id is stale.
    T* find(SlotId id) { return const_cast<T*>(std::as_const(*this).find(id)); }
    const T* find(SlotId id) const {
        if (id.index >= slots_.size() || slots_[id.index].generation != id.generation) {
            return nullptr;
        }
        const std::optional<T>& value = slots_[id.index].value;
        return value ? &*value : nullptr;
    }

    std::size_t size() const { return size_; }

    /// Calls visit(id, value) for each value; visit must not insert or erase.
    template <typename Visit>
    void for_each(Visit visit) {
        for (std::uint32_t i = 0; i < slots_.size(); ++i) {
            if (slots_[i].value) {
                visit(SlotId{i, slots_[i].generation}, *slots_[i].value);
            }
        }
    }
    template <typename Visit>
    void for_each(Visit visit) const {
        for (std::uint32_t i = 0; i < slots_.size(); ++i) {
            if (slots_[i].value) {
                visit(SlotId{i, slots_[i].generation}, *slots_[i].value);
            }
        }
    }

private:
    struct Slot {
        std::optional<T> value;
        std::uint32_t generation = 1;
    };
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    std::size_t size_ = 0;
};

}  // namespace hyrax
