// Poses of the snapshot: what changes them, and what does not.
#include <gtest/gtest.h>

#include "scene/extract.h"
#include "scene/place_deformed.h"
#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"
#include "support/deformed_meshes.h"

namespace lampyris::scene {
namespace {

/// root { shape (two joints, one morph target), hip { knee } }, all somewhere.
class ExtractPoses : public testing::Test {
 protected:
    ExtractPoses() {
        world.setResource(Library{});
        root = spawn(world, "root", {{1, 2, 3}, glm::angleAxis(0.3f, glm::vec3(0, 1, 0))});
        shape = spawnMesh(world, test::bendableSoup(10, 2, 1, 5), {}, {{0, 0.1f, 0}});
        rigid = spawnMesh(world, test::bendableSoup(2, 0, 0, 6), {});
        hip = spawn(world, "hip", {{0, 1, 0}, glm::angleAxis(0.7f, glm::vec3(1, 0, 0))});
        knee = spawn(world, "knee", {{0, 0, 2}, {1, 0, 0, 0}, {1, 2, 1}});
        place(shape, root);
        place(hip, root);
        place(knee, hip);
        const glm::mat4 bind = glm::translate(glm::mat4(1.0f), glm::vec3(0, -1, 0));
        world.add(shape, Skin{{hip, knee}, {bind, bind * bind}});
        world.add(shape, MorphWeights{{0.25f}});
        update();
    }
    void place(ecs::Entity child, ecs::Entity parent) {
        ASSERT_TRUE(ecs::setParent(world, child, parent).ok());
    }
    void update() {
        updateWorldTransforms(world, since);
        before = std::move(now);
        now = extract(world, before, since);
        since = world.advance();
        expectVerticesWhereTheyBelong();
    }
    [[nodiscard]] static const SnapshotInstance& find(const SceneSnapshot& snapshot,
                                                      ecs::Entity entity) {
        for (const SnapshotInstance& instance : snapshot.instances)
            if (instance.entity == entity) return instance;
        ADD_FAILURE() << "not drawn";
        return snapshot.instances.front();
    }
    [[nodiscard]] const SnapshotInstance& is() const { return find(now, shape); }
    [[nodiscard]] const SnapshotInstance& was() const { return find(before, shape); }
    /// Joint's world transform · inverse bind matrix, blended: nothing else decides.
    void expectVerticesWhereTheyBelong() {
        const auto* skin = world.find<Skin>(shape);
        if (skin == nullptr || !world.has<MeshInstance>(shape) || !world.alive(knee)) return;
        const assets::Mesh& mesh = *now.meshes[is().mesh].value;
        const PosedVertices morphed = posedVertices(
            mesh, {world.has<MorphWeights>(shape) ? world.get<MorphWeights>(shape).values
                                                  : std::vector<float>{},
                   {}});
        const PosedVertices posed = posedVertices(mesh, *is().pose);
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            glm::vec3 wanted(0.0f);
            for (int k = 0; k < 4; ++k) {
                const size_t joint = mesh.joints[i][k];
                wanted += mesh.weights[i][k] *
                          glm::vec3(world.get<WorldTransform>(skin->joints[joint]).matrix *
                                    skin->inverseBindMatrices[joint] *
                                    glm::vec4(morphed.positions[i], 1.0f));
            }
            const glm::vec3 drawn(is().objectToWorld * glm::vec4(posed.positions[i], 1.0f));
            ASSERT_LT(glm::distance(drawn, wanted), 1e-4f);
            const glm::vec3 slack(1e-4f);
            ASSERT_TRUE(glm::all(glm::lessThan(is().boundsWorld.lower, drawn + slack)));
            ASSERT_TRUE(glm::all(glm::greaterThan(is().boundsWorld.upper, drawn - slack)));
        }
    }

