/// \file Parent and child entities. Destroying a parent destroys its children.
#pragma once

#include <span>
#include <vector>

#include "core/result.h"
#include "ecs/entity.h"

namespace lampyris::ecs {

class World;
struct Kinship;

/// On every entity that has a parent. Its tick says when it got this parent:
/// world.changedSince<Parent>(tick).
class Parent {
 public:
    [[nodiscard]] Entity entity() const { return entity_; }

 private:
    friend struct Kinship;
    explicit Parent(Entity entity) : entity_(entity) {}
    Entity entity_;
};

/// On every entity that has children, in the order in which they came. To observe the hierarchy,
/// observe Parent: changes here tell nobody.
class Children {
 public:
    [[nodiscard]] std::span<const Entity> entities() const { return entities_; }

 private:
    friend struct Kinship;
    Children() = default;
    std::vector<Entity> entities_;
};

/// Puts `child` under `parent`, at the end of its children; takes it from its former parent. An
/// error where this would make an entity its own ancestor (the world stays as it was). Both must be
/// alive.
core::Result<void> setParent(World& world, Entity child, Entity parent);
/// Makes `child` a root; nothing happens to one that is.
void clearParent(World& world, Entity child);
/// For World::destroy alone: takes a dying entity out of its parent's children and tells nobody.
void leaveFamily(World& world, Entity dying);

/// None for a root and for a stale handle.
[[nodiscard]] Entity parentOf(const World& world, Entity child);
/// Valid until the next change of the hierarchy.
[[nodiscard]] std::span<const Entity> childrenOf(const World& world, Entity parent);
/// Whether `ancestor` is `e` itself or above it.
[[nodiscard]] bool isWithin(const World& world, Entity e, Entity ancestor);

/// The entity and all below it, parents before children, siblings in order.
[[nodiscard]] std::vector<Entity> subtree(const World& world, Entity root);
/// All living entities: parents before children, siblings in order, roots by index.
[[nodiscard]] std::vector<Entity> parentsFirst(const World& world);

}  // namespace lampyris::ecs
