#include "scene/changes.h"

#include <algorithm>
#include <cmath>

namespace lampyris::scene {
namespace {

/// Walks two lists ordered by entity: both(before, after), gone(before) and came(after).
template <typename Entry, typename Both, typename Gone, typename Came>
void walk(const std::vector<Entry>& before, const std::vector<Entry>& after, const Both& both,
          const Gone& gone, const Came& came) {
    auto old = before.begin();
    for (const Entry& entry : after) {
        for (; old != before.end() && old->entity.index() < entry.entity.index(); ++old) gone(*old);
        if (old != before.end() && old->entity == entry.entity) {
            if (old->version != entry.version) both(*old, entry);
            ++old;
        } else {
            came(entry);
        }
    }
    for (; old != before.end(); ++old) gone(*old);
}

float sizeOf(const math::Bounds& bounds) {
    return bounds.empty() ? 0.0f : glm::length(bounds.extent());
}

glm::vec3 corner(const math::Bounds& bounds, int i) {
    return {(i & 1) != 0 ? bounds.upper.x : bounds.lower.x,
            (i & 2) != 0 ? bounds.upper.y : bounds.lower.y,
            (i & 4) != 0 ? bounds.upper.z : bounds.lower.z};
}

/// How far the corners of the mesh's box went.
float placeMoved(const math::Bounds& box, const glm::mat4& before, const glm::mat4& after) {
    if (box.empty() || before == after) return 0.0f;
    float moved = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::vec4 point(corner(box, i), 1.0f);
        moved = std::max(moved, glm::length(glm::vec3(after * point - before * point)));
    }
    return moved;
}

/// How far joints took the middle of the mesh, or morph weights its size: a measure, no bound.
float poseMoved(const math::Bounds& box, const Pose& before, const Pose& after) {
    float moved = 0.0f;
    const glm::vec4 middle(0.5f * (box.lower + box.upper), 1.0f);
    for (size_t i = 0; i < std::min(before.jointMatrices.size(), after.jointMatrices.size()); ++i)
        moved = std::max(
            moved,
            glm::length(glm::vec3((after.jointMatrices[i] - before.jointMatrices[i]) * middle)));
    for (size_t i = 0; i < std::min(before.morphWeights.size(), after.morphWeights.size()); ++i)
        moved =
            std::max(moved, std::abs(after.morphWeights[i] - before.morphWeights[i]) * sizeOf(box));
    return moved;
}

float scaleOf(const glm::mat4& matrix) {
    return std::max({glm::length(glm::vec3(matrix[0])), glm::length(glm::vec3(matrix[1])),
                     glm::length(glm::vec3(matrix[2]))});
}

float instanceMoved(const SceneSnapshot& old, const SnapshotInstance& before,
                    const SceneSnapshot& now, const SnapshotInstance& after) {
    const bool another = before.mesh != after.mesh || before.material != after.material ||
                         old.meshes[before.mesh].version != now.meshes[after.mesh].version ||
                         (before.pose == nullptr) != (after.pose == nullptr);
    const math::Bounds& box = now.meshes[after.mesh].value->bounds;
    if (another || box.empty()) return sizeOf(after.boundsWorld);
    float moved = placeMoved(box, before.objectToWorld, after.objectToWorld);
    if (before.poseVersion != after.poseVersion && before.pose != nullptr)
        moved += poseMoved(box, *before.pose, *after.pose) * scaleOf(after.objectToWorld);
    return moved > 0.0f ? moved : sizeOf(after.boundsWorld);
}

void addRegions(const SceneSnapshot& before, const SceneSnapshot& after, SceneChanges& changes) {
    const auto whole = [&](const SnapshotInstance& instance) {
        changes.instancesCameOrWent = true;
        if (!instance.boundsWorld.empty())
            changes.regions.push_back({instance.boundsWorld, sizeOf(instance.boundsWorld)});
    };
    walk(
        before.instances, after.instances,
        [&](const SnapshotInstance& old, const SnapshotInstance& now) {
            math::Bounds bounds = old.boundsWorld;
            bounds.grow(now.boundsWorld);
            if (bounds.empty()) return;
            const float moved = std::min(instanceMoved(before, old, after, now), sizeOf(bounds));
            changes.regions.push_back({bounds, moved});
        },
        whole, whole);
}

float mean(const glm::vec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0f;
}

ChangedLight changed(const SnapshotLight& before, const SnapshotLight& after) {
    ChangedLight light{after.positionWorld,
                       std::max(mean(before.powerWatts), mean(after.powerWatts)),
                       mean(glm::abs(after.powerWatts - before.powerWatts)),
                       glm::length(after.positionWorld - before.positionWorld)};
    const bool turned = before.directionWorld != after.directionWorld &&
                        std::max(before.cosOuterCone, after.cosOuterCone) > -1.0f;
    if (turned || before.cosOuterCone != after.cosOuterCone ||
        before.cosInnerCone != after.cosInnerCone)
        light.changedWatts = light.watts;
    return light;
}

void addLights(const SceneSnapshot& before, const SceneSnapshot& after, SceneChanges& changes) {
    const auto whole = [&](const SnapshotLight& light) {
        const float watts = mean(light.powerWatts);
        changes.lights.push_back({light.positionWorld, watts, watts, 0.0f});
        changes.lightsCameOrWent = true;
    };
    walk(
        before.lights, after.lights,
        [&](const SnapshotLight& old, const SnapshotLight& now) {
            changes.lights.push_back(changed(old, now));
        },
        whole, whole);
}

}  // namespace

SceneChanges changesBetween(const SceneSnapshot& before, const SceneSnapshot& after) {
    SceneChanges changes;
    changes.everything = before.materialVersion != after.materialVersion;
    if (before.geometryVersion != after.geometryVersion) addRegions(before, after, changes);
    if (before.lightVersion != after.lightVersion) addLights(before, after, changes);
    return changes;
}

void add(SceneChanges& changes, SceneChanges later) {
    changes.everything = changes.everything || later.everything;
    changes.lightsCameOrWent = changes.lightsCameOrWent || later.lightsCameOrWent;
    changes.instancesCameOrWent = changes.instancesCameOrWent || later.instancesCameOrWent;
    changes.regions.insert(changes.regions.end(), later.regions.begin(), later.regions.end());
    changes.lights.insert(changes.lights.end(), later.lights.begin(), later.lights.end());
}

}  // namespace lampyris::scene
