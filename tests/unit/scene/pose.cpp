#include "scene/pose.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/deformed_meshes.h"

namespace lampyris::scene {
namespace {

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool holds(const math::Bounds& box, const glm::vec3& point) {
    return glm::all(glm::lessThanEqual(box.lower, point)) &&
           glm::all(glm::greaterThanEqual(box.upper, point));
}

/// That all finite vertices are inside, to the last bit; gives how many times wider the box is.
float expectHeld(const assets::Mesh& mesh, const Pose& pose) {
    const math::Bounds box = posedBounds(mesh, pose);
    EXPECT_TRUE(isFinite(box.lower) && isFinite(box.upper));
    math::Bounds tight;
    for (const glm::vec3& position : posedVertices(mesh, pose).positions) {
        if (!isFinite(position)) continue;
        tight.grow(position);
        EXPECT_TRUE(holds(box, position));
    }
    return glm::length(box.extent()) / glm::length(tight.extent());
}

TEST(PosedBounds, HoldThePosedVertices) {
    for (uint32_t seed = 0; seed < 200; ++seed) {
        const uint32_t joints = seed % 5;
        const uint32_t targets = seed % 3;
        const float reach = std::pow(10.0f, static_cast<float>(seed % 9) - 4.0f);
        const assets::Mesh mesh = test::bendableSoup(40, joints, targets, seed, reach);
        expectHeld(mesh, test::anyPose(joints, targets, seed, 3.0f * reach));
        expectHeld(mesh, test::anyPose(joints, targets, seed + 1, 1e4f * reach));
    }
}

TEST(PosedBounds, AtRestAreTheMeshs) {
    const assets::Mesh mesh = test::bendableSoup(100, 3, 2, 7);
    const Pose rest{{0, 0}, std::vector<glm::mat4>(3, glm::mat4(1.0f))};
    EXPECT_LT(expectHeld(mesh, rest), 1.001f);
    EXPECT_LT(expectHeld(mesh, {}), 1.001f);
    // More or fewer weights than targets are no trouble.
    EXPECT_GT(expectHeld(mesh, {{1.0f}, {}}), 0.9f);
    EXPECT_GT(expectHeld(mesh, {{1, 1, 1, 1}, {}}), 0.9f);
}

TEST(PosedBounds, StayFiniteWhateverThePose) {
    const assets::Mesh mesh = test::bendableSoup(40, 3, 1, 1);
    constexpr float kHuge = std::numeric_limits<float>::max();
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float odd : {kHuge, -kHuge, kNone, kInfinity, 0.0f}) {
        expectHeld(mesh, {{odd}, {}});
        expectHeld(mesh, {{0.0f}, {glm::mat4(odd), glm::mat4(1.0f), glm::mat4(1.0f)}});
        expectHeld(mesh, {{0.0f}, std::vector<glm::mat4>(3, glm::mat4(odd))});
    }
}

TEST(PosedVertices, OneJointCarriesAllRigidly) {
    assets::Mesh mesh = test::bendableSoup(20, 1, 0, 3);
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(1, 0, 0, -1));
    const glm::quat turn = glm::angleAxis(1.0f, glm::normalize(glm::vec3(1, 2, 3)));
    const glm::mat4 matrix =
        glm::translate(glm::mat4(1.0f), glm::vec3(1, 2, 3)) * glm::mat4_cast(turn);
    const PosedVertices posed = posedVertices(mesh, {{}, {matrix}});
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_LT(glm::distance(posed.positions[i], turn * mesh.positions[i] + glm::vec3(1, 2, 3)),
                  1e-5f);
        EXPECT_LT(glm::distance(posed.normals[i], turn * mesh.normals[i]), 1e-5f);
        EXPECT_LT(glm::distance(glm::vec3(posed.tangents[i]), turn * glm::vec3(1, 0, 0)), 1e-5f);
        EXPECT_EQ(posed.tangents[i].w, -1.0f);
    }
}

}  // namespace
}  // namespace lampyris::scene
