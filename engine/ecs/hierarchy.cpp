#include "ecs/hierarchy.h"

#include <algorithm>

#include "core/check.h"
#include "ecs/world.h"

namespace lampyris::ecs {

/// The only code that writes Parent and Children: the two always agree.
struct Kinship {
    static void link(World& world, Entity child, Entity parent) {
        if (!world.has<Children>(parent))
            world.pool<Children>().insert(parent, Children(), world.tick());
        Pool<Children>& families = world.pool<Children>();
        const uint32_t at = families.position(parent);
        families.at(at).entities_.push_back(child);
        families.stamp(at, world.tick());
        world.set(child, Parent(parent));
    }

    /// Takes the child out of its parent's list and leaves its Parent as it is.
    static void leave(World& world, Entity child, Entity parent) {
        Pool<Children>& families = world.pool<Children>();
        const uint32_t at = families.position(parent);
        std::vector<Entity>& siblings = families.at(at).entities_;
        siblings.erase(std::find(siblings.begin(), siblings.end(), child));
        families.stamp(at, world.tick());
        if (siblings.empty()) families.take(parent, world.tick());
    }

    static void unlink(World& world, Entity child, Entity parent) {
        leave(world, child, parent);
        world.take<Parent>(child);
    }
};

core::Result<void> setParent(World& world, Entity child, Entity parent) {
    CHECK(world.occupant(child.index()) == child);
    CHECK(world.occupant(parent.index()) == parent);
    // Nothing is below an entity without children: no walk up, so that a long chain is built in
    // linear time.
    const bool cycle =
        child == parent || (world.has<Children>(child) && isWithin(world, parent, child));
    if (cycle)
        return core::error("entity {} cannot be a child of {}: it would be its own ancestor", child,
                           parent);
    const Entity former = parentOf(world, child);
    if (former == parent) return {};
    if (former.valid()) Kinship::leave(world, child, former);
    Kinship::link(world, child, parent);
    return {};
}

void clearParent(World& world, Entity child) {
    const Entity parent = parentOf(world, child);
    if (parent.valid()) Kinship::unlink(world, child, parent);
}

void leaveFamily(World& world, Entity dying) {
    const Entity parent = parentOf(world, dying);
    if (parent.valid()) Kinship::leave(world, dying, parent);
}

Entity parentOf(const World& world, Entity child) {
    const Parent* parent = world.find<Parent>(child);
    return parent == nullptr ? Entity{} : parent->entity();
}

std::span<const Entity> childrenOf(const World& world, Entity parent) {
    const Children* children = world.find<Children>(parent);
    return children == nullptr ? std::span<const Entity>{} : children->entities();
}

bool isWithin(const World& world, Entity e, Entity ancestor) {
    for (; e.valid(); e = parentOf(world, e))
        if (e == ancestor) return true;
    return false;
}

namespace {

void appendSubtree(const World& world, Entity root, std::vector<Entity>& found) {
    // A stack of our own: a chain of a million entities must not end the program's.
    std::vector<Entity> open{root};
    while (!open.empty()) {
        const Entity e = open.back();
        open.pop_back();
        found.push_back(e);
        const std::span<const Entity> children = childrenOf(world, e);
        open.insert(open.end(), children.rbegin(), children.rend());
    }
}

}  // namespace

std::vector<Entity> subtree(const World& world, Entity root) {
    std::vector<Entity> found;
    if (world.alive(root)) appendSubtree(world, root, found);
    return found;
}

std::vector<Entity> parentsFirst(const World& world) {
    std::vector<Entity> found;
    found.reserve(world.entityCount());
    for (const Entity e : world.entities())
        if (!world.has<Parent>(e)) appendSubtree(world, e, found);
    return found;
}

}  // namespace lampyris::ecs
