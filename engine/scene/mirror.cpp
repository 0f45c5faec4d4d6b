#include "scene/mirror.h"

#include "core/check.h"

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

}  // namespace

Mirror::Counts Mirror::follow(ecs::World& world, const EntitySource& source) {
    ++round_;
    Counts counts;
    source.forEach([&](const EntityState& state) { show(world, state, counts); });
    for (auto each = known_.begin(); each != known_.end();) {
        const bool gone = each->second.round != round_;
        if (gone) {
            world.destroy(each->second.entity);
            ++counts.removed;
        }
        each = gone ? known_.erase(each) : std::next(each);
    }
    return counts;
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
