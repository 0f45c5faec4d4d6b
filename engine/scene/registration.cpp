#include "scene/registration.h"

#include <cmath>
#include <string_view>

#include "scene/components.h"

namespace lampyris::scene {

using nlohmann::json;

namespace {

json toJson(const glm::vec3& v) {
    return json::array({v.x, v.y, v.z});
}

/// These overwrite `value` where the field is there.
core::Result<void> read(const json& object, const char* field, uint32_t& value) {
    const auto found = object.find(field);
    if (found == object.end()) return {};
    if (!found->is_number_unsigned() || found->get<uint64_t>() > 0xffffffffu) {
        return core::error("\"{}\" is not a number of 32 bits", field);
    }
    value = found->get<uint32_t>();
    return {};
}

core::Result<void> read(const json& object, const char* field, float& value) {
    const auto found = object.find(field);
    if (found == object.end()) return {};
    value = found->get<float>();
    if (!std::isfinite(value)) return core::error("\"{}\" is not finite", field);
    return {};
}

template <typename Vector>
core::Result<void> readVector(const json& object, const char* field, Vector& value) {
    const auto found = object.find(field);
    if (found == object.end()) return {};
    constexpr int kLength = Vector::length();
    if (!found->is_array() || found->size() != kLength) {
        return core::error("\"{}\" is not a list of {} numbers", field, kLength);
    }
    for (int i = 0; i < kLength; ++i) {
        value[i] = (*found)[static_cast<size_t>(i)].get<float>();
        if (!std::isfinite(value[i])) return core::error("\"{}\" is not finite", field);
    }
    return {};
}

json saveTransform(const Transform& transform) {
    const glm::quat& q = transform.rotation;
    return {{"translation", toJson(transform.translation)},
            {"rotation", json::array({q.x, q.y, q.z, q.w})},
            {"scale", toJson(transform.scale)}};
}

core::Result<Transform> loadTransform(const json& object) {
    Transform transform;
    glm::vec4 rotation(0.0f, 0.0f, 0.0f, 1.0f);
    TRY_VOID(readVector(object, "translation", transform.translation));
    TRY_VOID(readVector(object, "rotation", rotation));
    TRY_VOID(readVector(object, "scale", transform.scale));
    const float length = glm::length(rotation);
    if (!(length > 0.0f)) return core::error("\"rotation\" is zero");
    // A number of it that somebody typed turns, and does not stretch; rounding stays as it is.
    if (std::abs(length - 1.0f) > 1e-5f) rotation /= length;
    transform.rotation = glm::quat(rotation.w, rotation.x, rotation.y, rotation.z);
    return transform;
}

json saveMeshInstance(const MeshInstance& drawn) {
    json object = json::object();
    if (drawn.mesh.valid()) object["mesh"] = drawn.mesh.value;
    if (drawn.material.valid()) object["material"] = drawn.material.value;
    return object;
}

core::Result<MeshInstance> loadMeshInstance(const json& object) {
    MeshInstance drawn;
    TRY_VOID(read(object, "mesh", drawn.mesh.value));
    TRY_VOID(read(object, "material", drawn.material.value));
    return drawn;
}

json saveSphereLight(const SphereLight& light) {
    return {{"radius_metres", light.radiusMetres},
            {"power_watts", toJson(light.powerWatts)},
            {"cos_outer_cone", light.cosOuterCone},
            {"cos_inner_cone", light.cosInnerCone}};
}

core::Result<SphereLight> loadSphereLight(const json& object) {
    SphereLight light;
    TRY_VOID(read(object, "radius_metres", light.radiusMetres));
    TRY_VOID(readVector(object, "power_watts", light.powerWatts));
    TRY_VOID(read(object, "cos_outer_cone", light.cosOuterCone));
    TRY_VOID(read(object, "cos_inner_cone", light.cosInnerCone));
    if (!(light.radiusMetres > 0.0f)) return core::error("\"radius_metres\" is not above 0");
    if (glm::any(glm::lessThan(light.powerWatts, glm::vec3(0.0f)))) {
        return core::error("\"power_watts\" is under 0");
    }
    return light;
}

json saveCamera(const Camera& camera) {
    return {{"vertical_fov_radians", camera.verticalFovRadians},
            {"near_metres", camera.nearMetres}};
}

core::Result<Camera> loadCamera(const json& object) {
    Camera camera;
    TRY_VOID(read(object, "vertical_fov_radians", camera.verticalFovRadians));
    TRY_VOID(read(object, "near_metres", camera.nearMetres));
    if (!(camera.verticalFovRadians > 0.0f && camera.verticalFovRadians < math::kPi)) {
        return core::error("\"vertical_fov_radians\" is not between 0 and π");
    }
    if (!(camera.nearMetres > 0.0f)) return core::error("\"near_metres\" is not above 0");
    return camera;
}

core::Result<void> read(const json& object, const char* field, double& value) {
    const auto found = object.find(field);
    if (found == object.end()) return {};
    value = found->get<double>();
    if (!std::isfinite(value)) return core::error("\"{}\" is not finite", field);
    return {};
}

json saveEntities(const std::vector<ecs::Entity>& entities, const ecs::SavedEntities& saved) {
    json list = json::array();
    for (const ecs::Entity entity : entities) list.push_back(saved.reference(entity));
    return list;
}

core::Result<void> readEntities(const json& object, const char* field,
                                const ecs::LoadedEntities& loaded,
                                std::vector<ecs::Entity>& entities) {
    for (const json& reference : object.value(field, json::array())) {
        TRY(const ecs::Entity entity, loaded.entity(reference));
        entities.push_back(entity);
    }
    return {};
}

core::Result<MorphWeights> loadMorphWeights(const json& values) {
    MorphWeights weights{values.get<std::vector<float>>()};
    for (const float weight : weights.values)
        if (!std::isfinite(weight)) return core::error("a weight is not finite");
    return weights;
}

json saveSkin(const Skin& skin, const ecs::SavedEntities& saved) {
    std::vector<glm::mat4> inverse = skin.inverseBindMatrices;
    inverse.resize(skin.joints.size(), glm::mat4(1.0f));
    json matrices = json::array();
    for (const glm::mat4& matrix : inverse)
        for (int i = 0; i < 16; ++i) matrices.push_back(matrix[i / 4][i % 4]);
    return {{"joints", saveEntities(skin.joints, saved)}, {"inverse_bind_matrices", matrices}};
}

core::Result<Skin> loadSkin(const json& object, const ecs::LoadedEntities& loaded) {
    Skin skin;
    TRY_VOID(readEntities(object, "joints", loaded, skin.joints));
    const auto numbers = object.at("inverse_bind_matrices").get<std::vector<float>>();
    if (numbers.size() != 16 * skin.joints.size())
        return core::error("\"inverse_bind_matrices\" has {} numbers for {} joints", numbers.size(),
                           skin.joints.size());
    skin.inverseBindMatrices.resize(skin.joints.size());
    for (size_t i = 0; i < numbers.size(); ++i) {
        if (!std::isfinite(numbers[i]))
            return core::error("\"inverse_bind_matrices\" is not finite");
        skin.inverseBindMatrices[i / 16][static_cast<int>(i / 4 % 4)][static_cast<int>(i % 4)] =
            numbers[i];
    }
    return skin;
}

json savePatrol(const Patrol& patrol) {
    json waypoints = json::array();
    for (const glm::vec3& waypoint : patrol.waypoints) waypoints.push_back(toJson(waypoint));
    return {{"waypoints", waypoints},
            {"metres_per_second", patrol.metresPerSecond},
            {"start_seconds", patrol.startSeconds},
            {"closed", patrol.closed}};
}

core::Result<Patrol> loadPatrol(const json& object) {
    Patrol patrol;
    for (const json& waypoint : object.value("waypoints", json::array())) {
        glm::vec3& position = patrol.waypoints.emplace_back(0.0f);
        TRY_VOID(readVector({{"waypoint", waypoint}}, "waypoint", position));
    }
    TRY_VOID(read(object, "metres_per_second", patrol.metresPerSecond));
    TRY_VOID(read(object, "start_seconds", patrol.startSeconds));
    patrol.closed = object.value("closed", patrol.closed);
    return patrol;
}

json saveAnimationPlayer(const AnimationPlayer& player, const ecs::SavedEntities& saved) {
    json object = {{"targets", saveEntities(player.targets, saved)},
                   {"start_seconds", player.startSeconds},
                   {"speed", player.speed},
                   {"loops", player.loops}};
    if (player.clip.valid()) object["clip"] = player.clip.value;
    return object;
}

core::Result<AnimationPlayer> loadAnimationPlayer(const json& object,
                                                  const ecs::LoadedEntities& loaded) {
    AnimationPlayer player;
    TRY_VOID(read(object, "clip", player.clip.value));
    TRY_VOID(readEntities(object, "targets", loaded, player.targets));
    TRY_VOID(read(object, "start_seconds", player.startSeconds));
    TRY_VOID(read(object, "speed", player.speed));
    player.loops = object.value("loops", player.loops);
    return player;
}

}  // namespace

void registerComponents(ecs::Registry& registry) {
    registry.add<Name>(
        "name", [](const Name& name) { return json(name.value); },
        [](const json& text) -> core::Result<Name> { return Name{text.get<std::string>()}; });
    registry.add<Transform>("transform", saveTransform, loadTransform);
    registry.add<MeshInstance>("mesh", saveMeshInstance, loadMeshInstance);
    registry.add<MeshPart>(
        "mesh_part", [](const MeshPart&) { return json::object(); },
        [](const json&) -> core::Result<MeshPart> { return MeshPart{}; });
    registry.add<SphereLight>("sphere_light", saveSphereLight, loadSphereLight);
    registry.add<Camera>("camera", saveCamera, loadCamera);
    registry.add<MorphWeights>(
        "morph_weights", [](const MorphWeights& weights) { return json(weights.values); },
        loadMorphWeights);
    registry.add<Patrol>("patrol", savePatrol, loadPatrol);
    registry.add<Skin>("skin", saveSkin, loadSkin);
    registry.add<AnimationPlayer>("animation_player", saveAnimationPlayer, loadAnimationPlayer);
}

}  // namespace lampyris::scene
