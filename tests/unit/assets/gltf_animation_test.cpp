#include <gtest/gtest.h>

#include <cmath>

#include "assets/animation_sampling.h"
#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

/// A triangle that moves: one sampler with these keys, one channel.
GltfBuilder animated(const std::vector<float>& times, const std::vector<float>& values,
                     const char* type, const char* path, const char* interpolation) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
    const int input = builder.addFloats(times, "SCALAR");
    const int output = builder.addFloats(values, type);
    builder.push(
        "animations",
        {{"name", "swing"},
         {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
    return builder;
}

TEST(GltfAnimation, LinearKeysAreKept) {
    const assets::Model model =
        animated({0.5f, 2}, {1, 2, 3, 4, 5, 6}, "VEC3", "translation", "LINEAR").model();
    ASSERT_EQ(model.animations.size(), 1u);
    const assets::Animation& animation = model.animations[0];
    EXPECT_EQ(animation.name, "swing");
    EXPECT_EQ(animation.durationSeconds, 2.0f);
    EXPECT_EQ(animation.channels.at(0).property, assets::AnimatedProperty::Translation);
    EXPECT_EQ(animation.samplers.at(0).times, (std::vector<float>{0.5f, 2}));
    EXPECT_EQ(animation.samplers.at(0).values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(animation.samplers.at(0).components, 3u);
}

TEST(GltfAnimation, CubicSplinesHaveThreeValuesAKey) {
    const std::vector<float> values(24, 0.5f);
    const assets::Model model = animated({0, 1}, values, "VEC4", "rotation", "CUBICSPLINE").model();
    EXPECT_EQ(model.animations.at(0).samplers.at(0).interpolation,
              assets::Interpolation::CubicSpline);
    EXPECT_EQ(model.animations.at(0).samplers.at(0).components, 4u);
}

TEST(GltfAnimation, WeightsHaveAFloatATarget) {
    const assets::Model model = animated({0, 1}, {0, 1, 1, 0}, "SCALAR", "weights", "STEP").model();
    EXPECT_EQ(model.animations.at(0).samplers.at(0).components, 2u);
    EXPECT_EQ(model.animations.at(0).samplers.at(0).interpolation, assets::Interpolation::Step);
}

TEST(GltfAnimation, WhatMakesNoSenseIsLeftOutWithAWarning) {
    const std::vector<std::pair<GltfBuilder, const char*>> cases = {
        {animated({1, 1}, {0, 0, 0, 0, 0, 0}, "VEC3", "scale", "LINEAR"),
         "/animations/0/samplers/0: key 1 is at 1 s and not after the one before"},
        {animated({0, 1}, {0, 0, 0}, "VEC3", "scale", "LINEAR"), "has 1 values for 2 keys"},
        {animated({0}, {0, 0, NAN}, "VEC3", "scale", "LINEAR"), "a value is not finite"},
        {animated({0}, {0, 0, 0}, "VEC3", "scale", "SMOOTH"), "unknown interpolation SMOOTH"},
        {animated({0}, {0, 0, 0}, "VEC3", "rotation", "LINEAR"), "does not fit rotation of node 0"},
        {animated({0}, {0, 0, 0}, "VEC3", "colour", "LINEAR"), "does not fit colour of node 0"},
        {animated({0}, {1, 1, 1}, "SCALAR", "weights", "LINEAR"),
         "does not fit weights of node 0"}};
    for (const auto& [builder, message] : cases) {
        assets::Model model;
        const std::string log = logOf([&, &bent = builder] { model = bent.model(); });
        EXPECT_NE(log.find(message), std::string::npos) << log;
        EXPECT_TRUE(model.animations.empty());
    }
}

TEST(GltfAnimation, KeysBeforeTheStartAndRotationsOfNoLengthAreTaken) {
    assets::Model model =
        animated({-1, 1}, {0, 0, 0, 2, 2, 2}, "VEC3", "translation", "LINEAR").model();
    EXPECT_EQ(assets::sampleVector(model.animations.at(0).samplers.at(0), 0.0), glm::vec3(1));
    const std::string log = logOf([&] {
        model = animated({0, 1}, {0, 0, 0, 0, 0, 0, 0, 1}, "VEC4", "rotation", "LINEAR").model();
    });
    EXPECT_NE(log.find("/animations/0/channels/0: has rotations of length 0"), std::string::npos);
    EXPECT_EQ(assets::sampleRotation(model.animations.at(0).samplers.at(0), 0.0),
              glm::quat(1, 0, 0, 0));
}

TEST(GltfAnimation, WhatIsMissingIsAnErrorWithItsPlace) {
    const auto bent = [](const char* pointer) {
        GltfBuilder builder = animated({0}, {0, 0, 0}, "VEC3", "scale", "LINEAR");
        const Json::json_pointer place(pointer);
        builder.json.at(place.parent_pointer()).erase(place.back());
        return builder.error();
    };
    EXPECT_EQ(bent("/animations/0/channels/0/sampler"),
              "test.gltf: /animations/0/channels/0: sampler is missing");
    EXPECT_EQ(bent("/animations/0/channels/0/target"),
              "test.gltf: /animations/0/channels/0: target is missing");
    EXPECT_EQ(bent("/animations/0/channels/0/target/path"),
              "test.gltf: /animations/0/channels/0/target: path is missing");
    EXPECT_EQ(bent("/animations/0/samplers/0/input"),
              "test.gltf: /animations/0/samplers/0: input is missing");
    EXPECT_EQ(bent("/animations/0/samplers/0/output"),
              "test.gltf: /animations/0/samplers/0: output is missing");
    GltfBuilder empty = animated({0}, {0, 0, 0}, "VEC3", "scale", "LINEAR");
    const int input = empty.json["animations"][0]["samplers"][0]["input"];
    empty.json["accessors"][static_cast<size_t>(input)]["count"] = 0;
    EXPECT_NE(empty.error().find("/accessors/"), std::string::npos) << empty.error();
}

TEST(GltfAnimation, WithoutChannelsItMovesNothing) {
    GltfBuilder builder = animated({0}, {0, 0, 0}, "VEC3", "scale", "LINEAR");
    for (const char* key : {"channels", "samplers"}) {
        builder.json["animations"][0].erase(key);
        builder.json["animations"][0]["channels"] = Json::array();
        assets::Model model;
        const std::string log = logOf([&] { model = builder.model(); });
        EXPECT_NE(log.find("/animations/0: moves nothing"), std::string::npos) << log;
        EXPECT_TRUE(model.animations.empty());
    }
}

}  // namespace
}  // namespace lampyris::test
