// Whole files: the repository's own scenes, and those of others where they lie beside the
// repository.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "assets/gltf.h"
#include "assets/tangents.h"

namespace lampyris::assets {
namespace {

namespace fs = std::filesystem;

bool isGltf(const fs::path& path) {
    return path.extension() == ".gltf" || path.extension() == ".glb";
}

std::vector<fs::path> filesBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code code;
    for (const auto& entry : fs::recursive_directory_iterator(folder, code))
        if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
}

const fs::path kOthersScenes = fs::path(LAMPYRIS_SOURCE_DIR) / "../shared/scenes";

bool isMalformed(const fs::path& path) {
    return path.string().find("/malformed_") != std::string::npos;
}

/// What Model and Mesh promise.
void expectSound(const Model& model) {
    for (const Mesh& mesh : model.meshes) {
        ASSERT_GT(mesh.triangleCount(), 0u);
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
        for (const glm::vec3& position : mesh.positions)
            ASSERT_TRUE(std::isfinite(glm::dot(position, glm::vec3(1))));
        for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-4f);
        for (const glm::vec4& weights : mesh.weights)
            ASSERT_NEAR(glm::dot(weights, glm::vec4(1)), 1.0f, 1e-4f);
        ASSERT_EQ(mesh.morphWeights.size(), mesh.morphTargets.size());
    }
    for (const ModelNode& node : model.nodes)
        for (const ModelPrimitive& primitive : node.primitives) {
            ASSERT_LT(primitive.mesh, model.meshes.size());
            ASSERT_LT(primitive.material, model.materials.size());
        }
    for (const Material& material : model.materials)
        ASSERT_LT(material.baseColourTexture.image, static_cast<int32_t>(model.images.size()));
}

TEST(GltfScenes, GoodFilesLoad) {
    std::vector<fs::path> files = filesBelow(fs::path(LAMPYRIS_SOURCE_DIR) / "sandbox/scenes");
    for (const fs::path& path : filesBelow(kOthersScenes))
        if (!isMalformed(path)) files.push_back(path);
    for (const fs::path& path : files) {
        if (!isGltf(path)) continue;
        const auto model = loadGltf(path);
        ASSERT_TRUE(model) << model.error().message;
        expectSound(*model);
    }
}

TEST(GltfScenes, MalformedFilesAreTakenOrRefused) {
    for (const fs::path& path : filesBelow(kOthersScenes)) {
        if (!isMalformed(path)) continue;
        const auto model = loadGltf(path);
        if (model)
            expectSound(*model);
        else
            EXPECT_TRUE(model.error().message.starts_with(path.string() + ": "))
                << model.error().message;
    }
}

/// The share of vertices whose tangent agrees with another one's direction and sign.
double agreement(const Mesh& mesh, const std::vector<glm::vec4>& others) {
    size_t agreeing = 0;
    for (size_t i = 0; i < others.size(); ++i)
        if (glm::dot(glm::vec3(mesh.tangents[i]), glm::vec3(others[i])) > 0.9f &&
            mesh.tangents[i].w == others[i].w)
            ++agreeing;
    return static_cast<double>(agreeing) / static_cast<double>(others.size());
}

TEST(GltfScenes, GeneratedTangentsAgreeWithAnExporters) {
    for (const char* name : {"AlphaBlendModeTest/AlphaBlendModeTest.gltf",
                             "LightsPunctualLamp/LightsPunctualLamp.gltf"}) {
        if (!fs::exists(kOthersScenes / name)) continue;
        const auto model = loadGltf(kOthersScenes / name);
        ASSERT_TRUE(model) << model.error().message;
        for (Mesh mesh : model->meshes) {
            if (mesh.tangents.empty() || mesh.texcoords0.empty()) continue;
            const std::vector<glm::vec4> exported = mesh.tangents;
            generateTangents(mesh, 0);
            EXPECT_GT(agreement(mesh, exported), 0.95) << name << " " << mesh.name;
        }
    }
}

}  // namespace
}  // namespace lampyris::assets
