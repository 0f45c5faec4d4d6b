// Saving, loading, and both by name or path.
#include "scene/save.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/file.h"
#include "scene/extract.h"
#include "scene/load.h"
#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {
namespace {

TEST(SaveScene, ALoadedTextIsTheSameSceneAgain) {
    auto world = loadScene("two_rooms");
    ASSERT_TRUE(world.ok());
    const ecs::Entity lamp = spawnLight(*world, "second", {1, 2, 3},
                                        {.radiusMetres = 0.25f,
                                         .powerWatts = {1, 2, 3},
                                         .cosOuterCone = 0.5f,
                                         .cosInnerCone = 0.75f});
    const ecs::Entity parent =
        spawn(*world, "carrier", {{4, 5, 6}, glm::angleAxis(0.3f, glm::vec3(0, 1, 0)), {1, 2, 1}});
    ASSERT_TRUE(ecs::setParent(*world, lamp, parent).ok());
    updateWorldTransforms(*world);
    const auto text = saveScene(*world);
    ASSERT_TRUE(text.ok());

    const auto loaded = loadSavedScene(*text);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_EQ(saveScene(*loaded).value(), *text);
    const SceneSnapshot a = extract(*world, {}, 0);
    const SceneSnapshot b = extract(*loaded, {}, 0);
    ASSERT_EQ(a.instances.size(), b.instances.size());
    EXPECT_EQ(a.boundsWorld.lower, b.boundsWorld.lower);
    ASSERT_EQ(b.lights.size(), 2u);
    // Entities are saved parents first, so the order may differ; the second light is the new one.
    EXPECT_EQ(b.lights[1].powerWatts, glm::vec3(1, 2, 3));
    EXPECT_EQ(b.lights[1].cosInnerCone, 0.75f);
    EXPECT_EQ(b.lights[1].positionWorld, a.lights[1].positionWorld);
    EXPECT_EQ(b.cameras[0].name, "camera");
    EXPECT_EQ(b.cameras[0].cameraToWorld, a.cameras[0].cameraToWorld);
}

TEST(SaveScene, MeshesMadeAtRunTimeAreRefused) {
    auto world = loadScene("cornell");
    ASSERT_TRUE(world.ok());
    spawnMesh(*world, {}, {});
    const auto text = saveScene(*world);
    ASSERT_FALSE(text.ok());
    EXPECT_NE(text.error().message.find("mesh 3"), std::string::npos) << text.error().message;
}

/// The text of cornell with one component of its camera replaced.
std::string withCamera(const char* component, const nlohmann::json& value) {
    auto world = loadScene("cornell");
    auto root = nlohmann::json::parse(saveScene(*world).value());
    for (auto& entity : root["world"]["entities"]) {
        if (entity["components"].contains("camera")) entity["components"][component] = value;
    }
    return root.dump();
}

TEST(LoadSavedScene, RefusesWhatCannotBeDrawn) {
    const std::vector<std::string> texts{
        "",
        "[]",
        "{}",
        R"({"format":"lampyris scene","source":"cornell"})",
        R"({"format":"lampyris scene","source":"nowhere","world":{}})",
        withCamera("camera", {{"near_metres", 0}}),
        withCamera("camera", {{"vertical_fov_radians", 4}}),
        withCamera("camera", {{"vertical_fov_radians", "wide"}}),
        withCamera("transform", {{"translation", {1, 2}}}),
        withCamera("transform", {{"translation", {1, 2, 1e99}}}),
        withCamera("transform", {{"rotation", {0, 0, 0, 0}}}),
        withCamera("mesh", {{"mesh", 3}}),
        withCamera("mesh", {{"mesh", -1}}),
        withCamera("mesh", {{"mesh", 0}, {"material", 4}}),
        withCamera("sphere_light", {{"radius_metres", 0}}),
        withCamera("sphere_light", {{"power_watts", {-1, 0, 0}}})};
    for (const std::string& text : texts) {
        const auto world = loadSavedScene(text);
        EXPECT_FALSE(world.ok()) << text;
    }
    EXPECT_TRUE(loadSavedScene(withCamera("mesh", {{"mesh", 2}, {"material", 3}})).ok());
}

TEST(LoadScene, ErrorsNameTheScene) {
    for (const char* name : {"nowhere", "nowhere.glb", "/nowhere/at/all.GLTF"}) {
        const auto world = loadScene(name);
        ASSERT_FALSE(world.ok());
        EXPECT_NE(world.error().message.find(name), std::string::npos) << world.error().message;
    }
}

TEST(LoadScene, AFileWithoutMeshesIsAnError) {
    const std::string path = std::string(LAMPYRIS_BINARY_DIR) + "/no_meshes.gltf";
    ASSERT_TRUE(core::writeFile(path, R"({"asset":{"version":"2.0"},"scene":0,)"
                                      R"("scenes":[{"nodes":[0]}],"nodes":[{"name":"alone"}]})")
                    .ok());
    const auto world = loadScene(path);
    ASSERT_FALSE(world.ok());
    EXPECT_NE(world.error().message.find(path), std::string::npos) << world.error().message;
}

}  // namespace
}  // namespace lampyris::scene
