// SPDX-License-Identifier: MIT
#include "daemon/script/world_view.h"

#include <algorithm>
#include <utility>

namespace hyrax::script {

const PetView* Snapshot::find(PetKey key) const {
    const auto key_of = [](const PetView* pet) { return pet->key; };
    if (by_key_.size() != world_.pets.size()) {
        for (const PetView& pet : world_.pets) {
            by_key_.push_back(&pet);
        }
        std::ranges::sort(by_key_, {}, key_of);
    }
    const auto found = std::ranges::lower_bound(by_key_, key, {}, key_of);
    return found != by_key_.end() && (*found)->key == key ? *found : nullptr;
}

void WorldView::renew(const Snapshot& snapshot) {
    snapshot_ = &snapshot;
    changed_.clear();
    gone_.clear();
    added_.clear();
}

const PetView* WorldView::find(PetKey key) const {
    if (const auto changed = changed_.find(key); changed != changed_.end()) {
        return &changed->second;
    }
    return gone_.contains(key) ? nullptr : snapshot_->find(key);
}

bool WorldView::is_past(PetKey key) const {
    return find(key) == nullptr && snapshot_->find(key) == nullptr;
}

PetView* WorldView::edit(PetKey key) {
    const PetView* const pet = find(key);
    return pet == nullptr ? nullptr : &changed_.try_emplace(key, *pet).first->second;
}

void WorldView::add(PetView pet) {
    const PetKey key = pet.key;
    added_.push_back(key);
    changed_.insert_or_assign(key, std::move(pet));
}

void WorldView::remove(PetKey key) {
    changed_.erase(key);
    gone_.insert(key);
}

}  // namespace hyrax::script
