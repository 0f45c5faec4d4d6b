#include "courtyard/paints.h"

namespace lampyris::courtyard {
namespace {

assets::Material shiny(const char* name, const glm::vec3& albedo, float metallic, float roughness) {
    assets::Material material;
    material.name = name;
    material.baseColour = glm::vec4(albedo, 1.0f);
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

}  // namespace

Paints makePaints(scene::Library& library) {
    const auto matt = [&](const char* name, const glm::vec3& albedo) {
        return library.addMaterial(scene::lambertian(name, albedo));
    };
    return {
        .plaster = matt("plaster", {0.78f, 0.62f, 0.43f}),
        .red = matt("red wall", {0.66f, 0.2f, 0.11f}),
        .teal = matt("teal wall", {0.12f, 0.5f, 0.5f}),
        .blue = matt("blue wall", {0.2f, 0.32f, 0.68f}),
        .ceiling = matt("ceiling", {0.74f, 0.7f, 0.64f}),
        .tiles = matt("floor tiles", {0.55f, 0.3f, 0.19f}),
        .slabs = matt("slabs", {0.52f, 0.47f, 0.42f}),
        .stone = matt("stone", {0.7f, 0.66f, 0.58f}),
        .clay = matt("clay", {0.68f, 0.27f, 0.13f}),
        .wood = matt("wood", {0.5f, 0.31f, 0.16f}),
        .darkWood = matt("dark wood", {0.26f, 0.15f, 0.08f}),
        .green = matt("shutters", {0.12f, 0.4f, 0.24f}),
        .leaf = matt("leaves", {0.2f, 0.48f, 0.1f}),
        .iron = matt("iron", {0.14f, 0.14f, 0.15f}),
        .linen = matt("linen", {0.78f, 0.73f, 0.62f}),
        .crimson = matt("crimson cloth", {0.65f, 0.06f, 0.08f}),
        .saffron = matt("saffron cloth", {0.8f, 0.5f, 0.06f}),
        .violet = matt("violet cloth", {0.4f, 0.16f, 0.55f}),
        .skin = matt("skin", {0.66f, 0.42f, 0.3f}),
        .white = matt("white paint", {0.8f, 0.8f, 0.78f}),
        .water = library.addMaterial(shiny("water", {0.1f, 0.42f, 0.46f}, 0.0f, 0.25f)),
        .copper = library.addMaterial(shiny("copper", {0.85f, 0.45f, 0.28f}, 0.6f, 0.45f)),
        .glaze = library.addMaterial(shiny("glaze", {0.08f, 0.22f, 0.5f}, 0.0f, 0.3f)),
    };
}

}  // namespace lampyris::courtyard
