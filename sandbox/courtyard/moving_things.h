/// \file What moves by the clock, thing by thing; see movements.h.
#pragma once

#include "courtyard/paints.h"

namespace lampyris::courtyard {

void spawnFountain(ecs::World& world, const Paints& paints);  ///< its water is morphed
void spawnLanterns(ecs::World& world, const Paints& paints);  ///< all lights that stay
void spawnMill(ecs::World& world, const Paints& paints);      ///< a wheel at the west wall
void spawnDoor(ecs::World& world, const Paints& paints);      ///< between workshop and square
void spawnBellows(ecs::World& world, const Paints& paints);   ///< morphed, beside the hearth
void spawnCart(ecs::World& world, const Paints& paints);      ///< between the street and the square
void spawnBanners(ecs::World& world, const Paints& paints);   ///< skinned cloth

}  // namespace lampyris::courtyard
