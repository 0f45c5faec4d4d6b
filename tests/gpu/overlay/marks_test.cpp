// Marks where there is more than is drawn, and where what was chosen is not there.
#include "overlay/marks.h"

#include <algorithm>

#include "overlay/overlay.h"
#include "overlay/panels.h"
#include "scene/registration.h"
#include "support/frame_test.h"

namespace lampyris::overlay {
namespace {

using test::need;

constexpr graph::Extent kSize{320, 180};

/// A floor under two lamps, of which the first is red and the second green.
scene::SceneSnapshot twoLamps() {
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::quad({-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}),
                      test::lambertian(glm::vec3(0.5f)));
    test::addInstance(snapshot, test::quad({-4, 4, -4}, {4, 4, -4}, {4, 4, 4}, {-4, 4, 4}),
                      test::lambertian(glm::vec3(0.5f)));
    test::addLight(snapshot, {-2, 2, 0}, 0.1f, 0.0f);
    test::addLight(snapshot, {2, 2, 0}, 0.1f, 0.0f);
    snapshot.lights[0].powerWatts = {10, 0, 0};
    snapshot.lights[1].powerWatts = {0, 10, 0};
    return snapshot;
}

class MarksOfTwoLamps : public test::FrameTest {
 protected:
    MarksOfTwoLamps() : renderer_(device(), snapshot_) {}

    /// Pixels of each channel that are lit by marks over black.
    std::array<size_t, 2> draw(const MarkChoice& choice) {
        photon_gi::FrameRequest request;
        request.size = kSize;
        request.camera = test::lookFrom({0, 2, 8}, {0, 1.5f, 0});
        request.settings.guiding = false;
        for (int attempt = 0; attempt < 8; ++attempt) {
            graph::Frame frame;
            const auto drawn = need(renderer_.declare(frame, request));
            auto node = frame.raster("ground", kSize);
            const auto black =
                node.clearedColour(0, frame.image("shown", {graph::Format::RGBA8Unorm, kSize}),
                                   std::array<float, 4>{0, 0, 0, 1});
            node.record({}, [](graph::RasterCommands&) {});
            const auto marked = addMarks(frame, drawn.insides, choice, black);
            frame.output(marked);
            frame.publish("marked", marked);
            const auto outcome = need(renderer_.run(frame, drawn, "marked"));
            if (!outcome.report.valid) continue;
            stored_ = outcome.report.counters.photonsStored;
            std::array<size_t, 2> lit{};
            for (size_t i = 0; i < outcome.image.values.size(); i += 4)
                for (size_t c = 0; c < 2; ++c) lit[c] += outcome.image.values[i + c] > 0.1f ? 1 : 0;
            return lit;
        }
        throw std::runtime_error("no frame was whole");
    }

    scene::SceneSnapshot snapshot_ = twoLamps();
    test::SceneRenderer renderer_;
    uint32_t stored_ = 0;
};

TEST_F(MarksOfTwoLamps, FewPhotonsAreOfAllLamps) {
    MarkChoice choice;
    choice.photons = true;
    choice.throughWalls = true;
    choice.radiusPixels = 0.5f;
    choice.brightnessEv = 20.0f;
    const auto all = draw(choice);
    EXPECT_GT(std::min(all[0], all[1]), 100u);
    choice.most = stored_ / 8;
    const auto few = draw(choice);
    EXPECT_LT(few[0] + few[1], all[0] + all[1]);
    EXPECT_LE(few[0] + few[1], choice.most);
    EXPECT_GT(few[0], choice.most / 8);
    EXPECT_GT(few[1], choice.most / 8) << "the lamp whose paths lie last";
}

TEST_F(MarksOfTwoLamps, FewPathsAreOfAllLamps) {
    MarkChoice choice;
    choice.paths = true;
    choice.throughWalls = true;
    choice.brightnessEv = 20.0f;
    const auto all = draw(choice);
    choice.most = stored_ / 64;
    const auto few = draw(choice);
    for (size_t c = 0; c < 2; ++c) {
        EXPECT_GT(few[c], 50u) << c;
        EXPECT_LT(few[c], all[c]) << c;
    }
}

TEST_F(MarksOfTwoLamps, TheFirstLevelOfBoxesIsTheLeast) {
    MarkChoice choice;
    choice.boxes = true;
    choice.throughWalls = true;
    choice.boxLevel = 0;
    EXPECT_GT(draw(choice)[0], 100u);
}

TEST_F(MarksOfTwoLamps, AHeatThatIsNotThereIsNotKept) {
    Overlay overlay = need(Overlay::create(device()));
    ecs::Registry registry;
    scene::registerComponents(registry);
    Panels panels = need(Panels::create(device(), registry));
    graph::Frame frame;
    const graph::CompiledGraph compiled;
    const FrameSeen seen{{}, frame, compiled, {}, {}, snapshot_, kSize};
    ecs::World world;
    ecs::Entity selected;
    photon_gi::Settings settings;
    core::DisplayTransform display;
    panels.open.light = true;
    const auto drawWith = [&](Heat heat) {
        panels.marks.heat = heat;
        overlay.begin({}, kSize, kSize, 0.1);
        panels.draw(seen, {}, {world, selected, settings, settings, display});
        overlay.end();
        return panels.marks.any();
    };
    EXPECT_FALSE(drawWith(Heat::Tiles)) << "frames need not be drawn whole for it";
    EXPECT_TRUE(drawWith(Heat::History));
    settings.gather = photon_gi::Gather::Tiles;
    EXPECT_TRUE(drawWith(Heat::Tiles));
    EXPECT_FALSE(drawWith(Heat::History));
}

}  // namespace
}  // namespace lampyris::overlay
