// What moves comes back from a saved scene and moves on.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/file.h"
#include "scene/extract.h"
#include "scene/load.h"
#include "scene/motion.h"
#include "scene/save.h"
#include "support/gltf_builder.h"

namespace lampyris::scene {
namespace {

/// A triangle with a morph target on one joint, which goes from x = 0 to 4 in two seconds while
/// the target's weight goes from 0 to 1.
std::string writtenFile() {
    test::GltfBuilder builder = test::GltfBuilder::triangle();
    builder.addAttribute("JOINTS_0", builder.addAccessor<uint8_t>(std::vector<uint8_t>(12, 0),
                                                                  "VEC4", test::kUbyte));
    builder.addAttribute("WEIGHTS_0",
                         builder.addFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4"));
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    const int joint = builder.push("nodes", {{"name", "joint"}});
    builder.json["scenes"][0]["nodes"].push_back(joint);
    builder.push("skins", {{"joints", {joint}}});
    builder.json["nodes"][0]["skin"] = 0;
    const int times = builder.addFloats({0, 2}, "SCALAR");
    const int places = builder.addFloats({0, 0, 0, 4, 0, 0}, "VEC3");
    const int weights = builder.addFloats({0, 1}, "SCALAR");
    builder.push(
        "animations",
        {{"name", "go"},
         {"samplers",
          {{{"input", times}, {"output", places}}, {{"input", times}, {"output", weights}}}},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", joint}, {"path", "translation"}}}},
           {{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
    std::string path = std::string(LAMPYRIS_BINARY_DIR) + "/save_motion_" +
                       testing::UnitTest::GetInstance()->current_test_info()->name() +
                       ".gltf";  // tests may run side by side
    const std::vector<uint8_t> bytes = builder.gltf();
    EXPECT_TRUE(core::writeFile(path, std::string(bytes.begin(), bytes.end())).ok());
    return path;
}

TEST(SaveMotion, ASavedSceneMovesOn) {
    auto world = loadScene(writtenFile());
    ASSERT_TRUE(world.ok()) << world.error().message;
    for (const auto& [entity, player] : world->view<AnimationPlayer>()) {
        auto& plays = world->edit<AnimationPlayer>(entity);
        plays.speed = 0.5;
        plays.startSeconds = -1.0;
        plays.targets.push_back({});
    }
    world->add(world->create(), Patrol{{{1, 2, 3}, {4, 5, 6}}, 0.5f, 2.0, false});
    world->add(world->create(), MeshPart{});
    const auto text = saveScene(*world);
    ASSERT_TRUE(text.ok()) << text.error().message;
    auto loaded = loadSavedScene(*text);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_EQ(saveScene(*loaded).value(), *text);
    EXPECT_EQ(loaded->count<MeshPart>(), 1u);
    for (const auto& [entity, patrol] : loaded->view<Patrol>()) {
        EXPECT_EQ(patrol.waypoints.at(1), glm::vec3(4, 5, 6));
        EXPECT_FALSE(patrol.closed);
    }
    advanceTo(*loaded, 1.0, 0);
    const SceneSnapshot snapshot = extract(*loaded, {}, 0);
    ASSERT_EQ(snapshot.instances.size(), 1u);
    ASSERT_NE(snapshot.instances[0].pose, nullptr);
    EXPECT_EQ(snapshot.instances[0].pose->morphWeights, std::vector<float>{0.5f});
    EXPECT_EQ(snapshot.instances[0].objectToWorld[3].x, 2.0f);
    EXPECT_NEAR(snapshot.boundsWorld.lower.x, 2.0f, 1e-5f);
    EXPECT_NEAR(snapshot.boundsWorld.upper.x, 3.5f, 1e-5f);
}

TEST(SaveMotion, RefusesClipsThatTheSourceHasNot) {
    auto world = loadScene(writtenFile());
    ASSERT_TRUE(world.ok());
    for (const auto& [entity, player] : world->view<AnimationPlayer>())
        world->edit<AnimationPlayer>(entity).clip = world->resource<Library>().addClip({});
    const auto text = saveScene(*world);
    ASSERT_FALSE(text.ok());
    EXPECT_NE(text.error().message.find("clip 1 is not one of the 1"), std::string::npos);
}

TEST(SaveMotion, RefusesBrokenComponents) {
    auto world = loadScene(writtenFile());
    ASSERT_TRUE(world.ok());
    const auto whole = nlohmann::json::parse(saveScene(*world).value());
    const auto broken = [&](const char* component, const char* field, const nlohmann::json& value) {
        nlohmann::json root = whole;
        for (auto& entity : root["world"]["entities"]) {
            if (!entity["components"].contains(component)) continue;
            if (*field == '\0')
                entity["components"][component] = value;
            else
                entity["components"][component][field] = value;
        }
        const auto loaded = loadSavedScene(root.dump());
        return loaded.ok() ? std::string() : loaded.error().message;
    };
    EXPECT_NE(broken("skin", "joints", {99}), "");
    EXPECT_NE(broken("skin", "joints", {0, 0}), "");
    EXPECT_NE(broken("skin", "inverse_bind_matrices", "none"), "");
    EXPECT_NE(broken("morph_weights", "", {"heavy"}), "");
    EXPECT_NE(broken("morph_weights", "", {1e99}), "");
    EXPECT_NE(broken("animation_player", "clip", 1), "");
    EXPECT_NE(broken("animation_player", "clip", "go"), "");
    EXPECT_NE(broken("animation_player", "speed", "fast"), "");
    EXPECT_NE(broken("animation_player", "targets", {-1}), "");
    EXPECT_EQ(broken("animation_player", "loops", true), "");
}

}  // namespace
}  // namespace lampyris::scene
