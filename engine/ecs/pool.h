/// \file All components of one type: values in pages beside the sparse set, and their observers.
#pragma once

#include <type_traits>

#include "ecs/observer.h"
#include "ecs/sparse_set.h"

namespace lampyris::ecs {

/// What can be a component: a plain value that can be moved.
template <typename C>
concept Component = std::is_same_v<C, std::remove_cvref_t<C>> && !std::is_same_v<C, bool> &&
                    std::is_move_constructible_v<C> && std::is_move_assignable_v<C>;

/// Values stay where they are while others are added; a removal moves the last value into the hole.
template <Component C>
class Pool final : public SparseSet {
 public:
    Signal<World&, Entity> added;
    Signal<World&, Entity> changed;
    Signal<World&, Entity, const C&> removed;

    [[nodiscard]] C& at(uint32_t position) {
        return pages_[position / kPageSize][position % kPageSize];
    }
    [[nodiscard]] const C& at(uint32_t position) const {
        return pages_[position / kPageSize][position % kPageSize];
    }
    [[nodiscard]] const C* find(Entity e) const {
        const uint32_t at = position(e);
        return at == kAbsent ? nullptr : &this->at(at);
    }

    void insert(Entity e, C value, Tick now) {
        const uint32_t at = link(e, now);
        if (at / kPageSize == pages_.size()) pages_.emplace_back().reserve(kPageSize);
        pages_[at / kPageSize].push_back(std::move(value));
    }

    /// Takes the value out; the entity must be here.
    C take(Entity e, Tick now) {
        const uint32_t at = position(e);
        const auto last = static_cast<uint32_t>(size() - 1);
        C value = std::move(this->at(at));
        if (at != last) this->at(at) = std::move(this->at(last));
        pages_[last / kPageSize].pop_back();
        unlink(at, now);
        return value;
    }

    void announceRemoval(World& world, Entity e, const C& value) {
        removed.notifyWhile([] { return true; }, world, e, value);
    }

    std::unique_ptr<Departure> depart(Entity e, Tick now) override {
        struct Leaving final : Departure {
            Leaving(Pool& from, Entity who, C what)
                : pool(from), entity(who), value(std::move(what)) {}
            void announce(World& world) override { pool.announceRemoval(world, entity, value); }
            Pool& pool;
            Entity entity;
            C value;
        };
        C value = take(e, now);
        if (removed.empty()) return nullptr;
        return std::make_unique<Leaving>(*this, e, std::move(value));
    }

 private:
    std::vector<std::vector<C>>
        pages_;  ///< each of capacity kPageSize, so that nothing moves on growth
};

}  // namespace lampyris::ecs
