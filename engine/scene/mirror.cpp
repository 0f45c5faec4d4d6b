#include "scene/mirror.h"

#include <unordered_set>

#include "core/check.h"
#include "ecs/hierarchy.h"

namespace lampyris::scene {
namespace {

bool same(const Transform& a, const Transform& b) {
    return a.translation == b.translation && a.rotation == b.rotation && a.scale == b.scale;
}

bool same(const MeshInstance& a, const MeshInstance& b) {
    return a.mesh == b.mesh && a.material == b.material;
}

bool same(const SphereLight& a, const SphereLight& b) {
    return a.radiusMetres == b.radiusMetres && a.powerWatts == b.powerWatts &&
           a.cosOuterCone == b.cosOuterCone && a.cosInnerCone == b.cosInnerCone;
}

bool same(const Camera& a, const Camera& b) {
    return a.verticalFovRadians == b.verticalFovRadians && a.nearMetres == b.nearMetres;
}

/// True where the component had to be added, changed or taken away.
template <typename C>
bool assume(ecs::World& world, ecs::Entity entity, const std::optional<C>& wanted) {
    if (!wanted) return world.remove<C>(entity);
    const C* present = world.find<C>(entity);
    if (present != nullptr && same(*present, *wanted)) return false;
    world.set(entity, C(*wanted));
    return true;
}

bool assumeName(ecs::World& world, ecs::Entity entity, std::string_view wanted) {
    const Name* present = world.find<Name>(entity);
    if (present == nullptr ? wanted.empty() : present->value == wanted) return false;
    world.set(entity, Name{std::string(wanted)});
    return true;
}

/// Makes roots of those below an entity that outlive it.
void release(ecs::World& world, ecs::Entity above, const std::unordered_set<ecs::Entity>& staying) {
    const auto span = ecs::childrenOf(world, above);
    for (const ecs::Entity child : std::vector<ecs::Entity>(span.begin(), span.end()))
        if (staying.contains(child))
            ecs::clearParent(world, child);
        else
            release(world, child, staying);
}

}  // namespace

Mirror::Counts Mirror::follow(ecs::World& world, const EntitySource& source) {
    ++round_;
    Counts counts;
    source.forEach([&](const EntityState& state) { show(world, state, counts); });
    std::vector<ecs::Entity> gone;
    for (auto each = known_.begin(); each != known_.end();) {
        const bool left = each->second.round != round_;
        if (left) gone.push_back(each->second.entity);
        each = left ? known_.erase(each) : std::next(each);
    }
    if (!gone.empty()) remove(world, gone);
    counts.removed = static_cast<uint32_t>(gone.size());
    return counts;
}

void Mirror::remove(ecs::World& world, const std::vector<ecs::Entity>& gone) const {
    std::unordered_set<ecs::Entity> staying;
    for (const auto& [id, known] : known_) staying.insert(known.entity);
    for (const ecs::Entity entity : gone) {
        if (!world.alive(entity)) continue;
        release(world, entity, staying);
        world.destroy(entity);
    }
}

void Mirror::show(ecs::World& world, const EntityState& state, Counts& counts) {
    Known& known = known_[state.id];
    CHECK(known.round != round_);  // an id of two things
    known.round = round_;
    const bool added = !world.alive(known.entity);
    if (added) known.entity = world.create();
    bool changed = assumeName(world, known.entity, state.name);
    changed |= assume(world, known.entity, std::optional(state.transform));
    changed |= assume(world, known.entity, state.mesh);
    changed |= assume(world, known.entity, state.light);
    changed |= assume(world, known.entity, state.camera);
    counts.added += added ? 1 : 0;
    counts.changed += !added && changed ? 1 : 0;
}

ecs::Entity Mirror::entityOf(uint64_t id) const {
    const auto found = known_.find(id);
    return found == known_.end() ? ecs::Entity{} : found->second.entity;
}

}  // namespace lampyris::scene
