#include "scene/systems/world_transforms.h"

#include <algorithm>
#include <vector>

#include "scene/components.h"

namespace lampyris::scene {

namespace {

using Entities = std::vector<ecs::Entity>;

/// Living entities whose own place relative to their parent may have changed, in order.
Entities movedSince(const ecs::World& world, ecs::Tick since) {
    Entities moved;
    const auto addAll = [&](const std::vector<ecs::Entity>& entities) {
        for (const ecs::Entity e : entities) {
            if (world.alive(e)) moved.push_back(e);
        }
    };
    addAll(world.changedSince<Transform>(since));
    addAll(world.removedSince<Transform>(since));
    addAll(world.changedSince<ecs::Parent>(since));
    addAll(world.removedSince<ecs::Parent>(since));
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    return moved;
}

bool isBelowOneOf(const ecs::World& world, ecs::Entity entity, const Entities& entities) {
    for (ecs::Entity e = ecs::parentOf(world, entity); e.valid(); e = ecs::parentOf(world, e)) {
        if (std::binary_search(entities.begin(), entities.end(), e)) return true;
    }
    return false;
}

/// The nearest WorldTransform above, which is right where nothing above has moved.
glm::mat4 matrixAbove(const ecs::World& world, ecs::Entity entity) {
    for (ecs::Entity e = ecs::parentOf(world, entity); e.valid(); e = ecs::parentOf(world, e)) {
        if (const auto* transform = world.find<WorldTransform>(e)) return transform->matrix;
    }
    return glm::mat4(1.0f);
}

/// Gives the entity its WorldTransform; returns what its children stand on.
glm::mat4 place(ecs::World& world, ecs::Entity entity, const glm::mat4& above, uint32_t& placed) {
    const auto* local = world.find<Transform>(entity);
    const auto* present = world.find<WorldTransform>(entity);
    if (local == nullptr) {
        world.remove<WorldTransform>(entity);
        return above;
    }
    const glm::mat4 matrix = above * local->matrix();
    if (present == nullptr || present->matrix != matrix) world.set(entity, WorldTransform{matrix});
    ++placed;
    return matrix;
}

uint32_t placeSubtree(ecs::World& world, ecs::Entity root) {
    struct Pending {
        ecs::Entity entity;
        glm::mat4 above;
    };
    uint32_t placed = 0;
    std::vector<Pending> pending{{root, matrixAbove(world, root)}};
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const glm::mat4 matrix = place(world, next.entity, next.above, placed);
        for (const ecs::Entity child : ecs::childrenOf(world, next.entity)) {
            pending.push_back({child, matrix});
        }
    }
    return placed;
}

}  // namespace

uint32_t updateWorldTransforms(ecs::World& world, ecs::Tick since) {
    const Entities moved = movedSince(world, since);
    uint32_t placed = 0;
    for (const ecs::Entity entity : moved) {
        if (!isBelowOneOf(world, entity, moved)) placed += placeSubtree(world, entity);
    }
    return placed;
}

}  // namespace lampyris::scene
