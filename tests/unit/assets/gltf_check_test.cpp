#include <gtest/gtest.h>

#include <functional>

#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

/// A file with a bit of everything that can be checked, and right.
GltfBuilder fullFile() {
    GltfBuilder builder = GltfBuilder::triangle();  // accessor 0, view 0: positions, 36 bytes
    builder.json["meshes"][0]["primitives"][0]["indices"] =
        builder.addAccessor<uint16_t>({0, 1, 2}, "SCALAR", kUshort);  // accessor 1, view 1
    const int sparseIndices = builder.addView({1, 2});
    const int sparseValues = builder.addView(std::vector<uint8_t>(24));
    builder.push("accessors",
                 {{"componentType", kFloat},
                  {"type", "VEC3"},
                  {"count", 3},
                  {"sparse",
                   {{"count", 2},
                    {"indices", {{"bufferView", sparseIndices}, {"componentType", kUbyte}}},
                    {"values", {{"bufferView", sparseValues}}}}}});
    builder.push("images", {{"bufferView", 3}, {"mimeType", "image/png"}});
    builder.push("samplers", Json::object());
    builder.push("textures", {{"source", 0}, {"sampler", 0}});
    builder.push("materials", {{"occlusionTexture", {{"index", 0}}}});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.push("cameras",
                 {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.push("nodes", {{"children", {2}}, {"camera", 0}});
    builder.push("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    builder.push("skins", {{"joints", {1, 2}}});
    const int times = builder.addFloats({0, 1}, "SCALAR");
    const int values = builder.addFloats({0, 0, 0, 1, 1, 1}, "VEC3");
    builder.push("animations",
                 {{"samplers", {{{"input", times}, {"output", values}}}},
                  {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "scale"}}}}}}});
    return builder;
}

TEST(GltfCheck, TheFileThatTheOthersBendIsRight) {
    EXPECT_EQ(fullFile().model().meshes.size(), 1u);
}

struct Bend {
    const char* name;
    const char* pointer;  ///< where the document is changed
    Json value;           ///< to what
    const char* message;  ///< what the error says, after the file's name
};

void PrintTo(const Bend& bend, std::ostream* out) {
    *out << bend.name;
}

class GltfCheckBent : public testing::TestWithParam<Bend> {};

TEST_P(GltfCheckBent, IsAnErrorThatNamesThePlace) {
    GltfBuilder builder = fullFile();
    builder.json[Json::json_pointer(GetParam().pointer)] = GetParam().value;
    EXPECT_EQ(builder.error(), std::string("test.gltf: ") + GetParam().message);
}

const Json kHuge = 9007199254740992;

