/// \file What the courtyard's tests ask of a world.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "ecs/hierarchy.h"
#include "scene/extract.h"
#include "scene/motion.h"

namespace lampyris::courtyard::test {

/// One frame, as the program's loop does it.
inline void advance(ecs::World& world, double seconds) {
    const ecs::Tick since = world.advance();
    scene::advanceTo(world, seconds, since);
    world.forgetRemovals(since);
}

inline void append(std::string& text, const void* bytes, size_t size) {
    text.append(static_cast<const char*>(bytes), size);
}

/// All that is drawn of an entity, bit by bit; its handle left out.
inline std::string bytesOf(const ecs::World& world, ecs::Entity entity) {
    std::string bytes;
    if (const auto* name = world.find<scene::Name>(entity)) bytes += name->value;
    bytes += '\0';
    if (const auto* place = world.find<scene::WorldTransform>(entity))
        append(bytes, &place->matrix, sizeof(place->matrix));
    if (const auto* drawn = world.find<scene::MeshInstance>(entity))
        append(bytes, drawn, sizeof(*drawn));
    if (const auto* light = world.find<scene::SphereLight>(entity))
        append(bytes, light, sizeof(*light));
    if (const auto* morph = world.find<scene::MorphWeights>(entity))
        append(bytes, morph->values.data(), morph->values.size() * sizeof(float));
    return bytes;
}

/// The world as a list that is the same for worlds that look the same, whatever their handles.
inline std::vector<std::string> lookOf(const ecs::World& world) {
    std::vector<std::string> look;
    for (const ecs::Entity entity : world.entities()) look.push_back(bytesOf(world, entity));
    std::sort(look.begin(), look.end());
    return look;
}

inline size_t triangleCount(const ecs::World& world) {
    const auto& meshes = world.resource<scene::Library>().meshes();
    size_t count = 0;
    for (const auto& [entity, drawn] : world.view<scene::MeshInstance>())
        count += meshes[drawn.mesh.value].value->triangleCount();
    return count;
}

inline ecs::Entity named(const ecs::World& world, const std::string& name) {
    for (const auto& [entity, own] : world.view<scene::Name>())
        if (own.value == name) return entity;
    return {};
}

}  // namespace lampyris::courtyard::test
