#include "scene/instantiate.h"

#include <gtest/gtest.h>

#include "scene/extract.h"
#include "scene/motion.h"
#include "scene/place_deformed.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {
namespace {

assets::Mesh triangle(const std::string& name) {
    assets::Mesh mesh;
    mesh.name = name;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    assets::updateBounds(mesh);
    return mesh;
}

assets::ModelNode node(const std::string& name, std::vector<uint32_t> children = {}) {
    assets::ModelNode result;
    result.name = name;
    result.children = std::move(children);
    return result;
}

/// a { b { two primitives }, c { one primitive, camera } }, d { point light }; e is in no scene.
assets::Model sample() {
    assets::Model model;
    model.meshes = {triangle("m0"), triangle("m1"), triangle("m2"), triangle("unused")};
    model.images.resize(2);
    model.materials.resize(2);
    model.materials[1].baseColourTexture.image = 1;
    model.cameras = {{"wide", 1.0f, 0.5f}};
    model.lights.resize(1);
    model.lights[0].name = "lamp";
    model.lights[0].colour = {1.0f, 0.5f, 0.0f};
    model.lights[0].intensity = 10.0f;
    model.nodes = {node("a", {1, 2}), node("b"), node("c"), node(""), node("e")};
    model.nodes[0].translation = {0, 1, 0};
    model.nodes[1].primitives = {{0, 0}, {1, 1}};
    model.nodes[1].translation = {2, 0, 0};
    model.nodes[1].parent = model.nodes[2].parent = 0;
    model.nodes[2].primitives = {{2, 1}};
    model.nodes[2].camera = 0;
    model.nodes[3].light = 0;
    model.nodes[4].primitives = {{3, 0}};
    model.roots = {0, 3};
    return model;
}

ecs::Entity named(const ecs::World& world, const std::string& name) {
    for (const auto& [entity, value] : world.view<Name>()) {
        if (value.value == name) return entity;
    }
    ADD_FAILURE() << "no entity " << name;
    return {};
}

class Instantiate : public testing::Test {
 protected:
    Instantiate() { world.setResource(Library{}); }
    void load(const assets::Model& model) {
        testing::internal::CaptureStderr();
        instantiate(world, model, "file.glb");
        warnings = testing::internal::GetCapturedStderr();
        updateWorldTransforms(world);
    }
    ecs::World world;
    std::string warnings;
};

TEST_F(Instantiate, NodesBecomeAHierarchyWithTheirMeshes) {
    load(sample());
    const ecs::Entity a = named(world, "a");
    const ecs::Entity b = named(world, "b");
    const ecs::Entity c = named(world, "c");
    EXPECT_EQ(ecs::parentOf(world, b), a);
    EXPECT_EQ(ecs::parentOf(world, c), a);
    EXPECT_FALSE(world.has<MeshInstance>(b));
    ASSERT_EQ(ecs::childrenOf(world, b).size(), 2u);
    const ecs::Entity part = ecs::childrenOf(world, b)[1];
    EXPECT_EQ(glm::vec3(world.get<WorldTransform>(part).matrix[3]), glm::vec3(2, 1, 0));
    EXPECT_TRUE(world.has<MeshInstance>(c));
    EXPECT_EQ(wholeOf(world, part), b) << "a piece in another material is no thing of its own";
    EXPECT_EQ(wholeOf(world, b), b);
    EXPECT_EQ(wholeOf(world, c), c);
    EXPECT_EQ(world.get<Camera>(c).verticalFovRadians, 1.0f);
    EXPECT_EQ(world.count<MeshInstance>(), 3u);
    EXPECT_EQ(world.resource<Library>().meshes().size(), 3u);
    const SceneSnapshot snapshot = extract(world, {}, 0);
    ASSERT_EQ(snapshot.cameras.size(), 1u);
    EXPECT_EQ(snapshot.cameras[0].name, "c");
}

TEST_F(Instantiate, TextureNumbersFollowTheLibrary) {
    world.resource<Library>().addImage({});
    load(sample());
    const MeshInstance drawn = world.get<MeshInstance>(named(world, "c"));
    EXPECT_EQ(
        world.resource<Library>().materials()[drawn.material.value].value->baseColourTexture.image,
        2);
}

TEST_F(Instantiate, APointLightIsASphereOfItsPower) {
    load(sample());
    const auto& light = world.get<SphereLight>(named(world, "lamp"));
    EXPECT_NEAR(light.powerWatts.x, 40.0f * math::kPi, 1e-3f);
    EXPECT_NEAR(light.powerWatts.y, 20.0f * math::kPi, 1e-3f);
    EXPECT_EQ(light.powerWatts.z, 0.0f);
    EXPECT_EQ(light.radiusMetres, 0.05f);
    EXPECT_EQ(light.cosOuterCone, -1.0f);
}

TEST_F(Instantiate, TheNodesRadiusComesBeforeTheLights) {
    assets::Model model = sample();
    model.lights[0].radiusMetres = 0.2f;
    load(model);
    EXPECT_EQ(world.get<SphereLight>(named(world, "lamp")).radiusMetres, 0.2f);
    model.nodes[3].lightRadiusMetres = 0.3f;
    model.nodes[3].name = "second";
    load(model);
    EXPECT_EQ(world.get<SphereLight>(named(world, "second")).radiusMetres, 0.3f);
}

TEST_F(Instantiate, ASpotKeepsItsConesAsCosines) {
    assets::Model model = sample();
    model.lights[0].type = assets::LightType::Spot;
    model.lights[0].innerConeRadians = 0.3f;
    model.lights[0].outerConeRadians = 0.6f;
    load(model);
    const auto& light = world.get<SphereLight>(named(world, "lamp"));
    EXPECT_NEAR(light.cosOuterCone, std::cos(0.6f), 1e-6f);
    EXPECT_NEAR(light.cosInnerCone, std::cos(0.3f), 1e-6f);
}

TEST_F(Instantiate, DirectionalLightsAreLeftOutWithOneWarning) {
    assets::Model model = sample();
    model.lights[0].type = assets::LightType::Directional;
    model.nodes[4].light = 0;
    model.roots.push_back(4);
    load(model);
    EXPECT_EQ(world.count<SphereLight>(), 0u);
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 1);
    EXPECT_NE(warnings.find("file.glb"), std::string::npos);
    EXPECT_NE(warnings.find("2 left out"), std::string::npos);
}

