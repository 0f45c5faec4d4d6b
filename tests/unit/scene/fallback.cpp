#include "scene/fallback.h"

#include <gtest/gtest.h>

#include "scene/library.h"
#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {
namespace {

/// Whether all corners of the bounds project into a square picture, and how much of it they span.
void expectFramed(const math::Bounds& bounds) {
    const Framing framing = frame(bounds);
    const glm::dmat4 toCamera = glm::inverse(glm::dmat4(framing.transform.matrix()));
    const double slope = std::tan(0.5 * framing.camera.verticalFovRadians);
    double widest = 0.0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner((i & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                                (i & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                (i & 4) != 0 ? bounds.upper.z : bounds.lower.z, 1.0);
        const glm::dvec3 p(toCamera * corner);
        ASSERT_LT(p.z, -static_cast<double>(framing.camera.nearMetres)) << i;
        ASSERT_LT(std::abs(p.x), -p.z * slope) << i;
        ASSERT_LT(std::abs(p.y), -p.z * slope) << i;
        widest = std::max({widest, std::abs(p.x / (p.z * slope)), std::abs(p.y / (p.z * slope))});
    }
    EXPECT_GT(widest, 0.5);
}

TEST(Framing, SeesEveryCornerOfBoundsOfAnyShapeAndSize) {
    expectFramed({glm::vec3(-1.0f), glm::vec3(1.0f)});
    expectFramed({{10, 20, 30}, {11, 25, 30.5f}});
    expectFramed({{-50, 0, -1}, {50, 0, 1}});
    expectFramed({{0, 0, 0}, {0, 300, 0}});
    expectFramed({glm::vec3(-1e-9f), glm::vec3(1e-9f)});
    expectFramed({glm::vec3(-1e15f), glm::vec3(1e15f)});
    expectFramed({{-556, 0, -559}, {0, 549, 0}});
}

TEST(Framing, LooksFromTheFrontRightAbove) {
    const Framing framing = frame({glm::vec3(-1.0f), glm::vec3(1.0f)});
    const glm::vec3 direction = glm::normalize(framing.transform.translation);
    EXPECT_NEAR(glm::distance(direction, glm::normalize(glm::vec3(1.0f, 0.7f, 1.0f))), 0.0f, 1e-6f);
    EXPECT_NEAR(framing.camera.verticalFovRadians, glm::radians(40.0f), 1e-6f);
    const glm::vec3 forward = framing.transform.rotation * glm::vec3(0, 0, -1);
    EXPECT_NEAR(glm::distance(forward, -direction), 0.0f, 1e-6f);
}

TEST(Framing, StaysFiniteForNothingAPointAndTheWholeRange) {
    const math::Bounds point{glm::vec3(3.0f), glm::vec3(3.0f)};
    const math::Bounds everything{glm::vec3(-3e38f), glm::vec3(3e38f)};
    for (const math::Bounds& bounds : {math::Bounds{}, point, everything}) {
        const Framing framing = frame(bounds);
        EXPECT_TRUE(
            glm::all(glm::lessThan(glm::abs(framing.transform.translation), glm::vec3(1e38f))));
        EXPECT_GT(framing.camera.nearMetres, 0.0f);
        const LightAbove above = lightAbove(bounds);
        EXPECT_TRUE(std::isfinite(above.light.powerWatts.x));
        EXPECT_GT(above.light.powerWatts.x, 0.0f);
        EXPECT_GT(above.light.radiusMetres, 0.0f);
    }
}

TEST(LightAbove, GivesMidGreyInTheCentreAndStaysOutside) {
    for (const float size : {1e-6f, 1.0f, 250.0f, 1e9f}) {
        const math::Bounds bounds{glm::vec3(-size), glm::vec3(size)};
        const LightAbove above = lightAbove(bounds);
        EXPECT_GT(above.position.y - above.light.radiusMetres, size);
        const double d = glm::length(glm::dvec3(above.position));
        const double irradiance = above.light.powerWatts.x / (4.0 * math::kPi * d * d);
        // Albedo ½, half of the full cosine.
        EXPECT_NEAR(0.5 * irradiance * 0.5 / math::kPi, 0.18, 1e-4);
    }
}

class Missing : public testing::Test {
 protected:
    Missing() {
        world.setResource(Library{});
        assets::Mesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.normals.assign(3, {0, 0, 1});
        mesh.indices = {0, 1, 2};
        assets::updateBounds(mesh);
        drawn = spawnMesh(world, std::move(mesh), {});
        updateWorldTransforms(world);
    }
    void addMissing() {
        testing::internal::CaptureStderr();
        addMissingCamera(world, "file.glb");
        addMissingLight(world, "file.glb");
        warnings = testing::internal::GetCapturedStderr();
    }
    ecs::World world;
    ecs::Entity drawn;
    std::string warnings;
};

TEST_F(Missing, CameraAndLightAreAddedWithOneLineEach) {
    addMissing();
    EXPECT_EQ(world.count<Camera>(), 1u);
    EXPECT_EQ(world.count<SphereLight>(), 1u);
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 2);
    EXPECT_NE(warnings.find("file.glb: no camera"), std::string::npos);
    EXPECT_NE(warnings.find("file.glb: no light"), std::string::npos);
}

TEST_F(Missing, NothingIsAddedToWhatIsThere) {
    spawnCamera(world, "mine", {0, 0, 5}, {});
    spawnLight(world, "mine", {0, 5, 0}, {.radiusMetres = 0.1f, .powerWatts = glm::vec3(1.0f)});
    addMissing();
    EXPECT_EQ(world.count<Camera>(), 1u);
    EXPECT_EQ(world.count<SphereLight>(), 1u);
    EXPECT_EQ(warnings, "");
}

TEST_F(Missing, SomethingEmissiveThatIsDrawnIsLightEnough) {
    assets::Material glow;
    glow.emissiveRadiance = {0.0f, 2.0f, 0.0f};
    const MaterialId id = world.resource<Library>().addMaterial(glow);
    addMissing();
    EXPECT_EQ(world.count<SphereLight>(), 1u);  // nothing shows the material yet
    for (const ecs::Entity e : world.entities()) world.remove<SphereLight>(e);
    world.edit<MeshInstance>(drawn).material = id;
    addMissing();
    EXPECT_EQ(world.count<SphereLight>(), 0u);
}

TEST_F(Missing, LightsWithoutPowerStayDarkAndAreToldOf) {
    spawnCamera(world, "mine", {0, 0, 5}, {});
    spawnLight(world, "off", {0, 5, 0}, {});
    addMissing();
    EXPECT_EQ(world.count<SphereLight>(), 1u);
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 1);
    EXPECT_NE(warnings.find("file.glb: its lights have no power"), std::string::npos);
}

}  // namespace
}  // namespace lampyris::scene
