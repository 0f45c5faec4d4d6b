/// \file Which entities have a component, in dense order, and when each last changed. Knows no
/// component type.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "ecs/entity.h"

namespace lampyris::ecs {

class World;

/// A component that has left its pool and waits for its observers to be told.
struct Departure {
    virtual ~Departure() = default;
    virtual void announce(World& world) = 0;
};

/// A paged sparse set of entities. Order is dense: insertion order, with the last filling the hole
/// of a removal.
class SparseSet {
 public:
    static constexpr uint32_t kAbsent = 0xffffffffu;
    static constexpr uint32_t kPageSize = 4096;  ///< [chosen] entries a page: 16 KiB of indices

    SparseSet() = default;
    SparseSet(const SparseSet&) = delete;
    SparseSet& operator=(const SparseSet&) = delete;
    virtual ~SparseSet() = default;

    [[nodiscard]] size_t size() const { return dense_.size(); }
    [[nodiscard]] std::span<const Entity> entities() const { return dense_; }
    [[nodiscard]] bool contains(Entity e) const { return position(e) != kAbsent; }
    /// Where the entity stands in dense order; kAbsent without one, and for a stale handle.
    [[nodiscard]] uint32_t position(Entity e) const {
        const uint32_t page = e.index() / kPageSize;
        if (page >= sparse_.size() || !sparse_[page]) return kAbsent;
        const uint32_t at = (*sparse_[page])[e.index() % kPageSize];
        return at != kAbsent && dense_[at] == e ? at : kAbsent;
    }
    /// Grows whenever an entity comes or goes; iteration is only valid while it stands.
    [[nodiscard]] uint64_t structureVersion() const { return structureVersion_; }

    [[nodiscard]] Tick changedAt(uint32_t position) const { return changed_[position]; }
    void stamp(uint32_t position, Tick now);
    /// Entities whose component was added or changed after `since`, in dense order.
    /// Pages without a change are skipped.
    [[nodiscard]] std::vector<Entity> changedSince(Tick since) const;
    /// Entities that lost the component after `since`, oldest first; they may have regained it.
    [[nodiscard]] std::vector<Entity> removedSince(Tick since) const;
    /// Drops the record of removals up to and including `until`.
    void forgetRemovals(Tick until);

    /// Removes the entity's component; gives it back where observers wait for it, else null.
    virtual std::unique_ptr<Departure> depart(Entity e, Tick now) = 0;

 protected:
    /// Appends the entity, which must not be here, and returns its position.
    uint32_t link(Entity e, Tick now);
    /// Takes the entity out: the last one now stands at `position`.
    void unlink(uint32_t position, Tick now);

 private:
    using Page = std::array<uint32_t, kPageSize>;
    struct Removal {
        Entity entity;
        Tick tick;
    };

    std::vector<std::unique_ptr<Page>> sparse_;  ///< entity index → position
    std::vector<Entity> dense_;
    std::vector<Tick> changed_;      ///< a position
    std::vector<Tick> pageChanged_;  ///< the latest in each kPageSize positions
    std::vector<Removal> removals_;  ///< ticks ascend
    uint64_t structureVersion_ = 0;
};

}  // namespace lampyris::ecs
