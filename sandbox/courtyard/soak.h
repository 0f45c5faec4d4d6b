/// \file Stress: things, lights and figures made and destroyed at random in every frame.
#pragma once

#include <cstdint>

#include "ecs/world.h"

namespace lampyris::courtyard {

constexpr size_t kMostSoakThings = 48;  ///< crates and leaves
constexpr size_t kMostSoakLights = 2;   ///< besides the courtyard's own
constexpr size_t kMostSoakFigures = 6;

/// From now on each advanceTo() of the courtyard makes and destroys some, by the seed and the
/// count of frames, whatever the time: a run of frames is the same each time.
void addSoak(ecs::World& world, uint32_t seed);

/// On what it made, for as long as it lives.
struct Soaked {};

}  // namespace lampyris::courtyard
