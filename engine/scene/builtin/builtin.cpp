#include "scene/builtin/builtin.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

namespace {

constexpr std::array<std::string_view, 5> kNames{"conference", "cornell", "cornell_hairball",
                                                 "cornell_statue", "two_rooms"};
constexpr std::array<void (*)(ecs::World&), kNames.size()> kFillers{
    builtin::fillConference, builtin::fillCornell, builtin::fillCornellHairball,
    builtin::fillCornellStatue, builtin::fillTwoRooms};

}  // namespace

std::span<const std::string_view> builtinSceneNames() {
    return kNames;
}

core::Result<ecs::World> builtinScene(std::string_view name) {
    const auto* const found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
        return core::error("\"{}\" is neither a .gltf or .glb file nor a built-in scene ({})", name,
                           fmt::join(kNames, ", "));
    }
    ecs::World world = newWorld();
    kFillers[static_cast<size_t>(found - kNames.begin())](world);
    updateWorldTransforms(world);
    return world;
}

}  // namespace lampyris::scene
