#include <algorithm>
#include <limits>

#include "assets/gltf_source.h"
#include "assets/transform.h"

namespace lampyris::assets {
namespace {

using Primitives = std::vector<std::vector<ModelPrimitive>>;

constexpr float kSmallestNear = 1e-4f;    // metres [chosen]
constexpr float kSmallestFov = 1e-3f;     // radians [chosen] a pinhole needs an opening
constexpr double kConeSeparation = 1e-4;  // radians [chosen] between inner and outer cone

/// extras.radius, where it is a radius.
std::optional<float> radiusIn(const tinygltf::Value& extras, GltfContext& context,
                              const std::string& place) {
    if (!extras.IsObject() || !extras.Has("radius")) return {};
    const tinygltf::Value& value = extras.Get("radius");
    const double radius = value.IsNumber() ? value.GetNumberAsDouble() : 0.0;
    if (radius > std::numeric_limits<float>::min() && radius < std::numeric_limits<float>::max())
        return static_cast<float>(radius);
    context.warn(place + "/extras/radius", "is no length above 0 and is left out");
    return {};
}

void readLights(GltfSource& source, Model& model) {
    for (const tinygltf::Light& from : source.document.lights) {
        const std::string place =
            fmt::format("/extensions/KHR_lights_punctual/lights/{}", model.lights.size());
        ModelLight to;
        to.name = from.name;
        for (size_t c = 0; c < from.color.size(); ++c)
            to.colour[static_cast<int>(c)] = static_cast<float>(std::max(from.color[c], 0.0));
        to.intensity = static_cast<float>(from.intensity);
        to.rangeMetres = static_cast<float>(from.range);
        to.radiusMetres = radiusIn(from.extras, source.context, place).value_or(to.radiusMetres);
        if (from.type == "directional") to.type = LightType::Directional;
        if (from.type == "spot") {
            to.type = LightType::Spot;
            const double outer = std::max(from.spot.outerConeAngle, kConeSeparation);
            to.outerConeRadians = static_cast<float>(outer);
            to.innerConeRadians =
                static_cast<float>(std::min(from.spot.innerConeAngle, outer - kConeSeparation));
        }
        model.lights.push_back(std::move(to));
    }
}

/// Gives for every camera of the file its index in the model, −1 for an orthographic one.
std::vector<int32_t> readCameras(GltfSource& source, Model& model) {
    std::vector<int32_t> indices;
    for (const tinygltf::Camera& from : source.document.cameras) {
        if (from.type != "perspective") {
            source.context.warn(fmt::format("/cameras/{}", indices.size()),
                                "is orthographic and is left out");
            indices.push_back(-1);
            continue;
        }
        indices.push_back(static_cast<int32_t>(model.cameras.size()));
        model.cameras.push_back(
            {from.name, std::max(static_cast<float>(from.perspective.yfov), kSmallestFov),
             std::max(static_cast<float>(from.perspective.znear), kSmallestNear)});
    }
    return indices;
}

void readTransform(const tinygltf::Node& from, ModelNode& to, GltfContext& context,
                   const std::string& place) {
    const auto set = [](const std::vector<double>& numbers, auto& vector) {
        for (size_t c = 0; c < numbers.size(); ++c)
            vector[static_cast<int>(c)] = static_cast<float>(numbers[c]);
    };
    if (from.matrix.size() == 16) {
        glm::dmat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = from.matrix[static_cast<size_t>(i)];
        const DecomposedMatrix parts = decompose(matrix);
        if (parts.sheared) context.warn(place + "/matrix", "shears, and is drawn without that");
        to.translation = parts.translation;
        to.rotation = parts.rotation;
        to.scale = parts.scale;
        return;
    }
    set(from.translation, to.translation);
    set(from.scale, to.scale);
    glm::vec4 xyzw(0.0f, 0.0f, 0.0f, 1.0f);
    set(from.rotation, xyzw);
    const double length = glm::length(glm::dvec4(xyzw));
    if (length > 0.0)
        to.rotation = glm::quat(
            glm::dquat(xyzw.w / length, xyzw.x / length, xyzw.y / length, xyzw.z / length));
    else
        context.warn(place + "/rotation", "is zero, and is drawn as none");
}

int32_t lightOf(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    if (found == node.extensions.end() || !found->second.Has("light")) return -1;
    return found->second.Get("light").GetNumberAsInt();
}

void readMorphWeights(const tinygltf::Node& from, ModelNode& to, const Model& model,
                      GltfContext& context, const std::string& place) {
    if (from.weights.empty()) return;
    for (const ModelPrimitive& primitive : to.primitives) {
        const size_t targets = model.meshes[primitive.mesh].morphTargets.size();
        if (targets == from.weights.size()) continue;
        context.warn(place + "/weights", "are {} for a mesh of {} targets, and are left out",
                     from.weights.size(), targets);
        return;
    }
    to.morphWeights.assign(from.weights.begin(), from.weights.end());
}

/// The default scene's nodes; without scenes, all that have no parent.
std::vector<uint32_t> findRoots(const tinygltf::Model& document,
                                const std::vector<ModelNode>& nodes) {
    std::vector<uint32_t> roots;
    if (!document.scenes.empty()) {
        const auto scene = static_cast<size_t>(std::max(document.defaultScene, 0));
        roots.assign(document.scenes[scene].nodes.begin(), document.scenes[scene].nodes.end());
        return roots;
    }
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) roots.push_back(i);
    return roots;
}

bool drawsSomething(const Model& model) {
    std::vector<uint32_t> open = model.roots;
    while (!open.empty()) {
        const ModelNode& node = model.nodes[open.back()];
        open.pop_back();
        if (!node.primitives.empty()) return true;
        open.insert(open.end(), node.children.begin(), node.children.end());
    }
    return false;
}

}  // namespace

core::Result<void> readNodes(GltfSource& source, const Primitives& primitives, Model& model) {
    readLights(source, model);
    const std::vector<int32_t> cameras = readCameras(source, model);
    const std::vector<tinygltf::Node>& nodes = source.document.nodes;
    model.nodes.resize(nodes.size());
    for (size_t i = 0; i < nodes.size(); ++i) {
        const tinygltf::Node& from = nodes[i];
        const std::string place = fmt::format("/nodes/{}", i);
        ModelNode& to = model.nodes[i];
        to.name = from.name;
        to.children.assign(from.children.begin(), from.children.end());
        for (const uint32_t child : to.children)
            model.nodes[child].parent = static_cast<int32_t>(i);
        readTransform(from, to, source.context, place);
        if (from.mesh >= 0) {
            const auto& drawn = primitives[static_cast<size_t>(from.mesh)];
            TRY_VOID(source.context.takeBytes(place, drawn.size() * sizeof(ModelPrimitive)));
            to.primitives = drawn;
        }
        if (from.camera >= 0) to.camera = cameras[static_cast<size_t>(from.camera)];
        to.skin = from.skin;
        to.light = lightOf(from);
        if (to.light >= 0) to.lightRadiusMetres = radiusIn(from.extras, source.context, place);
        readMorphWeights(from, to, model, source.context, place);
    }
    model.roots = findRoots(source.document, model.nodes);
    if (!drawsSomething(model)) return source.context.error("", "has no mesh in its default scene");
    return {};
}

}  // namespace lampyris::assets
