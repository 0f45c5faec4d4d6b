// What the user of `view` does, and what becomes of it.
#include <gtest/gtest.h>

#include "core/file.h"
#include "scene/builtin/shapes.h"
#include "scene/extract.h"
#include "scene/motion.h"
#include "scene/spawn.h"
#include "scene/systems/patrol.h"
#include "unit/core/scratch_folder.h"
#include "view/edits.h"
#include "view/last_drawn.h"
#include "view/screenshot.h"
#include "view/walk_camera.h"

namespace lampyris::sandbox::view {
namespace {

photon_gi::Settings withPaths(uint32_t paths) {
    photon_gi::Settings settings;
    settings.photonPaths = paths;
    return settings;
}

TEST(LastDrawn, LeadsBackToWhatWasAskedForAndThenToWhatWasGiven) {
    LastDrawn last;
    EXPECT_EQ(last.asked(), std::nullopt);
    EXPECT_EQ(last.insteadOf(withPaths(9), withPaths(9)), std::nullopt) << "none ever drew";
    last.drew(withPaths(1000), withPaths(100));  // by a budget
    EXPECT_EQ(last.insteadOf(withPaths(9000), withPaths(900)), withPaths(1000));
    // The budget was switched off: only what it gave has drawn.
    EXPECT_EQ(last.insteadOf(withPaths(1000), withPaths(1000)), withPaths(100));
    EXPECT_EQ(last.asked(), withPaths(100)) << "and is what will be kept";
    EXPECT_EQ(last.insteadOf(withPaths(100), withPaths(100)), std::nullopt) << "no way left";
    EXPECT_EQ(last.insteadOf(withPaths(100), withPaths(10)), std::nullopt);
}

TEST(LastDrawn, GoesNowhereFromSettingsThatDrew) {
    LastDrawn last;
    last.drew(withPaths(1000), withPaths(1000));
    EXPECT_EQ(last.insteadOf(withPaths(1000), withPaths(1000)), std::nullopt);
}

TEST(Screenshot, TakesANameThatNobodyHas) {
    const core::ScratchFolder folder;
    const std::filesystem::path wanted(folder / "a_000007.png");
    EXPECT_EQ(freePath(wanted), wanted);
    ASSERT_TRUE(core::writeFile(wanted, std::string("first")).ok());
    EXPECT_EQ(freePath(wanted), folder / "a_000007_2.png");
    ASSERT_TRUE(core::writeFile(folder / "a_000007_2.png", std::string("second")).ok());
    EXPECT_EQ(freePath(wanted), folder / "a_000007_3.png");
}

TEST(Edits, AreUndoneByAnAnimationOfTheSamePartAlone) {
    ecs::World world = scene::newWorld();
    const ecs::Entity walker = scene::spawn(world, "walker");
    world.add(walker, scene::Patrol{{{0, 0, 0}, {0, 0, 9}}, 1.0f, 0.0, true});
    world.resource<scene::Motion>().systems.add("patrol", scene::patrol);
    scene::advanceTo(world, 1.0, 0);
    const Movable before = movableOf(world, walker);
    EXPECT_FALSE(undone(before, before, before));
    world.edit<scene::Transform>(walker).scale = glm::vec3(2.0f);
    const Movable scaled = movableOf(world, walker);
    scene::advanceTo(world, 2.0, 0);
    EXPECT_FALSE(undone(before, scaled, movableOf(world, walker))) << "it walks on, and is larger";
    const Movable walked = movableOf(world, walker);
    world.edit<scene::Transform>(walker).translation.x = 3.0f;
    const Movable moved = movableOf(world, walker);
    EXPECT_FALSE(undone(walked, moved, moved));
    scene::advanceTo(world, 3.0, 0);
    EXPECT_TRUE(undone(walked, moved, movableOf(world, walker)));
    EXPECT_EQ(nameOf(world, walker), "'walker'");
    EXPECT_EQ(nameOf(world, world.create()), "this");
}

TEST(Edits, OfALightMayBeUndoneToo) {
    Movable before;
    Movable after;
    after.light.powerWatts = glm::vec3(5.0f);
    EXPECT_TRUE(undone(before, after, before));
    after = before;
    after.light.radiusMetres = 0.5f;
    EXPECT_TRUE(undone(before, after, before));
    EXPECT_FALSE(undone(before, after, after));
}

/// A floor, and over it a slab whose top is so high; it begins two metres ahead of the middle.
scene::SceneSnapshot floorAndSlab(float topMetres) {
    ecs::World world = scene::newWorld();
    const auto add = [&](const glm::vec3& middle, const glm::vec3& half) {
        assets::Mesh mesh;
        scene::builtin::addBox(mesh, glm::translate(glm::mat4(1.0f), middle), half);
        assets::updateBounds(mesh);
        scene::spawnMesh(world, std::move(mesh), {});
    };
    add({0.0f, -0.1f, 0.0f}, {10.0f, 0.1f, 10.0f});
    add({0.0f, topMetres - 0.02f, -4.0f}, {10.0f, 0.02f, 2.0f});
    scene::advanceTo(world, 0.0, 0);
    return scene::extract(world, {}, 0);
}

glm::vec3 afterWalkingAhead(const scene::SceneSnapshot& snapshot) {
    WalkCamera walker;
    window::Input input;
    input.held['W'] = true;
    glm::mat4 camera =
        glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, WalkCamera::kEyeMetres, 0.0f));
    for (int i = 0; i < 90; ++i) camera = walker.walk(camera, input, snapshot, 1.0f / 60.0f);
    return camera[3];
}

TEST(WalkCamera, ClimbsStepsAndNoTables) {
    const glm::vec3 onStep = afterWalkingAhead(floorAndSlab(0.3f));
    EXPECT_NEAR(onStep.y, WalkCamera::kEyeMetres + 0.3f, 1e-3f);
    EXPECT_LT(onStep.z, -3.0f);
    const glm::vec3 atTable = afterWalkingAhead(floorAndSlab(0.75f));
    EXPECT_NEAR(atTable.y, WalkCamera::kEyeMetres, 1e-3f);
    EXPECT_GT(atTable.z, -2.0f - 1e-3f);
    EXPECT_LT(atTable.z, -1.5f) << "it stands before it";
}

}  // namespace
}  // namespace lampyris::sandbox::view
