// What is kept from frame to frame is what would have been traced, and no light stays behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"
#include "support/frame_test.h"

namespace lampyris {
namespace {

double meanOf(const core::Image& image) {
    double sum = 0.0;
    for (const float value : image.values) sum += static_cast<double>(value);
    return sum / static_cast<double>(image.values.size());
}

/// Cornell with a thing of three triangles that moves, and a second light.
class KeptPaths : public test::FrameTest {
 protected:
    KeptPaths() : world_(test::need(scene::builtinScene("cornell"))) {
        assets::Mesh mesh;
        mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 2, 0.3f}, {0, 0, 1}};
        mesh.normals.assign(4, {0, 0, 1});
        mesh.indices = {0, 1, 2, 1, 3, 2, 3, 0, 2};
        assets::updateBounds(mesh);
        auto& library = world_.resource<scene::Library>();
        const auto paint = library.addMaterial(scene::lambertian("paint", {0.7f, 0.4f, 0.2f}));
        moving_ = scene::spawnMesh(world_, std::move(mesh), paint, {{-3, 0, 3.5f}});
        lamp_ = scene::spawnLight(world_, "lamp", {3, 2, 3.5f}, {0.2f, {200, 150, 100}});
    }

    const scene::SceneSnapshot& step() {
        scene::updateWorldTransforms(world_, since_);
        snapshot_ = scene::extract(world_, snapshot_, since_);
        since_ = world_.advance();
        return snapshot_;
    }

    photon_gi::FrameRequest asked(photon_gi::Retrace retrace, bool reseed) {
        auto made = request(64, 36, step().cameras.front());
        made.settings.history = 32;
        made.settings.reseed = reseed;
        made.settings.retrace = retrace;
        made.settings.gatherDivisor = 4;
        return made;
    }

    /// The object goes to the right, a hand's breadth a frame.
    void move() { world_.edit<scene::Transform>(moving_).translation.x += 0.1f; }

    ecs::World world_;
    scene::SceneSnapshot snapshot_;
    ecs::Tick since_ = 0;
    ecs::Entity moving_, lamp_;
};

TEST_F(KeptPaths, AreThoseThatWouldHaveBeenTraced) {
    auto kept = asked(photon_gi::Retrace::Auto, false);
    auto anew = asked(photon_gi::Retrace::All, false);
    test::SceneRenderer keeping(device(), snapshot_), tracing(device(), snapshot_);
    for (uint32_t frame = 0; frame < 6; ++frame) {
        kept.frameNumber = anew.frameNumber = frame;
        const auto a = render(keeping, kept, "irradiance_indirect");
        const auto b = render(tracing, anew, "irradiance_indirect");
        ASSERT_EQ(a.image.values, b.image.values) << "frame " << frame;
        EXPECT_EQ(b.report.retraced, b.report.paths);
        if (frame > 0) {
            EXPECT_GT(a.report.retraced, 0u);
            EXPECT_LT(a.report.retraced, a.report.paths / 2);
        }
        EXPECT_EQ(a.report.counters.photonsStored, b.report.counters.photonsStored);
        EXPECT_LT(a.report.energy.relativeError(), 1e-4);
        move();
        test::need(keeping.update(step()));
        test::need(tracing.update(snapshot_));
    }
}

TEST_F(KeptPaths, DoNotStayWithALampThatLeftFarFromTheOrigin) {
    // Paths leave its plane from in front of it, the farther the larger the coordinates.
    auto panel = test::quad({500, 0, 0}, {500, 1, 0}, {500, 1, 1}, {500, 0, 1});
    assets::updateBounds(panel);
    auto light = scene::lambertian("light", glm::vec3(0.5f));
    light.emissiveRadiance = glm::vec3(10.0f);
    light.doubleSided = true;
    auto& library = world_.resource<scene::Library>();
    const auto lamp = scene::spawnMesh(world_, std::move(panel), library.addMaterial(light));
    const auto kept = asked(photon_gi::Retrace::Auto, false);
    test::SceneRenderer keeping(device(), snapshot_);
    (void)render(keeping, kept, "final");
    world_.edit<scene::Transform>(lamp).translation.y += 5.0f;
    test::need(keeping.update(step()));
    const auto& split = keeping.paths();
    uint32_t ofThePanel = 0;
    for (const auto& range : split.ranges)
        if (range.kind == shared::EMIT_SURFACE) ofThePanel += range.pathCount;
    EXPECT_GT(ofThePanel, 10u);
    EXPECT_GE(render(keeping, kept, "final").report.retraced, ofThePanel);
}

TEST_F(KeptPaths, OfALightThatMovedAreTracedAndNoOthers) {
    auto wanted = asked(photon_gi::Retrace::Auto, false);
    test::SceneRenderer renderer(device(), snapshot_);
    const auto before = render(renderer, wanted, "irradiance_indirect");
    world_.edit<scene::Transform>(lamp_).translation.y += 0.5f;
    test::need(renderer.update(step()));
    const auto after = render(renderer, wanted, "irradiance_indirect");
    const double share = 450.0 / (450.0 + 3000.0);  // of the lamp's watts
    EXPECT_NEAR(after.report.retraced, share * after.report.paths, 2.0);
    world_.edit<scene::SphereLight>(lamp_).powerWatts *= 2.0f;
    test::need(renderer.update(step()));
    const auto brighter = render(renderer, wanted, "irradiance_indirect");
    EXPECT_EQ(brighter.report.retraced, after.report.retraced);
    EXPECT_NEAR(brighter.report.energy.emitted.r - after.report.energy.emitted.r, 200.0, 0.1);
    EXPECT_LT(brighter.report.energy.relativeError(), 1e-4);
}

