// Motion at pixels against where each thing was, by its own formula.
#include "deferred/motion.h"

#include <algorithm>

#include "deferred/show_surface.h"
#include "deferred/view.h"
#include "execute/executor.h"
#include "execute/raw_image.h"
#include "residency/scene_on_gpu.h"
#include "support/gpu_test.h"
#include "support/posed_meshes.h"
#include "support/small_scenes.h"

namespace lampyris::test {
namespace {

constexpr graph::Extent kSize{96, 54};

assets::Mesh box(const glm::vec3& half) {
    assets::Mesh mesh = quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
    for (int side = 1; side < 6; ++side) {
        const glm::vec3 axis = side < 4 ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        const float degrees =
            side < 4 ? 90.0f * static_cast<float>(side) : (side == 4 ? 90.0f : -90.0f);
        const glm::mat3 turn(glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis));
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        for (int i = 0; i < 4; ++i) mesh.positions.push_back(turn * mesh.positions[i]);
        for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    }
    mesh.normals.clear();
    for (glm::vec3& p : mesh.positions) p *= half;
    return mesh;
}

/// From y = −1 to 1, skinned to two joints by height.
assets::Mesh strip() {
    assets::Mesh mesh;
    for (uint32_t i = 0; i <= 8; ++i)
        for (const float x : {-0.5f, 0.5f}) {
            const float along = static_cast<float>(i) / 8.0f;
            mesh.positions.emplace_back(x, 2.0f * along - 1.0f, 0.0f);
            mesh.joints.emplace_back(0, 1, 0, 0);
            mesh.weights.emplace_back(1.0f - along, along, 0.0f, 0.0f);
        }
    for (uint32_t i = 0; i < 16; i += 2)
        mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 3, i, i + 3, i + 2});
    return mesh;
}

glm::mat4 at(const glm::vec3& place) {
    return glm::translate(glm::mat4(1.0f), place);
}

glm::mat4 turned(float degrees) {
    return glm::rotate(at({0.0f, 0.5f, 0.0f}), glm::radians(degrees), glm::vec3(0, 1, 0));
}

std::shared_ptr<scene::Pose> bent(float byMetres) {
    auto pose = std::make_shared<scene::Pose>();
    pose->jointMatrices = {glm::mat4(1.0f), at({byMetres, 0.0f, 0.0f})};
    return pose;
}

class MotionTest : public GpuTest {
 protected:
    MotionTest() {
        if (!sharedDevice().ok()) return;
        onGpu.emplace(device());
        builder.addMaterial(mattMaterial());
        auto cutOut = mattMaterial();
        cutOut.alphaMode = assets::AlphaMode::Mask;
        cutOut.baseColour.a = 0.0f;
        builder.addMaterial(cutOut);
        const uint32_t wall =
            builder.addMesh(quad({-9, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-9, 9, -3}));
        builder.addInstance(wall, 0);
        pushed =
            builder.addInstance(builder.addMesh(box({0.6f, 0.7f, 0.5f})), 0, at({-2.5f, 0, 0}));
        turning = builder.addInstance(builder.addMesh(box({0.5f, 1.0f, 0.5f})), 0, turned(10.0f));
        skinned = builder.addInstance(builder.addMesh(strip()), 0, at({2.5f, 0, 0}));
        setPose(builder, skinned, bent(0.1f));
        hidden = builder.addInstance(wall, 1, at({0, 0, 4}));
    }

    /// update, G-buffer and motion.
    void draw() {
        static execute::Executor executor = need(execute::Executor::create(device()));
        need(onGpu->update(builder.snapshot));
        graph::Frame frame;
        const auto handles = residency::importScene(frame, *onGpu);
        const auto view =
            deferred::makeView(lookFrom({0.3f, 0.5f, 6.0f}, {0.0f, 0.0f, 0.0f}), kSize);
        const auto surface = deferred::addGBuffer(frame, view, handles, onGpu->draws());
        deferred::publishSurface(frame, surface);
        const auto moved = deferred::addMotion(frame, surface, handles, onGpu->draws());
        anyMotion = moved.valid();
        execute::RunOptions options;
        options.readBackImages = {frame.published("position")};
        if (anyMotion) options.readBackImages.push_back(moved);
        for (const auto image : options.readBackImages) frame.output(image);
        const auto result = need(executor.run(frame, options));
        position = execute::toImage(result.images[0]);
        if (anyMotion) motion = execute::toImage(result.images[1]);
    }

    /// Holds motion at pixels to was(position) − position; those of the wall to 0.
    template <typename Was>
    void expectMotion(const Was& was) {
        uint32_t onWall = 0, onThings = 0;
        for (uint32_t y = 0; y < kSize.height; ++y)
            for (uint32_t x = 0; x < kSize.width; ++x) {
                const glm::vec3 p(position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2));
                const glm::vec3 m(motion.at(x, y, 0), motion.at(x, y, 1), motion.at(x, y, 2));
                const glm::vec3 wanted = p.z < -2.5f ? glm::vec3(0.0f) : was(p) - p;
                EXPECT_LT(glm::distance(m, wanted), 1e-3f) << x << ' ' << y << ' ' << p.x;
                EXPECT_EQ(motion.at(x, y, 3), wanted != glm::vec3(0.0f) ? 1.0f : 0.0f);
                ++(p.z < -2.5f ? onWall : onThings);
            }
        EXPECT_GT(onWall, 500u);
        EXPECT_GT(onThings, 500u);
    }

    SnapshotBuilder builder;
    std::optional<residency::SceneOnGpu> onGpu;
    uint32_t pushed = 0, turning = 0, skinned = 0, hidden = 0;
    bool anyMotion = false;
    core::Image position, motion;
};

TEST_F(MotionTest, EqualsWhatMoved) {
    draw();
    EXPECT_FALSE(anyMotion) << "what is new has not moved";
    builder.moveInstance(pushed, at({-2.3f, 0.1f, 0.3f}));
    builder.moveInstance(turning, turned(35.0f));
    builder.moveInstance(hidden, at({0.5f, 0, 4}));  // cut out by alpha, before everything
    setPose(builder, skinned, bent(0.6f));
    draw();
    ASSERT_TRUE(anyMotion);
    const glm::mat4 back = turned(10.0f) * glm::inverse(turned(35.0f));
    expectMotion([&](const glm::vec3& p) {
        if (p.x < -1.2f) return p - glm::vec3(0.2f, 0.1f, 0.3f);
        if (p.x < 1.2f) return glm::vec3(back * glm::vec4(p, 1.0f));
        return p - glm::vec3(0.5f * (p.y + 1.0f) * 0.5f, 0.0f, 0.0f);
    });
    draw();
    EXPECT_FALSE(anyMotion) << "nothing moved any more";
}

TEST_F(MotionTest, TakesPlacesAndPosesTogether) {
    draw();
    builder.moveInstance(skinned, at({2.6f, 0.2f, 0}));
    draw();  // moved, but posed as before
    expectMotion(
        [](const glm::vec3& p) { return p.x < 1.2f ? p : p - glm::vec3(0.1f, 0.2f, 0.0f); });
    builder.moveInstance(skinned, at({2.4f, 0.2f, 0}));
    setPose(builder, skinned, bent(0.4f));
    draw();
    expectMotion([](const glm::vec3& p) {
        return p.x < 1.2f ? p : p + glm::vec3(0.2f - 0.3f * (p.y + 0.8f) * 0.5f, 0.0f, 0.0f);
    });
}

}  // namespace
}  // namespace lampyris::test
