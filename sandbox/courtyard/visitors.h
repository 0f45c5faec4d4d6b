/// \file What comes and goes: crates, leaves and a lantern that are made and destroyed while the
/// world runs. Which are there, and where, is a function of the time and the seed alone.
#pragma once

#include "courtyard/paints.h"
#include "ecs/schedule.h"

namespace lampyris::courtyard {

/// On every entity that will go: one slot of a kind is taken by one visitor at a time.
struct Visitor {
    uint32_t slot = 0;
    int64_t round = 0;  ///< of its slot
    bool operator==(const Visitor&) const = default;
};

/// A leaf on its way down.
struct Falling {
    glm::vec3 fromMetres{0.0f};
    double sinceSeconds = 0.0;
    float phaseTurns = 0.0f;
};

/// What visitors are made of; a resource of the world.
struct Stock {
    uint32_t seed = 1;
    scene::MeshId crate, leaf, cage;
    scene::MaterialId wood, iron;
    scene::MaterialId dyes[4];
};
[[nodiscard]] Stock makeStock(scene::Library& library, const Paints& paints, uint32_t seed);

constexpr uint32_t kCrateSlots = 9;
constexpr uint32_t kLeafSlots = 24;
constexpr uint32_t kLanternSlot = kCrateSlots + kLeafSlots;
constexpr uint32_t kSlots = kLanternSlot + 1;

/// Adds the systems that make and destroy them, and let leaves fall.
void addVisiting(ecs::Schedule& systems);

}  // namespace lampyris::courtyard
