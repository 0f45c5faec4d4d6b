// libFuzzer target for the glTF reader: whatever the bytes, a sound model or an error.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "assets/gltf.h"
#include "core/check.h"
#include "core/log.h"

namespace {

using lampyris::assets::Mesh;
using lampyris::assets::Model;
using lampyris::assets::ModelNode;

void put(std::vector<uint8_t>& file, size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<uint8_t>(word >> shift));
}

/// JSON, a zero byte and binary data become a GLB whose lengths are right: mutations of one that
/// was whole rarely get past its header.
std::vector<uint8_t> toGlb(std::span<const uint8_t> json, std::span<const uint8_t> binary) {
    std::vector<uint8_t> file;
    for (const size_t word : {size_t{0x46546c67}, size_t{2}, 28 + json.size() + binary.size()})
        put(file, word);
    put(file, json.size());
    put(file, 0x4e4f534a);
    file.insert(file.end(), json.begin(), json.end());
    file.resize((file.size() + 3) / 4 * 4, ' ');
    put(file, binary.size());
    put(file, 0x004e4942);
    file.insert(file.end(), binary.begin(), binary.end());
    const size_t length = file.size();
    for (size_t i = 0; i < 4; ++i) file[8 + i] = static_cast<uint8_t>(length >> (8 * i));
    return file;
}

void checkMesh(const Mesh& mesh) {
    CHECK(mesh.triangleCount() > 0u);
    CHECK(mesh.normals.size() == mesh.positions.size());
    for (const uint32_t index : mesh.indices) CHECK(index < mesh.positions.size());
    for (const glm::vec3& position : mesh.positions)
        for (int c = 0; c < 3; ++c) CHECK(std::isfinite(position[c]));
    for (const glm::vec3& normal : mesh.normals)
        CHECK(std::abs(glm::length(normal) - 1.0f) < 1e-3f);
    for (const size_t size : {mesh.tangents.size(), mesh.texcoords0.size(), mesh.texcoords1.size(),
                              mesh.colours.size(), mesh.joints.size(), mesh.weights.size()})
        CHECK((size == 0 || size == mesh.positions.size()));
    for (const glm::vec4& tangent : mesh.tangents)
        CHECK(std::abs(glm::length(glm::vec3(tangent)) - 1.0f) < 1e-3f);
    CHECK(mesh.morphWeights.size() == mesh.morphTargets.size());
}

void checkModel(const Model& model) {
    for (const Mesh& mesh : model.meshes) checkMesh(mesh);
    for (const ModelNode& node : model.nodes) {
        CHECK(node.parent < static_cast<int>(model.nodes.size()));
        CHECK(node.camera < static_cast<int>(model.cameras.size()));
        CHECK(node.light < static_cast<int>(model.lights.size()));
        CHECK(node.skin < static_cast<int>(model.skins.size()));
        for (const uint32_t child : node.children) CHECK(child < model.nodes.size());
        for (const auto& primitive : node.primitives) {
            CHECK(primitive.mesh < model.meshes.size());
            CHECK(primitive.material < model.materials.size());
        }
    }
    for (const auto& material : model.materials)
        CHECK(material.baseColourTexture.image < static_cast<int>(model.images.size()));
    for (const auto& image : model.images)
        CHECK(image.rgba.size() == size_t{4} * image.width * image.height);
    for (const auto& animation : model.animations)
        for (const auto& channel : animation.channels) {
            CHECK(channel.sampler < animation.samplers.size());
            CHECK(channel.node < model.nodes.size());
        }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    lampyris::core::setLogLevel(lampyris::core::LogLevel::Error);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    std::span<const uint8_t> input(data, size);
    std::vector<uint8_t> glb;
    const auto zero = std::find(input.begin(), input.end(), uint8_t{0});
    if (!input.empty() && input.front() == '{' && zero != input.end()) {
        const auto split = static_cast<size_t>(zero - input.begin());
        glb = toGlb(input.first(split), input.subspan(split + 1));
        input = glb;
    }
    const auto model = lampyris::assets::parseGltf(input, "fuzz", {},
                                                   {.decodedBytes = 1u << 26u, .imageSide = 512});
    if (model) checkModel(*model);
    return 0;
}
