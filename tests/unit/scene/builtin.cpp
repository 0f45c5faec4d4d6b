// The built-in scenes against the numbers that users are promised, and their bytes.
#include "scene/builtin/builtin.h"

#include <gtest/gtest.h>

#include "scene/extract.h"
#include "unit/scene/mesh_facts.h"

namespace lampyris::scene {
namespace {

using test::EdgeCount;

SceneSnapshot snapshotOf(std::string_view name) {
    auto world = builtinScene(name);
    EXPECT_TRUE(world.ok());
    return extract(*world, {}, 0);
}

const assets::Mesh& meshNamed(const SceneSnapshot& scene, std::string_view name) {
    for (const auto& mesh : scene.meshes) {
        if (mesh.value->name == name) return *mesh.value;
    }
    ADD_FAILURE() << "no mesh " << name;
    return *scene.meshes.front().value;
}

size_t triangleCount(const SceneSnapshot& scene) {
    size_t count = 0;
    for (const SnapshotInstance& i : scene.instances) {
        count += scene.meshes[i.mesh].value->triangleCount();
    }
    return count;
}

uint64_t hashOf(const SceneSnapshot& scene) {
    uint64_t hash = 0;
    for (const auto& mesh : scene.meshes) hash = hash * 31 + test::hashOf(*mesh.value);
    return hash;
}

size_t unpairedEdges(const SceneSnapshot& scene, std::initializer_list<const char*> meshes) {
    EdgeCount edges;
    for (const char* name : meshes) edges.add(meshNamed(scene, name));
    return edges.unpaired();
}

TEST(Builtin, UnknownNameIsAnErrorThatListsTheKnown) {
    const auto world = builtinScene("cornel");
    ASSERT_FALSE(world.ok());
    EXPECT_NE(world.error().message.find("\"cornel\""), std::string::npos);
    for (const std::string_view name : builtinSceneNames()) {
        EXPECT_NE(world.error().message.find(name), std::string::npos);
    }
}

TEST(Builtin, SceneBytesNeverChange) {
    EXPECT_EQ(hashOf(snapshotOf("cornell")), 9742829606997410893u);
    EXPECT_EQ(hashOf(snapshotOf("two_rooms")), 12662581490350118999u);
    EXPECT_EQ(hashOf(snapshotOf("conference")), 12495686761578266017u);
}

TEST(Builtin, SmallScenesHaveNoFlawedTriangles) {
    for (const char* name : {"cornell", "two_rooms", "conference"}) {
        for (const auto& mesh : snapshotOf(name).meshes) {
            EXPECT_EQ(test::flaws(*mesh.value), 0u) << name << ": " << mesh.value->name;
        }
    }
}

TEST(Cornell, WallsLightAndCameraAreAsPromised) {
    const SceneSnapshot scene = snapshotOf("cornell");
    EXPECT_EQ(triangleCount(scene), 34u);
    EXPECT_EQ(scene.boundsWorld.lower, glm::vec3(-5, 0, -5));
    EXPECT_EQ(scene.boundsWorld.upper, glm::vec3(5, 10, 5));
    // Three walls, a box of 3 × 6 × 3 and one of 3 × 3 × 3.
    EXPECT_NEAR(test::area(meshNamed(scene, "grey")), 300.0 + 90.0 + 54.0, 1e-4);
    EXPECT_NEAR(test::area(meshNamed(scene, "left wall")), 100.0, 1e-6);
    for (const SnapshotInstance& i : scene.instances) {
        EXPECT_EQ(scene.materials[i.material].value->specularFactor, 0.0f);
        EXPECT_EQ(scene.materials[i.material].value->metallic, 0.0f);
    }
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].positionWorld, glm::vec3(0.0f, 8.5f, 0.0f));
    EXPECT_EQ(scene.lights[0].radiusMetres, 0.4f);
    EXPECT_EQ(scene.lights[0].powerWatts, glm::vec3(1000.0f));
    EXPECT_EQ(scene.lights[0].cosOuterCone, -1.0f);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].cameraToWorld,
              glm::translate(glm::mat4(1.0f), glm::vec3(0.13f, 5.07f, 19.0f)));
    EXPECT_NEAR(scene.cameras[0].verticalFovRadians, glm::radians(40.0f), 1e-6f);
}

