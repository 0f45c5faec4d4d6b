/// \file What stands still: walls, floors, arches, columns, roofs, plants and furniture.
#pragma once

#include "courtyard/paints.h"

namespace lampyris::courtyard {

void spawnBuilding(ecs::World& world, const Paints& paints);    ///< walls, arches, columns
void spawnPaving(ecs::World& world, const Paints& paints);      ///< slabs of the square
void spawnRoofs(ecs::World& world, const Paints& paints);       ///< eaves, shutters
void spawnFurnishing(ecs::World& world, const Paints& paints);  ///< of the square and the study
void spawnWorkshop(ecs::World& world, const Paints& paints);    ///< hearth, anvil, barrels

}  // namespace lampyris::courtyard
