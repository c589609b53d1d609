// SPDX-License-Identifier: MIT
// The world as one script sees it during a run: the snapshot plus its own writes.
#pragma once

#include "daemon/core/script_port.h"

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hyrax::script {

/// A snapshot with an index, shared by all scripts of a run.
class Snapshot {
public:
    explicit Snapshot(const ScriptWorld& world) : world_(world) {}
    const ScriptWorld& world() const { return world_; }
    const PetView* find(PetKey key) const;

private:
    const ScriptWorld& world_;
    mutable std::vector<const PetView*> by_key_;  // Made by the first search.
};

class WorldView {
public:
    /// Forgets all writes. The snapshot must outlive every other call.
    void renew(const Snapshot& snapshot);

    const ScriptWorld& world() const { return snapshot_->world(); }
    /// Null when the pet is gone.
    const PetView* find(PetKey key) const;
    /// True once no event can come any more: it is gone, and was gone when the run began.
    bool is_past(PetKey key) const;
    /// The pet, to be changed; null when it is gone.
    PetView* edit(PetKey key);
    void add(PetView pet);
    void remove(PetKey key);

    /// Calls visit(pet) from the bottom to the top. The view must not change meanwhile.
    template <typename Visit>
    void for_each(Visit visit) const {
        for (const PetView& pet : world().pets) {
            if (const PetView* const seen = find(pet.key)) {
                visit(*seen);
            }
        }
        for (const PetKey key : added_) {
            if (const PetView* const seen = find(key)) {
                visit(*seen);
            }
        }
    }

private:
    const Snapshot* snapshot_ = nullptr;
    std::unordered_map<PetKey, PetView> changed_;
    std::unordered_set<PetKey> gone_;
    std::vector<PetKey> added_;
};

}  // namespace hyrax::script