INSTANTIATE_TEST_SUITE_P(
    Ranges, GltfCheckBent,
    testing::Values(
        Bend{"viewTooLong", "/bufferViews/0/byteLength", 4000,
             "/bufferViews/0: reaches byte 4000 of a buffer of 104"},
        Bend{"viewOffset", "/bufferViews/0/byteOffset", kHuge,
             "/bufferViews/0: reaches byte 9007199254741028 of a buffer of 104"},
        Bend{"viewLengthHuge", "/bufferViews/0/byteLength", 1e300,
             "/bufferViews/0/byteLength: must be a whole number from 0 to 2^53"},
        Bend{"viewNegative", "/bufferViews/0/byteOffset", -4,
             "/bufferViews/0/byteOffset: must be a whole number from 0 to 2^53"},
        Bend{"viewEmpty", "/bufferViews/0/byteLength", 0, "/bufferViews/0: has a byteLength of 0"},
        Bend{"viewBuffer", "/bufferViews/0/buffer", 1,
             "/bufferViews/0/buffer: is 1, and there are 1"},
        Bend{"viewStride", "/bufferViews/0/byteStride", 6,
             "/bufferViews/0: has a byteStride of 6, which is no multiple of 4 from 4 to 252"},
        Bend{"accessorCount", "/accessors/0/count", 4,
             "/accessors/0: reaches byte 48 of a view of 36"},
        Bend{"accessorHugeCount", "/accessors/0/count", 2147483647,
             "/accessors/0: reaches byte 25769803764 of a view of 36"},
        Bend{"accessorCountOverInt", "/accessors/0/count", 4294967295,
             "/accessors/0: has a count of 4294967295"},
        Bend{"accessorNone", "/accessors/0/count", 0, "/accessors/0: has a count of 0"},
        Bend{"accessorOffset", "/accessors/0/byteOffset", 4,
             "/accessors/0: reaches byte 40 of a view of 36"},
        Bend{"accessorStride", "/bufferViews/0/byteStride", 16,
             "/accessors/0: reaches byte 44 of a view of 36"},
        Bend{"accessorNarrow", "/bufferViews/0/byteStride", 8,
             "/accessors/0: has elements of 12 bytes, 8 apart"},
        Bend{"accessorView", "/accessors/0/bufferView", 99,
             "/accessors/0/bufferView: is 99, and there are 6"},
        Bend{"accessorType", "/accessors/0/type", "VEC5",
             "/accessors/0: has elements of VEC5 of componentType 5126"},
        Bend{"accessorComponent", "/accessors/0/componentType", 5130,
             "/accessors/0: has elements of VEC3 of componentType 5130"},
        Bend{"accessorBomb", "/accessors/2/count", 2000000000,
             "/accessors/2: has a count of 2000000000 without a bufferView"},
        Bend{"sparseCount", "/accessors/2/sparse/count", 4,
             "/accessors/2/sparse: replaces 4 elements of 3"},
        Bend{"sparseIndices", "/accessors/2/sparse/indices/byteOffset", 1,
             "/accessors/2/sparse/indices: reaches byte 3 of a view of 2"},
        Bend{"sparseIndexType", "/accessors/2/sparse/indices/componentType", 5126,
             "/accessors/2/sparse/indices: has the componentType 5126, which is no unsigned "
             "integer"},
        Bend{"sparseIndexView", "/accessors/2/sparse/indices/bufferView", 77,
             "/accessors/2/sparse/indices/bufferView: is 77, and there are 6"},
        Bend{"sparseValues", "/accessors/2/sparse/values/byteOffset", 4,
             "/accessors/2/sparse/values: reaches byte 28 of a view of 24"},
        Bend{"imageView", "/images/0/bufferView", 6, "/images/0/bufferView: is 6, and there are 6"},
        Bend{"imageBoth", "/images/0/uri", "a.png",
             "/images/0: must have one of uri and bufferView"},
        Bend{"bufferLonger",
             "/buffers",
             {{{"byteLength", 9}, {"uri", "data:;base64,AAAA"}}},
             "/buffers/0: has a byteLength of 9, and its data 3 bytes"},
        Bend{"bufferNoUri",
             "/buffers",
             {{{"byteLength", 9}}},
             "/buffers/0: has no uri, and there is no GLB chunk for it"},
        Bend{"bufferUri",
             "/buffers",
             {{{"byteLength", 1}, {"uri", "data:;base64,!"}}},
             "/buffers/0/uri: is a data: URI with characters that are no base64"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    References, GltfCheckBent,
    testing::Values(
        Bend{"tableNoArray", "/meshes", Json::object(), "/meshes: must be an array"},
        Bend{"elementNoObject", "/nodes/0", 7, "/nodes/0: must be an object"},
        Bend{"attribute", "/meshes/0/primitives/0/attributes/POSITION", 9,
             "/meshes/0/primitives/0/attributes/POSITION: is 9, and there are 5"},
        Bend{"floatIndex", "/meshes/0/primitives/0/attributes/POSITION", 0.0,
             "/meshes/0/primitives/0/attributes/POSITION: must be a whole number from 0"},
        Bend{"indices", "/meshes/0/primitives/0/indices", -1,
             "/meshes/0/primitives/0/indices: must be a whole number from 0"},
        Bend{"indicesNoView", "/meshes/0/primitives/0/indices", 2,
             "/meshes/0/primitives/0: its indices, accessor 2, have no bufferView"},
        Bend{"material", "/meshes/0/primitives/0/material", 1,
             "/meshes/0/primitives/0/material: is 1, and there are 1"},
        Bend{"mode", "/meshes/0/primitives/0/mode", 7,
             "/meshes/0/primitives/0: has the unknown mode 7"},
        Bend{"texture", "/materials/0/occlusionTexture/index", 1,
             "/materials/0/occlusionTexture/index: is 1, and there are 1"},
        Bend{"textureImage", "/textures/0/source", 3, "/textures/0/source: is 3, and there are 1"},
        Bend{"textureSampler", "/textures/0/sampler", 3,
             "/textures/0/sampler: is 3, and there are 1"},
        Bend{"factorLength",
             "/materials/0/emissiveFactor",
             {1, 2},
             "/materials/0/emissiveFactor: has 2 numbers in place of 3"},
        Bend{"factorTooLarge",
             "/materials/0/emissiveFactor",
             {0, 1e39, 0},
             "/materials/0/emissiveFactor/1: is too large for a 32-bit float"},
        Bend{"node", "/nodes/0/mesh", 1, "/nodes/0/mesh: is 1, and there are 1"},
        Bend{"camera", "/nodes/0/camera", 1, "/nodes/0/camera: is 1, and there are 1"},
        Bend{"light", "/nodes/2/extensions/KHR_lights_punctual/light", 1,
             "/nodes/2/extensions/KHR_lights_punctual/light: is 1, and there are 1"},
        Bend{"matrix",
             "/nodes/0/matrix",
             {1, 2, 3},
             "/nodes/0/matrix: has 3 numbers in place of 16"},
        Bend{"translation",
             "/nodes/0/translation",
             {0, "x", 0},
             "/nodes/0/translation/1: must be a number"},
        Bend{"cycle", "/nodes/2/children", {1}, "/nodes/1: is its own ancestor"},
        Bend{"ownChild", "/nodes/0/children", {0}, "/nodes/0: is its own ancestor"},
        Bend{"twoParents",
             "/nodes/0/children",
             {2},
             "/nodes/1/children/0: node 2 has a second parent"},
        Bend{"child", "/nodes/0/children", {44}, "/nodes/0/children/0: is 44, and there are 3"},
        Bend{"sceneNode", "/scenes/0/nodes", {3}, "/scenes/0/nodes/0: is 3, and there are 3"},
        Bend{"sceneChild",
             "/scenes/0/nodes",
             {0, 2},
             "/scenes/0/nodes/1: node 2 is the child of another"},
        Bend{"sceneTwice",
             "/scenes/0/nodes",
             {0, 0},
             "/scenes/0/nodes/1: node 0 stands there twice"},
        Bend{"scene", "/scene", 1, "/scene: is 1, and there are 1"},
        Bend{"joint", "/skins/0/joints", {5}, "/skins/0/joints/0: is 5, and there are 3"},
        Bend{"noJoints", "/skins/0/joints", Json::array(), "/skins/0: has no joints"},
        Bend{"animationInput", "/animations/0/samplers/0/input", 30,
             "/animations/0/samplers/0/input: is 30, and there are 5"},
        Bend{"animationSampler", "/animations/0/channels/0/sampler", 1,
             "/animations/0/channels/0/sampler: is 1, and there are 1"},
        Bend{"animationNode", "/animations/0/channels/0/target/node", 3,
             "/animations/0/channels/0/target/node: is 3, and there are 3"},
        Bend{"lens", "/cameras/0/perspective/yfov", 0,
             "/cameras/0/perspective: has a yfov of 0, which is not between 0 and pi"},
        Bend{"lightType", "/extensions/KHR_lights_punctual/lights/0/type", "area",
             "/extensions/KHR_lights_punctual/lights/0: has the unknown type area"},
        Bend{"lightIntensity", "/extensions/KHR_lights_punctual/lights/0/intensity", -1,
             "/extensions/KHR_lights_punctual/lights/0: has a negative intensity"}),
    [](const auto& info) { return info.param.name; });

TEST(GltfCheck, ALongChainOfNodesIsFine) {
    GltfBuilder builder = GltfBuilder::triangle();
    for (int i = 1; i < 20000; ++i) {
        builder.json["nodes"][static_cast<size_t>(i) - 1]["children"] = {i};
        builder.push("nodes", Json::object());
    }
    EXPECT_EQ(builder.model().nodes.size(), 20000u);
}

TEST(GltfCheck, MemoryBeyondTheLimitIsRefused) {
    const GltfBuilder builder = GltfBuilder::triangle();
    const auto result = assets::parseGltf(builder.glb(), "test.glb", {}, {.decodedBytes = 40});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("the limit for a file is 40"), std::string::npos);
}

TEST(GltfCheck, AThousandWarningsAreAScreenOfThem) {
    GltfBuilder builder = GltfBuilder::triangle();
    for (int i = 0; i < 1000; ++i)
        builder.addMesh({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    const std::string log = logOf([&] { EXPECT_TRUE(builder.load()); });
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 21);
    EXPECT_NE(log.find("test.gltf: and 980 more warnings"), std::string::npos);
}

}  // namespace
}  // namespace lampyris::test
