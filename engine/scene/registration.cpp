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
    if (!(glm::length(rotation) > 0.0f)) return core::error("\"rotation\" is zero");
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

}  // namespace

void registerComponents(ecs::Registry& registry) {
    registry.add<Name>(
        "name", [](const Name& name) { return json(name.value); },
        [](const json& text) -> core::Result<Name> { return Name{text.get<std::string>()}; });
    registry.add<Transform>("transform", saveTransform, loadTransform);
    registry.add<MeshInstance>("mesh", saveMeshInstance, loadMeshInstance);
    registry.add<SphereLight>("sphere_light", saveSphereLight, loadSphereLight);
    registry.add<Camera>("camera", saveCamera, loadCamera);
}

}  // namespace lampyris::scene
