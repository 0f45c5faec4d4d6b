/// \file A glTF model becomes entities.
#pragma once

#include <string>

#include "assets/model.h"
#include "ecs/world.h"

namespace lampyris::scene {

/// Adds the default scene of a model to a world that has a Library. A node is an entity with Name
/// and Transform under its parent's; its primitive is a MeshInstance on it, several are children of
/// it; its camera and light are components on it, its skin and morph weights on what it draws.
/// Animations are clips of the Library; an entity named after the file plays the first. Takes the
/// meshes out of the model. Point lights of intensity I have Φ = 4πI · colour; directional ones are
/// left out, with one warning that names the scene; so are joints outside the scene, and skins of
/// meshes without joints.
void instantiate(ecs::World& world, assets::Model model, const std::string& scene);

}  // namespace lampyris::scene
