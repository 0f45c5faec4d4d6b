#include <algorithm>
#include <cmath>

#include "assets/gltf_accessor.h"

namespace lampyris::assets {
namespace {

core::Result<ModelSkin> readSkin(GltfSource& source, const tinygltf::Skin& from,
                                 const std::string& place) {
    ModelSkin skin;
    skin.name = from.name;
    skin.joints.assign(from.joints.begin(), from.joints.end());
    if (from.inverseBindMatrices < 0) {
        skin.inverseBindMatrices.assign(skin.joints.size(), glm::mat4(1.0f));
        return skin;
    }
    const size_t count = allOf(source, from.inverseBindMatrices).count;
    if (count < skin.joints.size())
        return source.context.error(place, "has {} joints and {} inverse bind matrices",
                                    skin.joints.size(), count);
    TRY(const std::vector<float> floats,
        readFloats(source, from.inverseBindMatrices, 16, {0, skin.joints.size()}));
    if (!std::all_of(floats.begin(), floats.end(), [](float f) { return std::isfinite(f); }))
        return source.context.error(place, "an inverse bind matrix is not finite");
    skin.inverseBindMatrices.resize(skin.joints.size());
    for (size_t i = 0; i < floats.size(); ++i)
        skin.inverseBindMatrices[i / 16][static_cast<int>(i / 4 % 4)][static_cast<int>(i % 4)] =
            floats[i];
    return skin;
}

uint32_t highestJoint(const Mesh& mesh) {
    uint32_t highest = 0;
    for (const glm::uvec4& joints : mesh.joints)
        highest = std::max({highest, joints.x, joints.y, joints.z, joints.w});
    return highest;
}

}  // namespace

core::Result<void> readSkins(GltfSource& source, Model& model) {
    for (const tinygltf::Skin& from : source.document.skins) {
        TRY(ModelSkin skin, readSkin(source, from, fmt::format("/skins/{}", model.skins.size())));
        model.skins.push_back(std::move(skin));
    }
    std::vector<uint32_t> highest;
    for (const Mesh& mesh : model.meshes) highest.push_back(highestJoint(mesh));
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        const ModelNode& node = model.nodes[i];
        if (node.skin < 0) continue;
        const size_t joints = model.skins[static_cast<size_t>(node.skin)].joints.size();
        for (const ModelPrimitive& primitive : node.primitives)
            if (highest[primitive.mesh] >= joints)
                return source.context.error(
                    fmt::format("/nodes/{}", i), "mesh {} has the joint {}, and skin {} has {}",
                    model.meshes[primitive.mesh].name, highest[primitive.mesh], node.skin, joints);
    }
    return {};
}

}  // namespace lampyris::assets
