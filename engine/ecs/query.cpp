#include "ecs/query.h"

#include "core/check.h"

namespace lampyris::ecs {

void Query::include(const SparseSet* set) {
    if (set == nullptr) {
        nothing_ = true;
        driver_ = nullptr;
    }
    if (nothing_) return;
    CHECK((included_ + excluded_) < kMaxTerms);
    sets_[included_++] = set;
    if (driver_ == nullptr || set->size() < driver_->size()) driver_ = set;
}

void Query::exclude(const SparseSet* set) {
    if (set == nullptr) return;
    CHECK((included_ + excluded_) < kMaxTerms);
    sets_[kMaxTerms - ++excluded_] = set;
}

bool Query::matches(Entity e) const {
    for (size_t i = 0; i < included_; ++i)
        if (sets_[i] != driver_ && !sets_[i]->contains(e)) return false;
    for (size_t i = kMaxTerms - excluded_; i < kMaxTerms; ++i)
        if (sets_[i]->contains(e)) return false;
    return true;
}

uint64_t Query::structureVersion() const {
    uint64_t sum = 0;
    for (size_t i = 0; i < included_; ++i) sum += sets_[i]->structureVersion();
    for (size_t i = kMaxTerms - excluded_; i < kMaxTerms; ++i) sum += sets_[i]->structureVersion();
    return sum;
}

void Query::checkUnchanged(uint64_t version) const {
    // Components came or went while a view was walked: put such changes off with Commands.
    CHECK(structureVersion() == version);
}

}  // namespace lampyris::ecs
