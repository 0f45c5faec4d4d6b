/// \file The world: entities, their components, and resources (values of which there is one).
#pragma once

#include <memory>
#include <vector>

#include "ecs/entity.h"
#include "ecs/hierarchy.h"
#include "ecs/pool.h"
#include "ecs/query.h"
#include "ecs/type.h"

namespace lampyris::ecs {

/// Owns everything. Const functions may be called from several threads at once; the others from
/// one. Reading asks (find, has, alive: false or null for a stale handle); get, edit, add and set
/// demand, and end the program with the entity and the component in the message where they cannot
/// be served.
class World {
 public:
    World() = default;
    World(World&&) noexcept = default;
    World& operator=(World&&) noexcept = default;
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World() = default;

    Entity create();
    /// Destroys the entity and all below it; false for a stale handle. First all handles go stale
    /// and all components leave, then onRemove observers are told, parents before children.
    bool destroy(Entity e);
    [[nodiscard]] bool alive(Entity e) const { return e.valid() && occupant(e.index()) == e; }
    /// The living entity in a slot, or none.
    [[nodiscard]] Entity occupant(uint32_t index) const;
    [[nodiscard]] size_t entityCount() const { return living_; }
    /// All living entities, by index.
    [[nodiscard]] std::vector<Entity> entities() const;

    /// Adds a component that the entity must not have. An onAdd observer may not remove it at once
    /// (set allows it).
    template <Component C>
    C& add(Entity e, C value = {});
    /// Adds the component, or replaces it (which is a change).
    template <Component C>
    void set(Entity e, C value);
    template <Component C>
    [[nodiscard]] const C& get(Entity e) const;
    template <Component C>
    [[nodiscard]] const C* find(Entity e) const;
    template <Component C>
    [[nodiscard]] bool has(Entity e) const {
        return find<C>(e) != nullptr;
    }
    /// The component to be written: marks it changed and tells onChange at once, before the caller
    /// writes.
    template <Component C>
    C& edit(Entity e);
    /// Marks it changed, lets write(C&) change it, then tells onChange.
    template <Component C, typename F>
    void edit(Entity e, const F& write);
    /// False where there was none.
    template <Component C>
    bool remove(Entity e);

    template <Component... Cs, typename... Xs>
    [[nodiscard]] View<Cs...> view(Without<Xs...> = {}) const;
    template <Component C>
    [[nodiscard]] size_t count() const {
        return findPool<C>() == nullptr ? 0 : findPool<C>()->size();
    }

    /// Changes made now carry this tick; the first is 1.
    [[nodiscard]] Tick tick() const { return tick_; }
    /// Ends the tick and returns it: changes made from now on are those since the returned tick.
    Tick advance() { return tick_++; }
    /// Added or changed after `since`; false without the component.
    template <Component C>
    [[nodiscard]] bool changedSince(Entity e, Tick since) const;
    /// Entities whose component was added or changed after `since`, in dense order; costs little
    /// where few were.
    template <Component C>
    [[nodiscard]] std::vector<Entity> changedSince(Tick since) const;
    /// Entities that lost the component after `since`, oldest first; they may be dead, or have
    /// regained it.
    template <Component C>
    [[nodiscard]] std::vector<Entity> removedSince(Tick since) const;
    /// Drops the record behind removedSince up to and including `until`: call it once all readers
    /// are past that.
    void forgetRemovals(Tick until);

    /// Observers: function(World&, Entity), and for onRemove optionally (World&, Entity, const C&
    /// removed), when the component has left. They may change the world; see Signal. Valid as long
    /// as the Connection lives.
    template <Component C, typename F>
    Connection onAdd(F function) {
        return pool<C>().added.connect(std::move(function));
    }
    template <Component C, typename F>
    Connection onChange(F function) {
        return pool<C>().changed.connect(std::move(function));
    }
    template <Component C, typename F>
    Connection onRemove(F function);

    template <typename T>
    void setResource(T value);
    template <typename T>
    [[nodiscard]] T& resource();
    template <typename T>
    [[nodiscard]] const T& resource() const;
    template <typename T>
    [[nodiscard]] const T* findResource() const;

    /// The pool of a component, made where missing. For systems: changes here tell nobody.
    template <Component C>
    [[nodiscard]] Pool<C>& pool();
    /// Tells onChange observers of a change that was made through pool().
    template <Component C>
    void announceChange(Entity e);
    /// Null where no entity ever had one.
    template <Component C>
    [[nodiscard]] const Pool<C>* findPool() const;

 private:
    struct Slot {
        uint16_t generation = 0;
        bool living = false;
    };
    friend struct Kinship;  // hierarchy.cpp: links and unlinks parents and children

    [[noreturn]] void fail(Entity e, const char* call, std::string_view component) const;
    template <Component C>
    uint32_t demand(const Pool<C>& pool, Entity e, const char* call) const;
    template <Component C>
    Pool<C>& insert(Entity e, C value, const char* call);
    template <Component C>
    bool take(Entity e);
    void bury(Entity e, std::vector<std::unique_ptr<Departure>>& departures);

    std::vector<Slot> slots_;
    std::vector<uint32_t> free_;
    size_t living_ = 0;
    Tick tick_ = 1;
    std::vector<std::unique_ptr<SparseSet>> pools_;  ///< by typeIndex
    std::vector<std::shared_ptr<void>> resources_;   ///< by typeIndex
};

}  // namespace lampyris::ecs

#include "ecs/world_inline.h"  // IWYU pragma: export
