#include "ecs/sparse_set.h"

#include <algorithm>

#include "core/check.h"

namespace lampyris::ecs {

uint32_t SparseSet::link(Entity e, Tick now) {
    CHECK(position(e) == kAbsent);
    const uint32_t page = e.index() / kPageSize;
    if (page >= sparse_.size()) sparse_.resize(page + 1);
    if (!sparse_[page]) {
        sparse_[page] = std::make_unique<Page>();
        sparse_[page]->fill(kAbsent);
    }
    const auto at = static_cast<uint32_t>(dense_.size());
    (*sparse_[page])[e.index() % kPageSize] = at;
    dense_.push_back(e);
    changed_.push_back(now);
    if (at / kPageSize >= pageChanged_.size()) pageChanged_.push_back(0);
    stamp(at, now);
    ++structureVersion_;
    return at;
}

void SparseSet::unlink(uint32_t at, Tick now) {
    const Entity gone = dense_[at];
    const Entity last = dense_.back();
    dense_[at] = last;
    stamp(at, changed_.back());
    (*sparse_[last.index() / kPageSize])[last.index() % kPageSize] = at;
    (*sparse_[gone.index() / kPageSize])[gone.index() % kPageSize] = kAbsent;
    dense_.pop_back();
    changed_.pop_back();
    removals_.push_back({gone, now});
    ++structureVersion_;
}

void SparseSet::stamp(uint32_t at, Tick now) {
    changed_[at] = now;
    Tick& page = pageChanged_[at / kPageSize];
    page = std::max(page, now);
}

std::vector<Entity> SparseSet::changedSince(Tick since) const {
    std::vector<Entity> found;
    for (size_t page = 0; page < pageChanged_.size(); ++page) {
        if (pageChanged_[page] <= since) continue;
        const size_t end = std::min(dense_.size(), (page + 1) * kPageSize);
        for (size_t at = page * kPageSize; at < end; ++at)
            if (changed_[at] > since) found.push_back(dense_[at]);
    }
    return found;
}

std::vector<Entity> SparseSet::removedSince(Tick since) const {
    const auto later = [](Tick tick, const Removal& removal) { return tick < removal.tick; };
    std::vector<Entity> found;
    for (auto it = std::upper_bound(removals_.begin(), removals_.end(), since, later);
         it != removals_.end(); ++it)
        found.push_back(it->entity);
    return found;
}

void SparseSet::forgetRemovals(Tick until) {
    const auto later = [](Tick tick, const Removal& removal) { return tick < removal.tick; };
    removals_.erase(removals_.begin(),
                    std::upper_bound(removals_.begin(), removals_.end(), until, later));
}

}  // namespace lampyris::ecs
