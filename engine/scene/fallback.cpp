#include "scene/fallback.h"

#include <algorithm>
#include <cmath>

#include "core/log.h"
#include "scene/library.h"
#include "scene/place_deformed.h"
#include "scene/spawn.h"

namespace lampyris::scene {

namespace {

/// In double, since products of large and tiny sizes leave the range of float.
struct Ball {
    glm::dvec3 centre{0.0};
    double radius = 1.0;  ///< metres, around the corners
};

Ball ballAround(const math::Bounds& bounds) {
    if (bounds.empty()) return {};
    const glm::dvec3 lower(bounds.lower);
    const glm::dvec3 upper(bounds.upper);
    const glm::dvec3 centre = 0.5 * (lower + upper);
    // A camera nearer than a few float steps of its own position would not see straight.
    const double smallest = std::max(1e-12, 1e-5 * glm::length(centre));
    const double radius = 0.5 * glm::length(upper - lower);
    if (radius == 0.0) return {centre, std::max(1.0, smallest)};
    return {centre, std::clamp(radius, smallest, 1e17)};
}

bool shines(const SphereLight& light) {
    return std::max({light.powerWatts.x, light.powerWatts.y, light.powerWatts.z}) > 0.0f;
}

bool anythingEmissive(const ecs::World& world) {
    const auto& materials = world.resource<Library>().materials();
    for (const auto& [entity, drawn] : world.view<MeshInstance>()) {
        if (!drawn.material.valid()) continue;
        const glm::vec3 radiance = materials[drawn.material.value].value->emissiveRadiance;
        if (std::max({radiance.x, radiance.y, radiance.z}) > 0.0f) return true;
    }
    return false;
}

/// posedBounds would be wider than what is seen.
math::Bounds exactBounds(const assets::Mesh& mesh, const Pose& pose) {
    math::Bounds bounds;
    for (const glm::vec3& p : posedVertices(mesh, pose).positions)
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) bounds.grow(p);
    return bounds;
}

bool anyLightShines(const ecs::World& world) {
    for (const auto& [entity, light] : world.view<SphereLight>()) {
        if (shines(light)) return true;
    }
    return false;
}

}  // namespace

Framing frame(const math::Bounds& bounds) {
    const Ball ball = ballAround(bounds);
    Framing result;
    const glm::dvec3 back = glm::normalize(glm::dvec3(1.0, 0.7, 1.0));
    // The ball touches the edges of the view: nearer by the corners would gain little.
    const double distance = 1.02 * ball.radius / std::sin(0.5 * result.camera.verticalFovRadians);
    result.transform.translation = glm::vec3(ball.centre + distance * back);
    result.transform.rotation = rotationFacing(back);
    result.camera.nearMetres = static_cast<float>(1e-3 * distance);
    return result;
}

LightAbove lightAbove(const math::Bounds& bounds) {
    constexpr double kMidGrey = 0.18;
    constexpr double kAlbedo = 0.5;
    constexpr double kMeanCosine = 0.5;  // over the half of the directions that is lit
    const Ball ball = ballAround(bounds);
    const glm::dvec3 offset =
        ball.radius * glm::dvec3(0.9, 1.8, 1.3);  // [chosen: lights three sides]
    const double irradiance = kMidGrey * math::kPi / (kAlbedo * kMeanCosine);
    const double power = 4.0 * math::kPi * glm::dot(offset, offset) * irradiance;
    return {glm::vec3(ball.centre + offset),
            {.radiusMetres = static_cast<float>(0.1 * ball.radius),
             .powerWatts = glm::vec3(static_cast<float>(power))}};
}

math::Bounds boundsWorld(const ecs::World& world) {
    const auto& library = world.resource<Library>();
    math::Bounds bounds;
    for (const auto& [entity, drawn, transform] : world.view<MeshInstance, WorldTransform>()) {
        if (!drawn.mesh.valid()) continue;
        const assets::Mesh& mesh = *library.meshes()[drawn.mesh.value].value;
        const PlacedPose placed = placeDeformed(world, entity, library.extentsOf(drawn.mesh));
        bounds.grow(math::transformed(placed.pose ? exactBounds(mesh, *placed.pose) : mesh.bounds,
                                      placed.objectToWorld));
    }
    return bounds;
}

void addMissingCamera(ecs::World& world, const std::string& scene) {
    if (world.count<Camera>() > 0) return;
    const Framing framing = frame(boundsWorld(world));
    world.add(spawn(world, "camera", framing.transform), framing.camera);
    core::logWarning("{}: no camera; one that frames the scene is used", scene);
}

void addMissingLight(ecs::World& world, const std::string& scene) {
    if (anyLightShines(world) || anythingEmissive(world)) return;
    if (world.count<SphereLight>() > 0) {
        core::logWarning("{}: its lights have no power, so that everything is black", scene);
        return;
    }
    const LightAbove above = lightAbove(boundsWorld(world));
    spawnLight(world, "light", above.position, above.light);
    core::logWarning("{}: no light; one sphere light above the scene is used", scene);
}

}  // namespace lampyris::scene
