// What a program relies on of frames that it has drawn: where the picture rests, which nodes there
// are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "execute/copy_ring.h"
#include "photon_gi/indirect_cost.h"
#include "scene/builtin/shapes.h"
#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"
#include "support/frame_test.h"

namespace lampyris {
namespace {

using photon_gi::FrameRequest;
using photon_gi::Settings;

class DrawnFrames : public test::FrameTest {
 protected:
    /// A still camera, frames that may be shown again whole.
    static FrameRequest still(const scene::SceneSnapshot& snapshot) {
        FrameRequest asked = request(64, 36, snapshot.cameras.front());
        asked.settings.history = 4;
        asked.finalAlone = true;
        return asked;
    }
};

// The copy reads the picture in the layout that is promised, under validation.
TEST_F(DrawnFrames, RestAlikeWhetherTheyAreKeptOrNot) {
    const auto snapshot = test::builtinSnapshot("cornell");
    FrameRequest asked = still(snapshot);
    auto executor = test::need(execute::Executor::create(device()));
    photon_gi::Renderer renderer(executor);
    core::Image last;
    uint32_t shownAgain = 0;
    for (; asked.frameNumber < 12; ++asked.frameNumber) {
        const auto drawn = test::need(renderer.draw(snapshot, asked, "final"));
        shownAgain += drawn.report.retraced == 0 ? 1 : 0;
        auto ring = test::need(execute::CopyRing::create(device()));
        const graph::ImageDesc desc{graph::Format::RGBA16Float, asked.size};
        EXPECT_FALSE(test::need(ring.turn(executor.outputImage(drawn.radiance), desc)).has_value());
        const auto copied = test::need(ring.takeOldest());
        ASSERT_TRUE(copied.has_value());
        EXPECT_EQ(execute::toImage(*copied).values, drawn.image.values) << asked.frameNumber;
    }
    EXPECT_GT(shownAgain, 2u);
}

/// Draws a scene with lights and a thing that moves, and looks at the nodes.
class Nodes : public DrawnFrames {
 protected:
    Nodes() : world_(test::need(scene::builtinScene("cornell"))) {
        auto& library = world_.resource<scene::Library>();
        const auto paint = library.addMaterial(scene::lambertian("paint", {0.7f, 0.4f, 0.2f}));
        moving_ = scene::spawnMesh(world_, scene::builtin::boxMesh(glm::vec3(0.3f)), paint);
        scene::spawnLight(world_, "lamp", {3, 2, 3.5f}, {0.2f, {200, 150, 100}});
    }

    /// Five frames, of which the first two move.
    void draw(const Settings& settings) {
        auto executor = test::need(execute::Executor::create(device()));
        photon_gi::Renderer renderer(executor);
        for (uint64_t number = 0; number < 5; ++number) {
            if (number < 2) world_.edit<scene::Transform>(moving_).translation.x += 0.1f;
            scene::updateWorldTransforms(world_, since_);
            snapshot_ = scene::extract(world_, snapshot_, since_);
            since_ = world_.advance();
            FrameRequest asked = still(snapshot_);
            asked.frameNumber = number;
            asked.settings = settings;
            asked.settings.history = 1;
            const auto drawn = test::need(renderer.draw(snapshot_, asked));
            for (const auto& node : drawn.statistics.nodes) look(node.name);
        }
    }

    void look(const std::string& node) {
        // Surfaces, direct light, the composite, and what keeps the scene up to date.
        static constexpr std::array kOthers{
            "gbuffer", "gbuffer_motion", "sphere_direct", "shadow", "composite", "skin", "morph"};
        const std::string name = execute::reportedName(node);
        const bool upkeep =
            name.starts_with("refit_") || name.starts_with("tlas_") || name.starts_with("upload");
        const bool other = std::find(kOthers.begin(), kOthers.end(), name) != kOthers.end();
        EXPECT_TRUE(photon_gi::isIndirect(node) != (upkeep || other))
            << node << ": indirect_cost.h must know it, or this test";
        indirect_ += photon_gi::isIndirect(node) ? 1 : 0;
    }

    ecs::World world_;
    scene::SceneSnapshot snapshot_;
    ecs::Tick since_ = 0;
    ecs::Entity moving_;
    uint32_t indirect_ = 0;
};

TEST_F(Nodes, AreIndirectLightsOrKnownToBeNoneOfIt) {
    Settings settings;
    draw(settings);
    EXPECT_GT(std::exchange(indirect_, 0), 10u);
    settings.retrace = photon_gi::Retrace::All;
    draw(settings);
    EXPECT_GT(std::exchange(indirect_, 0), 10u);
    settings.gather = photon_gi::Gather::Tiles;
    draw(settings);
    EXPECT_GT(std::exchange(indirect_, 0), 10u);
    settings.pipeline = photon_gi::Pipeline::Thesis;
    photon_gi::mend(settings);
    draw(settings);
    EXPECT_GT(std::exchange(indirect_, 0), 10u);
    settings.pipeline = photon_gi::Pipeline::Direct;
    draw(settings);
    EXPECT_EQ(indirect_, 0u);
}

}  // namespace
}  // namespace lampyris