TEST_F(KeptPaths, AStillSceneSettlesAndWakes) {
    auto wanted = asked(photon_gi::Retrace::Auto, true);
    wanted.finalAlone = true;
    wanted.settings.history = 4;
    test::SceneRenderer renderer(device(), snapshot_);
    std::vector<core::Image> frames;
    const auto draw = [&] {
        frames.push_back(render(renderer, wanted, "final").image);
        ++wanted.frameNumber;
    };
    for (int i = 0; i < 10; ++i) draw();
    EXPECT_EQ(frames[9].values, frames[8].values);
    EXPECT_NE(frames[1].values, frames[0].values);
    const auto settled = render(renderer, wanted, "final");
    EXPECT_EQ(settled.report.retraced, 0u);
    EXPECT_GT(settled.report.paths, 0u);
    EXPECT_GT(settled.report.energy.emitted.r, 0.0);
    move();
    test::need(renderer.update(step()));
    draw();
    EXPECT_NE(frames.back().values, frames[9].values);
    wanted.camera.cameraToWorld[3].x += 0.5f;
    draw();
    EXPECT_NE(frames[11].values, frames[10].values);
}

TEST_F(KeptPaths, KeepTheMeanOfTheLight) {
    auto kept = asked(photon_gi::Retrace::Auto, true);
    auto anew = asked(photon_gi::Retrace::All, true);
    test::SceneRenderer keeping(device(), snapshot_), tracing(device(), snapshot_);
    kept.settings.history = anew.settings.history = 0;
    double keptMean = 0.0, newMean = 0.0;
    for (uint32_t frame = 0; frame < 96; ++frame) {
        kept.frameNumber = anew.frameNumber = frame;
        keptMean += meanOf(render(keeping, kept, "irradiance_indirect").image);
        newMean += meanOf(render(tracing, anew, "irradiance_indirect").image);
        world_.edit<scene::Transform>(moving_).translation.x =
            -3.0f + 0.05f * static_cast<float>(frame % 8);
        test::need(keeping.update(step()));
        test::need(tracing.update(snapshot_));
    }
    EXPECT_NEAR(keptMean, newMean, 0.025 * newMean);  // three deviations of 13 sets of paths
}

// Were paths that a change touches drawn anew, fewer and fewer would go where something moves: here
// a black curtain before half of the open side, that trembles.
TEST_F(KeptPaths, GoOnToWhatMoves) {
    assets::Mesh curtain;
    curtain.positions = {{-5, 0, 0}, {0, 0, 0}, {0, 10, 0}, {-5, 10, 0}};
    curtain.normals.assign(4, {0, 0, 1});
    curtain.indices = {0, 1, 2, 0, 2, 3};
    assets::updateBounds(curtain);
    const auto black =
        world_.resource<scene::Library>().addMaterial(scene::lambertian("black", glm::vec3(0.0f)));
    const ecs::Entity trembling = scene::spawnMesh(world_, curtain, black, {{0, 0, 5}});
    auto kept = asked(photon_gi::Retrace::Auto, true);
    auto anew = asked(photon_gi::Retrace::All, true);
    test::SceneRenderer keeping(device(), snapshot_), tracing(device(), snapshot_);
    double keptEscaped = 0.0, newEscaped = 0.0;
    for (uint32_t frame = 0; frame < 64; ++frame) {
        kept.frameNumber = anew.frameNumber = frame;
        keptEscaped += render(keeping, kept, "final").report.energy.escaped.g;
        newEscaped += render(tracing, anew, "final").report.energy.escaped.g;
        world_.edit<scene::Transform>(trembling).translation.z = frame % 2 == 0 ? 5.01f : 5.0f;
        test::need(keeping.update(step()));
        test::need(tracing.update(snapshot_));
    }
    EXPECT_NEAR(keptEscaped, newEscaped, 0.03 * newEscaped);
}

TEST_F(KeptPaths, ALightSwitchedOffIsGoneWithinTwelveFrames) {
    for (const auto retrace : {photon_gi::Retrace::Auto, photon_gi::Retrace::All}) {
        world_.set(lamp_, scene::SphereLight{0.2f, {600, 450, 300}});
        auto wanted = asked(retrace, true);
        test::SceneRenderer renderer(device(), snapshot_);
        const auto draw = [&](int frames) {
            core::Image last;
            for (int i = 0; i < frames; ++i, ++wanted.frameNumber)
                last = render(renderer, wanted, "irradiance_indirect").image;
            return last;
        };
        const double lit = meanOf(draw(40));
        world_.remove<scene::SphereLight>(lamp_);
        test::need(renderer.update(step()));
        const double soon = meanOf(draw(12));
        const double dark = meanOf(draw(40));
        EXPECT_LT(std::abs(soon - dark), 0.1 * (lit - dark));
    }
}

}  // namespace
}  // namespace lampyris
