#include "scene/place_deformed.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "scene/components.h"

namespace lampyris::scene {

namespace {

/// The nearest entity at or above all that live; invalid where they have none in common, nothing
/// where none lives. Each entity is looked at once, however deep they stand.
std::optional<ecs::Entity> commonAncestor(const ecs::World& world,
                                          const std::vector<ecs::Entity>& entities) {
    std::vector<ecs::Entity> path;                  // of the first that lives, up to its root
    std::unordered_map<ecs::Entity, size_t> meets;  // where on the path an entity's own path ends
    size_t common = 0;
    bool any = false;
    for (const ecs::Entity entity : entities) {
        if (!world.alive(entity)) continue;
        std::vector<ecs::Entity> passed;
        ecs::Entity e = entity;
        for (; e.valid() && !meets.contains(e); e = ecs::parentOf(world, e)) passed.push_back(e);
        const size_t meeting = e.valid() ? meets[e] : path.size();
        for (const ecs::Entity below : passed) {
            meets[below] = any ? meeting : path.size();
            if (!any) path.push_back(below);
        }
        if (any) common = std::max(common, meeting);
        any = true;
    }
    if (!any) return std::nullopt;
    return common < path.size() ? path[common] : ecs::Entity{};
}

glm::mat4 worldOf(const ecs::World& world, ecs::Entity entity) {
    for (ecs::Entity e = entity; e.valid(); e = ecs::parentOf(world, e))
        if (const auto* transform = world.find<WorldTransform>(e)) return transform->matrix;
    return glm::mat4(1.0f);
}

/// Matrices from entities to one above them, in products of local ones alone.
class Chains {
 public:
    Chains(const ecs::World& world, ecs::Entity above) : world_(world), above_(above) {}

    glm::mat4 from(ecs::Entity entity) {
        std::vector<ecs::Entity> path;
        ecs::Entity e = entity;
        for (; e.valid() && e != above_ && !known_.contains(e); e = ecs::parentOf(world_, e))
            path.push_back(e);
        glm::mat4 matrix = e.valid() && e != above_ ? known_[e] : glm::mat4(1.0f);
        for (auto below = path.rbegin(); below != path.rend(); ++below) {
            if (const auto* local = world_.find<Transform>(*below)) matrix *= local->matrix();
            known_[*below] = matrix;
        }
        return matrix;
    }

 private:
    const ecs::World& world_;
    ecs::Entity above_;
    std::unordered_map<ecs::Entity, glm::mat4> known_;
};

std::vector<glm::mat4> jointMatrices(const ecs::World& world, const Skin& skin, ecs::Entity common,
                                     size_t needed) {
    Chains chains(world, common);
    std::vector<glm::mat4> matrices(std::max(skin.joints.size(), needed), glm::mat4(1.0f));
    for (size_t i = 0; i < skin.joints.size(); ++i) {
        if (world.alive(skin.joints[i])) matrices[i] = chains.from(skin.joints[i]);
        if (i < skin.inverseBindMatrices.size()) matrices[i] *= skin.inverseBindMatrices[i];
    }
    return matrices;
}

}  // namespace

PlacedPose placeDeformed(const ecs::World& world, ecs::Entity entity, const PoseExtents* extents) {
    PlacedPose placed{nullptr, worldOf(world, entity)};
    if (extents == nullptr) return placed;
    const auto* weights = world.find<MorphWeights>(entity);
    const auto* skin = world.find<Skin>(entity);
    const bool morphs = weights != nullptr && !extents->offsets.empty();
    const bool follows = skin != nullptr && !extents->joints.empty();
    if (!morphs && !follows) return placed;
    Pose pose;
    if (weights != nullptr) pose.morphWeights = weights->values;
    pose.morphWeights.resize(extents->offsets.size(), 0.0f);
    if (follows) {
        const std::optional<ecs::Entity> common = commonAncestor(world, skin->joints);
        pose.jointMatrices =
            jointMatrices(world, *skin, common.value_or(ecs::Entity{}), extents->joints.size());
        if (common) placed.objectToWorld = worldOf(world, *common);
    }
    placed.pose = std::make_shared<const Pose>(std::move(pose));
    return placed;
}

ecs::Entity wholeOf(const ecs::World& world, ecs::Entity shown) {
    if (const auto* skin = world.find<Skin>(shown)) {
        const auto ofJoints = commonAncestor(world, skin->joints);
        std::vector<ecs::Entity> all = skin->joints;
        all.push_back(shown);
        const auto ofAll = commonAncestor(world, all);
        if (ofJoints && ofAll->valid()) return *ofAll;
        if (ofJoints && ofJoints->valid()) return *ofJoints;
    }
    const ecs::Entity parent = ecs::parentOf(world, shown);
    return world.find<MeshPart>(shown) != nullptr && parent.valid() ? parent : shown;
}

}  // namespace lampyris::scene