/// sample() with two clips, and a skin on b's two meshes: joints c, and e outside the scene.
assets::Model moving() {
    assets::Model model = sample();
    for (const uint32_t mesh : {0u, 1u}) {
        model.meshes[mesh].morphTargets.resize(2);
        model.meshes[mesh].morphWeights = {0.5f, 0.25f};
    }
    model.meshes[0].joints.assign(3, glm::uvec4(0));
    model.meshes[0].weights.assign(3, glm::vec4(1, 0, 0, 0));
    model.skins = {{"skin", {2, 4}, std::vector<glm::mat4>(2, glm::mat4(1.0f))}};
    model.nodes[1].skin = 0;
    using assets::AnimatedProperty;
    assets::Animation clip{"first",
                           {{assets::Interpolation::Linear, {1, 2}, 3, {9, 9, 9, 1, 1, 1}},
                            {assets::Interpolation::Linear, {1}, 2, {3, 4}}},
                           {{0, 2, AnimatedProperty::Translation},
                            {0, 4, AnimatedProperty::Translation},
                            {1, 1, AnimatedProperty::Weights}},
                           2.0f};
    model.animations = {clip, clip};
    model.animations[1].name = "second";
    return model;
}

TEST_F(Instantiate, AnimationsAreClipsAndTheFirstPlays) {
    load(moving());
    const auto& clips = world.resource<Library>().clips();
    ASSERT_EQ(clips.size(), 2u);
    EXPECT_EQ(clips[1]->name, "second");
    const auto& player = world.get<AnimationPlayer>(named(world, "file"));
    EXPECT_EQ(player.clip.value, 0u);
    EXPECT_FALSE(player.loops);
    EXPECT_EQ(player.targets[2], named(world, "c"));
    EXPECT_FALSE(player.targets[4].valid());
    advanceTo(world, 1.0, 0);
    EXPECT_EQ(world.get<Transform>(named(world, "c")).translation, glm::vec3(9));
    // A node's weights are those of all its primitives.
    for (const ecs::Entity part : ecs::childrenOf(world, named(world, "b")))
        EXPECT_EQ(world.get<MorphWeights>(part).values, (std::vector<float>{3, 4}));
}

TEST_F(Instantiate, AFileThatStandsStillHasNoPlayer) {
    load(sample());
    EXPECT_EQ(world.count<AnimationPlayer>(), 0u);
    EXPECT_EQ(world.count<MorphWeights>(), 0u);
    EXPECT_EQ(world.count<Skin>(), 0u);
}

TEST_F(Instantiate, SkinsFollowTheSceneOnly) {
    load(moving());
    const auto parts = ecs::childrenOf(world, named(world, "b"));
    const auto& skin = world.get<Skin>(parts[0]);
    EXPECT_EQ(skin.joints, (std::vector<ecs::Entity>{named(world, "c"), {}}));
    EXPECT_FALSE(world.has<Skin>(parts[1]));
    EXPECT_NE(warnings.find("file.glb: 1 joints are not in the scene"), std::string::npos);
    EXPECT_NE(warnings.find("file.glb: 1 meshes have a skin but no joints"), std::string::npos);
}

TEST_F(Instantiate, TheNodesWeightsComeBeforeTheMeshs) {
    assets::Model model = moving();
    load(model);
    const ecs::Entity part = ecs::childrenOf(world, named(world, "b"))[0];
    EXPECT_EQ(world.get<MorphWeights>(part).values, (std::vector<float>{0.5f, 0.25f}));
    model.nodes[1].morphWeights = {1, 2};
    model.nodes[1].name = "heavy";
    load(model);
    const ecs::Entity heavy = ecs::childrenOf(world, named(world, "heavy"))[0];
    EXPECT_EQ(world.get<MorphWeights>(heavy).values, (std::vector<float>{1, 2}));
}

TEST_F(Instantiate, DeepHierarchiesNeedNoStack) {
    assets::Model model;
    constexpr uint32_t kDepth = 20000;
    for (uint32_t i = 0; i < kDepth; ++i) {
        model.nodes.push_back(
            node("", i + 1 < kDepth ? std::vector<uint32_t>{i + 1} : std::vector<uint32_t>{}));
        model.nodes.back().translation.x = 1.0f;
        model.nodes.back().parent = static_cast<int32_t>(i) - 1;
    }
    model.nodes.back().name = "last";
    model.roots = {0};
    load(model);
    EXPECT_EQ(world.get<WorldTransform>(named(world, "last")).matrix[3].x, 20000.0f);
}

}  // namespace
}  // namespace lampyris::scene
