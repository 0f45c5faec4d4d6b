#include "scene/systems/animate.h"

namespace lampyris::scene {

void animate(ecs::World&) {}

}  // namespace lampyris::scene
