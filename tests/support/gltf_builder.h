/// \file Small glTF files made in memory: right by default, then bent by a test through `json`.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "assets/gltf.h"

namespace lampyris::test {

using Json = nlohmann::json;

enum ComponentType { kByte = 5120, kUbyte, kShort, kUshort, kUint = 5125, kFloat };

inline std::string base64(const std::vector<uint8_t>& bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8u | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[group >> (18u - 6u * k) & 63u];
    }
    return text;
}

/// A document and the bytes of its only buffer.
class GltfBuilder {
 public:
    Json json = {{"asset", {{"version", "2.0"}}}};
    std::vector<uint8_t> bytes;

    /// Appends a view of these bytes, at a multiple of four.
    int addView(const std::vector<uint8_t>& data, int stride = 0) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        Json view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
        if (stride != 0) view["byteStride"] = stride;
        bytes.insert(bytes.end(), data.begin(), data.end());
        return push("bufferViews", view);
    }

    /// Appends an accessor of packed numbers.
    template <typename Number>
    int addAccessor(const std::vector<Number>& numbers, const char* type, int componentType,
                    bool normalized = false) {
        std::vector<uint8_t> data(numbers.size() * sizeof(Number));
        std::memcpy(data.data(), numbers.data(), data.size());
        const int components = type[0] == 'S' ? 1 : type[0] == 'M' ? 16 : type[3] - '0';
        return push("accessors", {{"bufferView", addView(data)},
                                  {"componentType", componentType},
                                  {"type", type},
                                  {"count", numbers.size() / static_cast<size_t>(components)},
                                  {"normalized", normalized}});
    }
    int addFloats(const std::vector<float>& numbers, const char* type) {
        return addAccessor(numbers, type, kFloat);
    }

    /// Appends to a table of the document; gives the index.
    int push(const char* table, const Json& value) {
        json[table].push_back(value);
        return static_cast<int>(json[table].size()) - 1;
    }

    /// A mesh of one primitive, drawn by a node of its own in scene 0.
    Json& addMesh(const Json& primitive) {
        const int mesh =
            push("meshes", {{"name", "shape"}, {"primitives", Json::array({primitive})}});
        const int node = push("nodes", {{"mesh", mesh}});
        json["scenes"][0]["nodes"].push_back(node);
        return json["meshes"][static_cast<size_t>(mesh)]["primitives"][0];
    }

    /// An extra accessor as an attribute of the first primitive.
    void addAttribute(const char* name, int accessor) {
        json["meshes"][0]["primitives"][0]["attributes"][name] = accessor;
    }

    /// One light of KHR_lights_punctual, at so many nodes of scene 0.
    void addLight(const Json& light, int nodes = 1) {
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
        for (int i = 0; i < nodes; ++i)
            json["scenes"][0]["nodes"].push_back(
                push("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}));
    }

    /// A floor of two triangles.
    static GltfBuilder floor(const std::vector<float>& positions = {-1, 0, -1, 1, 0, -1, 1, 0, 1,
                                                                    -1, 0, 1}) {
        GltfBuilder builder;
        const int points = builder.addFloats(positions, "VEC3");
        const int indices = builder.addAccessor<uint16_t>({0, 2, 1, 0, 3, 2}, "SCALAR", kUshort);
        builder.addMesh({{"attributes", {{"POSITION", points}}}, {"indices", indices}});
        return builder;
    }

    /// One right-angled triangle in the plane z = 0, facing +z; no normals, no indices.
    static GltfBuilder triangle() {
        GltfBuilder builder;
        builder.addMesh({{"attributes",
                          {{"POSITION", builder.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}}}});
        return builder;
    }

    /// The text of a .gltf file with the buffer as a data: URI.
    [[nodiscard]] std::vector<uint8_t> gltf() const {
        Json whole = json;
        if (!bytes.empty() && !whole.contains("buffers"))
            whole["buffers"] = {{{"byteLength", bytes.size()},
                                 {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        const std::string text = whole.dump();
        return {text.begin(), text.end()};
    }

    /// The bytes of a .glb file.
    [[nodiscard]] std::vector<uint8_t> glb() const {
        Json whole = json;
        if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::vector<uint8_t> binary = bytes;
        binary.resize((binary.size() + 3) / 4 * 4);
        std::vector<uint8_t> file;
        const auto put = [&](size_t word) {
            for (unsigned shift = 0; shift < 32; shift += 8)
                file.push_back(static_cast<uint8_t>(word >> shift));
        };
        for (const size_t word : {size_t{0x46546c67}, size_t{2}, 28 + text.size() + binary.size()})
            put(word);
        put(text.size());
        put(0x4e4f534a);
        file.insert(file.end(), text.begin(), text.end());
        put(binary.size());
        put(0x004e4942);
        file.insert(file.end(), binary.begin(), binary.end());
        return file;
    }

    [[nodiscard]] core::Result<assets::Model> load() const {
        return assets::parseGltf(gltf(), "test.gltf");
    }
    /// The model, which must load.
    [[nodiscard]] assets::Model model() const {
        auto result = load();
        if (!result) {
            ADD_FAILURE() << result.error().message;
            return {};
        }
        return std::move(result).value();
    }
    /// The message of a load that must fail.
    [[nodiscard]] std::string error() const {
        const auto result = load();
        return result ? "(loaded)" : result.error().message;
    }
};

/// What `action` writes to the log.
inline std::string logOf(const std::function<void()>& action) {
    testing::internal::CaptureStderr();
    action();
    return testing::internal::GetCapturedStderr();
}

}  // namespace lampyris::test
