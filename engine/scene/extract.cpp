#include "scene/extract.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/check.h"
#include "math/rigid.h"
#include "scene/place_deformed.h"

namespace lampyris::scene {

namespace {

void makeUnique(std::vector<uint32_t>& slots) {
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
}

/// Slots whose occupant may have gained, lost or changed a component, in order.
template <typename... Components>
std::vector<uint32_t> slotsTouched(const ecs::World& world, ecs::Tick since) {
    std::vector<uint32_t> slots;
    const auto addAll = [&](const std::vector<ecs::Entity>& entities) {
        for (const ecs::Entity e : entities) slots.push_back(e.index());
    };
    (addAll(world.changedSince<Components>(since)), ...);
    (addAll(world.removedSince<Components>(since)), ...);
    makeUnique(slots);
    return slots;
}

bool samePose(const SnapshotInstance& a, const SnapshotInstance& b) {
    if (a.entity != b.entity || a.mesh != b.mesh) return false;
    return a.pose == b.pose || (a.pose && b.pose && *a.pose == *b.pose);
}

bool sameContents(const SnapshotInstance& a, const SnapshotInstance& b) {
    return samePose(a, b) && a.material == b.material && a.objectToWorld == b.objectToWorld;
}

bool sameContents(const SnapshotLight& a, const SnapshotLight& b) {
    return a.entity == b.entity && a.positionWorld == b.positionWorld &&
           a.radiusMetres == b.radiusMetres && a.powerWatts == b.powerWatts &&
           a.directionWorld == b.directionWorld && a.cosOuterCone == b.cosOuterCone &&
           a.cosInnerCone == b.cosInnerCone;
}

/// Gives an entry its version, and what it still shares with the one before it, if any.
void finish(SnapshotInstance& entry, const SnapshotInstance* before, uint64_t version) {
    entry.version = version;
    const bool stands = before != nullptr && samePose(*before, entry);
    entry.poseVersion = stands ? before->poseVersion : version;
    if (stands) entry.pose = before->pose;
}

void finish(SnapshotLight& entry, const SnapshotLight* /*before*/, uint64_t version) {
    entry.version = version;
}

/// Brings the entries of the touched slots up to date; both lists are ordered by slot. New and
/// changed entries get `version`. True where anything changed.
template <typename Entry, typename Make>
bool update(std::vector<Entry>& entries, const std::vector<uint32_t>& touched, uint64_t version,
            const Make& make) {
    if (touched.empty()) return false;
    std::vector<Entry> updated;
    updated.reserve(entries.size() + touched.size());
    bool changed = false;
    auto old = entries.begin();
    for (const uint32_t slot : touched) {
        for (; old != entries.end() && old->entity.index() < slot; ++old) updated.push_back(*old);
        const bool wasThere = old != entries.end() && old->entity.index() == slot;
        std::optional<Entry> entry = make(slot);
        if (wasThere && entry && sameContents(*old, *entry)) {
            updated.push_back(*old);
        } else if (wasThere || entry) {
            changed = true;
            if (entry) {
                finish(*entry, wasThere ? &*old : nullptr, version);
                updated.push_back(std::move(*entry));
            }
        }
        if (wasThere) ++old;
    }
    updated.insert(updated.end(), old, entries.end());
    entries = std::move(updated);
    return changed;
}

/// Takes over the library's values whose version is not the snapshot's. Returns their indices.
template <typename T>
std::vector<uint32_t> share(std::vector<Versioned<T>>& ours,
                            const std::vector<Versioned<T>>& library) {
    std::vector<uint32_t> replaced;
    ours.resize(library.size());
    for (size_t i = 0; i < library.size(); ++i) {
        if (ours[i].version == library[i].version) continue;
        ours[i] = library[i];
        replaced.push_back(static_cast<uint32_t>(i));
    }
    return replaced;
}

std::optional<SnapshotInstance> makeInstance(const ecs::World& world, const SceneSnapshot& shared,
                                             ecs::Entity entity) {
    const auto* drawn = world.find<MeshInstance>(entity);
    const auto* transform = world.find<WorldTransform>(entity);
    if (drawn == nullptr || transform == nullptr || !drawn->mesh.valid()) return std::nullopt;
    // Numbers that the library lacks may come from a saved scene: they show nothing, or in default.
    if (drawn->mesh.value >= shared.meshes.size()) return std::nullopt;
    const bool known = drawn->material.valid() && drawn->material.value < shared.materials.size();
    const MaterialId material = known ? drawn->material : kDefaultMaterial;
    PlacedPose placed =
        placeDeformed(world, entity, world.resource<Library>().extentsOf(drawn->mesh));
    return SnapshotInstance{.entity = entity,
                            .mesh = drawn->mesh.value,
                            .material = material.value,
                            .objectToWorld = placed.objectToWorld,
                            .pose = std::move(placed.pose)};
}

constexpr float kLeastRadius = 1e-6f;  // metres [chosen] a point to any scene

std::optional<SnapshotLight> makeLight(const ecs::World& world, ecs::Entity entity) {
    const auto* light = world.find<SphereLight>(entity);
    const auto* transform = world.find<WorldTransform>(entity);
    if (light == nullptr || transform == nullptr) return std::nullopt;
    return SnapshotLight{
        .entity = entity,
        .positionWorld = glm::vec3(transform->matrix[3]),
        // Not less, nor NaN: shaders divide by its square.
        .radiusMetres = light->radiusMetres > kLeastRadius ? light->radiusMetres : kLeastRadius,
        .powerWatts = light->powerWatts,
        .directionWorld = -glm::vec3(math::rigidPart(transform->matrix)[2]),
        .cosOuterCone = light->cosOuterCone,
        .cosInnerCone = light->cosInnerCone};
}

/// Slots of instances that may have changed: also skinned ones, wherever something moved. Which
/// joints follow it is not asked; poses that come out as they were are no change.
std::vector<uint32_t> instancesTouched(const ecs::World& world, ecs::Tick since,
                                       const std::vector<uint32_t>& replacedMeshes,
                                       const SceneSnapshot& before) {
    std::vector<uint32_t> slots =
        slotsTouched<MeshInstance, WorldTransform, Skin, MorphWeights>(world, since);
    if (world.count<Skin>() > 0 &&
        !slotsTouched<Transform, WorldTransform, ecs::Parent>(world, since).empty())
        for (const auto& [entity, skin] : world.view<Skin>()) slots.push_back(entity.index());
    for (const SnapshotInstance& instance : before.instances)
        if (std::binary_search(replacedMeshes.begin(), replacedMeshes.end(), instance.mesh))
            slots.push_back(instance.entity.index());
    makeUnique(slots);
    return slots;
}

math::Bounds boundsOf(const Library& library, const SnapshotInstance& instance) {
    const MeshId mesh{instance.mesh};
    const math::Bounds& rest = library.meshes()[instance.mesh].value->bounds;
    return math::transformed(
        instance.pose ? posedBounds(*library.extentsOf(mesh), *instance.pose) : rest,
        instance.objectToWorld);
}

void updateInstances(const ecs::World& world, ecs::Tick since,
                     const std::vector<uint32_t>& replacedMeshes, SceneSnapshot& next) {
    const uint64_t version = next.geometryVersion + 1;
    bool changed =
        update(next.instances, instancesTouched(world, since, replacedMeshes, next), version,
               [&](uint32_t slot) { return makeInstance(world, next, world.occupant(slot)); });
    for (SnapshotInstance& instance : next.instances) {
        if (std::binary_search(replacedMeshes.begin(), replacedMeshes.end(), instance.mesh)) {
            instance.version = instance.poseVersion = version;
            changed = true;
        }
    }
    if (!changed && replacedMeshes.empty()) return;
    next.geometryVersion = version;
    next.boundsWorld = {};
    for (SnapshotInstance& instance : next.instances) {
        if (instance.version == version)
            instance.boundsWorld = boundsOf(world.resource<Library>(), instance);
        next.boundsWorld.grow(instance.boundsWorld);
    }
}

/// All of them each time: they are few, and depend on names as well.
std::vector<SnapshotCamera> makeCameras(const ecs::World& world) {
    std::vector<std::pair<uint32_t, SnapshotCamera>> ordered;
    for (const auto& [entity, camera, transform] : world.view<Camera, WorldTransform>()) {
        const auto* name = world.find<Name>(entity);
        ordered.push_back({entity.index(),
                           {.name = name == nullptr ? std::string() : name->value,
                            .cameraToWorld = math::rigidPart(transform.matrix),
                            .verticalFovRadians = camera.verticalFovRadians,
                            .nearMetres = camera.nearMetres}});
    }
    std::sort(ordered.begin(), ordered.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<SnapshotCamera> cameras;
    cameras.reserve(ordered.size());
    for (auto& [slot, camera] : ordered) cameras.push_back(std::move(camera));
    return cameras;
}

}  // namespace

SceneSnapshot extract(const ecs::World& world, const SceneSnapshot& previous, ecs::Tick since) {
    SceneSnapshot next = previous;
    const auto& library = world.resource<Library>();
    const std::vector<uint32_t> replacedMeshes = share(next.meshes, library.meshes());
    const bool materialsReplaced = !share(next.materials, library.materials()).empty();
    const bool imagesReplaced = !share(next.images, library.images()).empty();
    if (materialsReplaced || imagesReplaced) ++next.materialVersion;
    updateInstances(world, since, replacedMeshes, next);
    const bool lightsChanged = update(
        next.lights, slotsTouched<SphereLight, WorldTransform>(world, since), next.lightVersion + 1,
        [&](uint32_t slot) { return makeLight(world, world.occupant(slot)); });
    if (lightsChanged) ++next.lightVersion;
    next.cameras = makeCameras(world);
    return next;
}

}  // namespace lampyris::scene