TEST(Cornell, WallsHaveTheirColoursAndFaceInwards) {
    const SceneSnapshot scene = snapshotOf("cornell");
    const auto albedoOf = [&](std::string_view mesh) {
        for (const SnapshotInstance& i : scene.instances) {
            if (scene.meshes[i.mesh].value->name == mesh) {
                return glm::vec3(scene.materials[i.material].value->baseColour);
            }
        }
        return glm::vec3(-1.0f);
    };
    EXPECT_EQ(albedoOf("grey"), glm::vec3(0.73f));
    EXPECT_EQ(albedoOf("left wall"), glm::vec3(0.63f, 0.065f, 0.05f));
    EXPECT_EQ(albedoOf("right wall"), glm::vec3(0.14f, 0.45f, 0.091f));
    EXPECT_EQ(meshNamed(scene, "left wall").bounds.upper.x, -5.0f);
    EXPECT_EQ(meshNamed(scene, "left wall").normals[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(meshNamed(scene, "right wall").bounds.lower.x, 5.0f);
    EXPECT_EQ(meshNamed(scene, "right wall").normals[0], glm::vec3(-1, 0, 0));
}

/// Every given corner is a vertex of the mesh, to a hundredth of a millimetre.
void expectCorners(const assets::Mesh& mesh, std::initializer_list<glm::vec3> corners) {
    for (const glm::vec3& corner : corners) {
        float nearest = 1e9f;
        for (const glm::vec3& p : mesh.positions) {
            nearest = glm::min(nearest, glm::distance(p, corner));
        }
        EXPECT_LT(nearest, 1e-5f) << corner.x << " " << corner.y << " " << corner.z;
    }
}

TEST(Cornell, BoxesAreTurnedTheRightWay) {
    // From a glTF file of the same scene by other hands: the tall box at +17°, the short at −17°.
    const SceneSnapshot scene = snapshotOf("cornell");
    const assets::Mesh& grey = meshNamed(scene, "grey");
    expectCorners(grey, {{-2.6958995f, 0.0f, 0.4730147f},
                         {-3.5730147f, 6.0f, -2.3958995f},
                         {-0.7041004f, 6.0f, -3.2730148f},
                         {0.1730147f, 0.0f, -0.4041004f}});
    expectCorners(grey, {{-0.1730147f, 0.0f, 2.4958997f},
                         {0.7041004f, 3.0f, -0.3730147f},
                         {3.5730147f, 3.0f, 0.5041004f},
                         {2.6958997f, 0.0f, 3.3730147f}});
}

TEST(TwoRooms, ShellIsClosedAndHasItsSize) {
    const SceneSnapshot scene = snapshotOf("two_rooms");
    EXPECT_EQ(unpairedEdges(scene, {"walls and ceiling", "floor", "far wall", "side wall"}), 0u);
    // The planted hole: without one wall it is not closed.
    EXPECT_GT(unpairedEdges(scene, {"walls and ceiling", "floor", "far wall"}), 0u);
    EXPECT_EQ(scene.boundsWorld.extent(), glm::vec3(16, 5, 10));
    // Facing inwards, the shell encloses minus its air: the box without the wall, with the doorway.
    double air = 0.0;
    for (const char* name : {"walls and ceiling", "floor", "far wall", "side wall"}) {
        air -= test::volume(meshNamed(scene, name));
    }
    EXPECT_NEAR(air, (16.0 - 0.2) * 5.0 * 10.0 + 0.2 * 3.0 * 4.0, 1e-3);
}

TEST(TwoRooms, ThingsAreClosedAndInside) {
    const SceneSnapshot scene = snapshotOf("two_rooms");
    for (const char* name : {"yellow box", "white sphere", "blue sphere", "green box",
                             "orange ring", "columns", "purple cabinet"}) {
        const assets::Mesh& mesh = meshNamed(scene, name);
        EdgeCount edges;
        edges.add(mesh);
        EXPECT_EQ(edges.unpaired(), 0u) << name;
        EXPECT_GT(test::volume(mesh), 0.0) << name;
        EXPECT_TRUE(glm::all(glm::greaterThan(mesh.bounds.upper, glm::vec3(-8, 0, -5)))) << name;
        EXPECT_TRUE(glm::all(glm::lessThan(mesh.bounds.upper, glm::vec3(8, 5, 5)))) << name;
    }
}

TEST(TwoRooms, LightAndCameraAreInDifferentRooms) {
    const SceneSnapshot scene = snapshotOf("two_rooms");
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_LT(scene.lights[0].positionWorld.x + scene.lights[0].radiusMetres, -0.1f);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_GT(scene.cameras[0].cameraToWorld[3].x, 0.1f);
}

TEST(Conference, IsAClosedRoomOfItsSizeWithFourLamps) {
    const SceneSnapshot scene = snapshotOf("conference");
    EXPECT_EQ(unpairedEdges(scene, {"plaster", "carpet", "window panes", "end wall"}), 0u);
    EXPECT_NEAR(static_cast<double>(triangleCount(scene)), 330e3, 5e3);
    EXPECT_EQ(scene.lights.size(), 4u);
    const math::Bounds room = scene.boundsWorld;
    EXPECT_EQ(room.lower, glm::vec3(-7.0f, 0.0f, -4.8f));
    EXPECT_EQ(room.upper, glm::vec3(7.0f, 3.4f, 4.5f));
}

}  // namespace
}  // namespace lampyris::scene