    ecs::World world;
    ecs::Entity root, shape, rigid, hip, knee;
    ecs::Tick since = 0;
    SceneSnapshot before, now;
};

TEST_F(ExtractPoses, OnlyWhatIsDeformedHasOne) {
    ASSERT_NE(is().pose, nullptr);
    EXPECT_EQ(is().pose->morphWeights, std::vector<float>{0.25f});
    EXPECT_EQ(is().pose->jointMatrices.size(), 2u);
    EXPECT_EQ(find(now, rigid).pose, nullptr);
}

TEST_F(ExtractPoses, NothingMovedIsTheSamePose) {
    update();
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(is().version, was().version);
    EXPECT_EQ(is().pose, was().pose);
}

TEST_F(ExtractPoses, ACharacterMovedAsAWholeKeepsItsPose) {
    for (const ecs::Entity moved : {root, hip}) {
        world.edit<Transform>(moved).translation += glm::vec3(0.1f, 7.3f, 1e4f);
        world.edit<Transform>(moved).rotation = glm::angleAxis(2.0f, glm::vec3(0, 0, 1));
        updateWorldTransforms(world, since);
        before = now;
        now = extract(world, before, since);
        since = world.advance();
        EXPECT_EQ(is().pose, was().pose);
        EXPECT_EQ(is().poseVersion, was().poseVersion);
        EXPECT_GT(is().version, was().version);
        EXPECT_NE(is().objectToWorld, was().objectToWorld);
        EXPECT_NE(is().boundsWorld.lower, was().boundsWorld.lower);
    }
}

TEST_F(ExtractPoses, AJointThatMovesChangesThePoseAlone) {
    world.edit<Transform>(knee).rotation = glm::angleAxis(1.0f, glm::vec3(0, 0, 1));
    update();
    EXPECT_GT(is().version, was().version);
    EXPECT_EQ(is().poseVersion, is().version);
    EXPECT_EQ(is().objectToWorld, was().objectToWorld);
    EXPECT_GT(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(find(now, rigid).version, find(before, rigid).version);
}

TEST_F(ExtractPoses, WeightsChangeThePose) {
    world.edit<MorphWeights>(shape).values = {0.5f};
    update();
    EXPECT_GT(is().poseVersion, was().poseVersion);
    // Padded and cut to the mesh's targets.
    world.edit<MorphWeights>(shape).values = {};
    update();
    EXPECT_EQ(is().pose->morphWeights, std::vector<float>{0.0f});
    world.edit<MorphWeights>(shape).values = {0.0f, 9.0f};
    update();
    EXPECT_EQ(is().poseVersion, was().poseVersion);
}

TEST_F(ExtractPoses, TheMeshsOwnPlaceAndFlatnessPlayNoPart) {
    world.edit<Transform>(shape).translation.x += 5.0f;
    world.edit<Transform>(shape).scale = glm::vec3(0.0f);
    update();
    EXPECT_EQ(is().version, was().version);
}

TEST_F(ExtractPoses, AnotherMeshIsAnotherPose) {
    auto& library = world.resource<Library>();
    library.replaceMesh(world.get<MeshInstance>(shape).mesh, test::bendableSoup(4, 2, 3, 9));
    update();
    EXPECT_GT(is().poseVersion, was().poseVersion);
    EXPECT_EQ(is().pose->morphWeights.size(), 3u);
    library.replaceMesh(world.get<MeshInstance>(shape).mesh, test::bendableSoup(4, 1, 0, 9));
    update();
    EXPECT_TRUE(is().pose->morphWeights.empty());
}

TEST_F(ExtractPoses, ComponentsComeAndGo) {
    world.remove<Skin>(shape);
    update();
    EXPECT_TRUE(is().pose->jointMatrices.empty());
    EXPECT_EQ(is().objectToWorld, world.get<WorldTransform>(shape).matrix);
    world.remove<MorphWeights>(shape);
    update();
    EXPECT_EQ(is().pose, nullptr);
    EXPECT_GT(is().poseVersion, was().poseVersion);
    world.remove<MeshInstance>(shape);
    update();
    EXPECT_EQ(now.instances.size(), 1u);
    world.add(shape, MeshInstance{MeshId{0}, {}});
    world.add(shape, Skin{{hip, knee}, std::vector<glm::mat4>(2, glm::mat4(1.0f))});
    update();
    EXPECT_NE(is().pose, nullptr);
    // On a mesh that nothing can bend, both are void.
    world.add(rigid, Skin{{hip, knee}, {}});
    world.add(rigid, MorphWeights{{1, 2}});
    update();
    EXPECT_EQ(find(now, rigid).pose, nullptr);
}

TEST_F(ExtractPoses, JointsThatAreGoneStandAtTheOthersPlace) {
    world.destroy(knee);
    update();
    ASSERT_EQ(is().pose->jointMatrices.size(), 2u);
    EXPECT_EQ(is().pose->jointMatrices[1], world.get<Skin>(shape).inverseBindMatrices[1]);
    EXPECT_EQ(is().objectToWorld, world.get<WorldTransform>(hip).matrix);
    world.destroy(hip);
    update();
    EXPECT_EQ(is().objectToWorld, world.get<WorldTransform>(shape).matrix);
    // Fewer joints than the mesh names: the rest are as if gone.
    world.edit<Skin>(shape).joints.clear();
    world.edit<Skin>(shape).inverseBindMatrices.clear();
    update();
    EXPECT_EQ(is().pose->jointMatrices, std::vector<glm::mat4>(2, glm::mat4(1.0f)));
}

TEST_F(ExtractPoses, JointsOfSeveralRootsStandInTheWorld) {
    ecs::clearParent(world, knee);
    update();
    EXPECT_EQ(is().objectToWorld, glm::mat4(1.0f));
    place(knee, root);
    update();
    EXPECT_EQ(is().objectToWorld, world.get<WorldTransform>(root).matrix);
}

TEST_F(ExtractPoses, DeepSkeletonsTakeNoSquareOfTime) {
    Skin skin;
    ecs::Entity above = root;
    for (int i = 0; i < 20000; ++i) {
        const ecs::Entity joint = spawn(world, "");
        place(joint, above);
        above = joint;
        skin.joints.push_back(joint);
    }
    world.set(shape, skin);
    updateWorldTransforms(world, since);
    now = extract(world, now, since);
    EXPECT_EQ(is().pose->jointMatrices.size(), 20000u);
}

TEST_F(ExtractPoses, ACharacterIsMovedByWhatHoldsItAndItsJoints) {
    EXPECT_EQ(wholeOf(world, shape), root);
    EXPECT_EQ(wholeOf(world, rigid), rigid);
    EXPECT_EQ(wholeOf(world, knee), knee);
    EXPECT_EQ(wholeOf(world, {}), ecs::Entity{});
    const glm::vec3 stood(is().objectToWorld[3]);
    world.edit<Transform>(wholeOf(world, shape)).translation.x += 5.0f;
    update();
    EXPECT_NEAR(is().objectToWorld[3].x, stood.x + 5.0f, 1e-5f);
    ecs::clearParent(world, shape);
    EXPECT_EQ(wholeOf(world, shape), hip) << "what its joints hang on";
    world.destroy(hip);
    EXPECT_EQ(wholeOf(world, shape), shape);
}

}  // namespace
}  // namespace lampyris::scene
