/// \file The scenes that need no file. Each fills a world that has an empty Library.
#pragma once

#include <span>
#include <string_view>

#include "core/result.h"
#include "ecs/world.h"

namespace lampyris::scene {

/// The names that builtinScene knows, in alphabetical order.
[[nodiscard]] std::span<const std::string_view> builtinSceneNames();

/// A world of that name, world transforms in place; the same bytes on every call and machine.
/// An unknown name is an error that lists the known ones.
core::Result<ecs::World> builtinScene(std::string_view name);

namespace builtin {

/// What DESIGN.md calls by these names.
void fillCornell(ecs::World& world);
void fillCornellStatue(ecs::World& world);
void fillCornellHairball(ecs::World& world);
void fillTwoRooms(ecs::World& world);
void fillConference(ecs::World& world);

}  // namespace builtin
}  // namespace lampyris::scene
