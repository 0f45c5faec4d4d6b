/// \file The game scene.
#pragma once

#include <string_view>

#include "ecs/world.h"

namespace lampyris::courtyard {

constexpr std::string_view kSceneName = "courtyard";

/// A courtyard at night at time 0, with its Motion: arcades, a workshop, a study and a street,
/// lit by what hangs, burns, roams and comes. The same bytes on every call and machine;
/// `seed` decides what comes and goes. Cameras: "square", "workshop", "arcade".
[[nodiscard]] ecs::World makeCourtyard(uint32_t seed = 1);

}  // namespace lampyris::courtyard
