// The overlay's nodes: panels over a picture, any image as something to look at, marks.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "overlay/image_look.h"
#include "overlay/marks.h"
#include "overlay/overlay.h"
#include "overlay/panels.h"
#include "scene/registration.h"
#include "support/frame_test.h"

namespace lampyris::overlay {
namespace {

using test::need;

constexpr graph::Extent kSize{640, 360};
constexpr std::array<float, 4> kGround{0.2f, 0.4f, 0.6f, 1.0f};

graph::Image ground(graph::Frame& frame, graph::Extent size = kSize,
                    std::array<float, 4> colour = kGround) {
    auto node = frame.raster("ground", size);
    const auto image =
        node.clearedColour(0, frame.image("shown", {graph::Format::RGBA8Unorm, size}), colour);
    node.record({}, [](graph::RasterCommands&) {});
    return image;
}

/// How many pixels of a rectangle are not the ground's colour.
size_t changed(const core::Image& image, uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1) {
    size_t count = 0;
    for (uint32_t y = y0; y < y1; ++y)
        for (uint32_t x = x0; x < x1; ++x) {
            float most = 0.0f;
            for (uint32_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(image.at(x, y, c) - kGround[c]));
            count += most > 1.5f / 255.0f ? 1 : 0;
        }
    return count;
}

class OverlayNodes : public test::FrameTest {
 protected:
    OverlayNodes() : executor_(need(execute::Executor::create(device()))) {}

    core::Image run(graph::Frame& frame, graph::Image shown) {
        execute::RunOptions options;
        options.readBackImages = {shown};
        frame.output(shown);
        const auto result = need(executor_.run(frame, options));
        for (const auto& node : result.statistics.nodes) ran_.push_back(node.name);
        return execute::toImage(result.images.front());
    }

    execute::Executor executor_;
    std::vector<std::string> ran_;
};

TEST_F(OverlayNodes, DrawsAPanelWhereItLiesAndNothingElse) {
    Overlay overlay = need(Overlay::create(device()));
    TimingPanel panel;
    execute::FrameStatistics statistics;
    statistics.nodes = {{"gather", 1.5, 0.1}};
    statistics.gpuMilliseconds = 2.0;
    panel.add(statistics, 0.1);
    core::Image image;
    for (int i = 0; i < 3; ++i) {  // ImGui finds its layout in the first frames
        graph::Frame frame;
        overlay.begin({}, kSize, kSize, 0.1);
        bool open = true;
        panel.draw(&open);
        EXPECT_TRUE(open);
        image = run(frame, overlay.addNode(frame, ground(frame)));
    }
    EXPECT_EQ(ran_.back(), "overlay");
    // It stands at (10, 30), 430 wide.
    EXPECT_GT(changed(image, 20, 60, 420, 340), 300u * 200u);
    EXPECT_EQ(changed(image, 0, 0, 8, 360), 0u);
    EXPECT_EQ(changed(image, 460, 0, 640, 360), 0u);
    EXPECT_GT(overlay.cpuMilliseconds(), 0.0);
}

TEST_F(OverlayNodes, IsNotThereWhileHidden) {
    Overlay overlay = need(Overlay::create(device()));
    overlay.show(false);
    graph::Frame frame;
    overlay.begin({}, kSize, kSize, 0.1);
    const graph::Image under = ground(frame);
    const graph::Image shown = overlay.addNode(frame, under);
    EXPECT_EQ(shown, under);
    EXPECT_EQ(changed(run(frame, shown), 0, 0, kSize.width, kSize.height), 0u);
    EXPECT_EQ(ran_, std::vector<std::string>{"ground"});
    EXPECT_EQ(overlay.cpuMilliseconds(), 0.0);
}

TEST_F(OverlayNodes, CountsWhatElseItDoesInAFrame) {
    Overlay overlay = need(Overlay::create(device()));
    overlay.begin({}, kSize, kSize, 0.1);
    overlay.end();
    {
        const auto counted = overlay.count();
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    overlay.begin({}, kSize, kSize, 0.1);
    EXPECT_GE(overlay.cpuMilliseconds(), 30.0);
    overlay.end();
    overlay.begin({}, kSize, kSize, 0.1);
    EXPECT_LT(overlay.cpuMilliseconds(), 30.0) << "each frame has its own";
    overlay.end();
}

TEST_F(OverlayNodes, TakesClicksOnItsPanelsAndLeavesTheOthers) {
    Overlay overlay = need(Overlay::create(device()));
    TimingPanel panel;
    panel.add({}, 0.0);
    const auto pointAt = [&](double x, double y, bool down) {
        window::Input input;
        input.cursorX = x;
        input.cursorY = y;
        input.buttons[0] = down;
        graph::Frame frame;
        overlay.begin(input, kSize, kSize, 0.1);
        bool open = true;
        panel.draw(&open);
        const bool wants = overlay.wantsMouse();
        (void)run(frame, overlay.addNode(frame, ground(frame)));
        return std::pair{wants, open};
    };
    for (int i = 0; i < 2; ++i) (void)pointAt(600, 300, false);
    EXPECT_FALSE(pointAt(600, 300, false).first);
    (void)pointAt(200, 200, false);
    EXPECT_TRUE(pointAt(200, 200, false).first);
    // The cross in the corner.
    (void)pointAt(429, 39, false);
    (void)pointAt(429, 39, true);
    EXPECT_FALSE(pointAt(429, 39, false).second);
}

/// A frame of the scene panel in a window that has room for it.
void drawScene(Overlay& overlay, ScenePanel& panel, ecs::World& world, ecs::Entity& selected,
               const window::Input& input) {
    constexpr graph::Extent kLarge{1280, 720};
    overlay.begin(input, kLarge, kLarge, 0.1);
    bool open = true;
    panel.draw(world, selected, &open);
    overlay.end();
}

TEST_F(OverlayNodes, KnowsThatKeysGoIntoAField) {
    Overlay overlay = need(Overlay::create(device()));
    ecs::Registry registry;
    scene::registerComponents(registry);
    ScenePanel panel(registry);
    ecs::World world = need(scene::builtinScene("cornell"));
    ecs::Entity selected;
    const auto frameWith = [&](bool down) {
        window::Input input;
        input.cursorX = 960;
        input.cursorY = 217;
        input.buttons[0] = down;
        drawScene(overlay, panel, world, selected, input);
    };
    for (int i = 0; i < 3; ++i) frameWith(false);
    EXPECT_FALSE(overlay.typing());
    frameWith(true);
    for (int i = 0; i < 3; ++i) frameWith(false);
    EXPECT_TRUE(overlay.typing()) << "before the next frame begins, too";
    overlay.show(false);
    EXPECT_FALSE(overlay.typing());
}

TEST_F(OverlayNodes, KeepsWhatWasTypedWhereAFieldIsLeftForAnotherEntity) {
    Overlay overlay = need(Overlay::create(device()));
    ecs::Registry registry;
    scene::registerComponents(registry);
    ScenePanel panel(registry);
    ecs::World world;
    const ecs::Entity other = world.create();
    world.add(other, scene::Name{"other"});
    const ecs::Entity named = world.create();
    world.add(named, scene::Name{"lamp"});
    ecs::Entity selected = named;
    const auto frameWith = [&](double x, double y, bool down, const std::u32string& typed = {}) {
        window::Input input;
        input.cursorX = x;
        input.cursorY = y;
        input.buttons[0] = down;
        input.typed = typed;
        drawScene(overlay, panel, world, selected, input);
    };
    const auto clickAt = [&](double x, double y) {
        for (const bool down : {false, false, true, true, false, false}) frameWith(x, y, down);
    };
    // The one field under the tree.
    double y = 490.0;
    for (; y < 600.0 && !overlay.typing(); y += 4.0) clickAt(960.0, y);
    ASSERT_TRUE(overlay.typing());
    frameWith(960.0, y, false, U"!");
    frameWith(960.0, y, false);
    EXPECT_EQ(world.get<scene::Name>(named).value, "lamp") << "half written";
    for (double row = 240.0; row < 330.0 && selected != other; row += 4.0) clickAt(960.0, row);
    EXPECT_EQ(selected, other);
    EXPECT_NE(world.get<scene::Name>(named).value.find('!'), std::string::npos);
    EXPECT_EQ(world.get<scene::Name>(other).value, "other");
}

TEST_F(OverlayNodes, LooksAtAnImageWithItsRangeAndHistogram) {
    ImageLook look = need(ImageLook::create(device()));
    look.choice.name = "shown";
    look.choice.encode = false;
    look.choice.cursor = {3, 4};
    core::Image seen;
    for (int i = 0; i < 3; ++i) {
        graph::Frame frame;
        frame.output(ground(frame, {64, 48}, {0.25f, 0.5f, 0.75f, 1.0f}));
        const graph::Image picture = look.addNode(frame);
        ASSERT_TRUE(picture.valid());
        seen = run(frame, picture);
    }
    EXPECT_NEAR(seen.at(5, 5, 0), 0.25f, 0.01f);
    EXPECT_NEAR(seen.at(5, 5, 2), 0.75f, 0.01f);
    const shared::LookFindings* found = look.findings();
    ASSERT_NE(found, nullptr);
    EXPECT_NEAR(found->underCursor.y, 0.5f, 0.01f);
    EXPECT_NEAR(look.range()[0], 0.25f, 0.01f);
    EXPECT_NEAR(look.range()[1], 0.75f, 0.01f);
    uint32_t total = 0;
    for (uint32_t i = 0; i < shared::LOOK_BINS; ++i) total += found->bins[i];
    EXPECT_EQ(total, 64u * 48u) << "every texel's red is in a bin";
    EXPECT_EQ(found->bins[16], 64u * 48u) << "the quarter of the range";
    EXPECT_EQ(found->notFinite, 0u);
}

TEST_F(OverlayNodes, LooksAtWholeNumbersAndNegativeRanges) {
    ImageLook look = need(ImageLook::create(device()));
    look.choice.name = "floats";
    look.choice.channel = 0;
    look.choice.wholeRange = true;
    for (int i = 0; i < 3; ++i) {
        graph::Frame frame;
        auto node = frame.raster("floats", {32, 32});
        const auto image = node.clearedColour(
            0, frame.image("floats", {graph::Format::RGBA32Float, {32, 32}}), {-3.5f, 0, 0, 0});
        node.record({}, [](graph::RasterCommands&) {});
        frame.output(image);
        (void)run(frame, look.addNode(frame));
    }
    EXPECT_EQ(look.range()[0], -3.5f);
    look.choice.name = "numbers";
    look.choice.channel = shared::LOOK_NUMBERED;
    look.choice.cursor = {1, 1};
    for (int i = 0; i < 3; ++i) {
        graph::Frame frame;
        auto node = frame.raster("numbers", {32, 32});
        const auto image = node.clearedColourUint(
            0, frame.image("numbers", {graph::Format::R32Uint, {32, 32}}), 7);
        node.record({}, [](graph::RasterCommands&) {});
        frame.output(image);
        (void)run(frame, look.addNode(frame));
    }
    EXPECT_EQ(look.findings()->bitsUnderCursor.x, 7u);
}

TEST_F(OverlayNodes, LooksAtNothingThatIsNotThere) {
    ImageLook look = need(ImageLook::create(device()));
    look.choice.name = "no such image";
    graph::Frame frame;
    frame.output(ground(frame));
    EXPECT_FALSE(look.addNode(frame).valid());
    EXPECT_EQ(look.findings(), nullptr);
}

/// Cornell with marks over black; what differs from the frame without them.
class Marks : public test::FrameTest {
 protected:
    Marks() : renderer_(device(), snapshot_) {}

    core::Image draw(const MarkChoice& choice, photon_gi::Settings settings = {}) {
        photon_gi::FrameRequest request;
        request.size = {320, 180};
        request.settings = settings;
        request.camera = snapshot_.cameras.front();
        for (int attempt = 0; attempt < 8; ++attempt) {
            graph::Frame frame;
            const auto drawn = need(renderer_.declare(frame, request));
            const auto marked =
                addMarks(frame, drawn.insides, choice, ground(frame, request.size, {0, 0, 0, 1}));
            frame.output(marked);
            frame.publish("marked", marked);
            auto outcome = need(renderer_.run(frame, drawn, "marked"));
            report_ = outcome.report;
            if (report_.valid) return std::move(outcome.image);
        }
        throw std::runtime_error("no frame was whole");
    }
    static size_t lit(const core::Image& image, float least = 0.0f) {
        size_t count = 0;
        for (size_t i = 0; i < image.values.size(); i += 4)
            count += std::max({image.values[i], image.values[i + 1], image.values[i + 2]}) > least
                         ? 1
                         : 0;
        return count;
    }

    scene::SceneSnapshot snapshot_ = test::builtinSnapshot("cornell");
    test::SceneRenderer renderer_;
    photon_gi::FrameReport report_;
};

TEST_F(Marks, DrawNothingUnlessAsked) {
    EXPECT_EQ(lit(draw({})), 0u);
}

TEST_F(Marks, ShowEveryPhotonAsAFewPixels) {
    MarkChoice choice;
    choice.photons = true;
    choice.colouring = Colouring::Bounce;
    choice.radiusPixels = 0.5f;
    choice.throughWalls = true;
    const size_t open = lit(draw(choice));
    // A pixel each, less those that share one.
    EXPECT_GT(open, report_.counters.photonsStored / 4);
    EXPECT_LE(open, report_.counters.photonsStored);
    choice.throughWalls = false;
    const size_t hidden = lit(draw(choice));
    EXPECT_LT(hidden, open) << "those behind the boxes";
    EXPECT_GT(hidden, open / 2) << "most lie on what is seen, and are not hidden by it";
}

TEST_F(Marks, ShowPathsAsLinesBetweenPhotons) {
    MarkChoice choice;
    choice.paths = true;
    choice.colouring = Colouring::Bounce;
    choice.throughWalls = true;
    const size_t paths = lit(draw(choice));
    EXPECT_GT(paths, 320u * 180u / 8);
    photon_gi::Settings one;
    one.maxBounces = 1;
    EXPECT_EQ(lit(draw(choice, one)), 0u) << "with one bounce a path leaves one photon";
}

TEST_F(Marks, ShowTheBoxesOfALevel) {
    MarkChoice choice;
    choice.boxes = true;
    choice.throughWalls = true;
    choice.boxLevel = 1;
    const size_t coarse = lit(draw(choice));
    choice.boxLevel = 3;
    const size_t fine = lit(draw(choice));
    EXPECT_GT(coarse, 300u) << "lines across the picture";
    EXPECT_LT(coarse, 320u * 180u / 4);
    EXPECT_GT(fine, 0u);
    choice.boxLevel = kMostBoxLevel;
    EXPECT_EQ(lit(draw(choice)), 0u) << "34 triangles have no tree so deep";
}

TEST_F(Marks, ShowPhotonsATileAndFramesInTheMean) {
    MarkChoice choice;
    choice.heat = Heat::Tiles;
    choice.heatMost = 1.0f;
    choice.heatOpacity = 1.0f;
    photon_gi::Settings tiles;
    tiles.gather = photon_gi::Gather::Tiles;
    tiles.history = 0;
    const core::Image image = draw(choice, tiles);
    EXPECT_EQ(image.at(160, 90, 0), 1.0f) << "photons reach the middle of the box";
    EXPECT_EQ(image.at(2, 90, 0), 0.0f) << "and not what lies beside it";
    choice.heat = Heat::History;
    choice.heatMost = 32.0f;
    (void)draw(choice);
    const float first = draw(choice).at(160, 90, 0);
    float last = first;
    for (int i = 0; i < 4; ++i) last = draw(choice).at(160, 90, 0);
    EXPECT_GT(last, first) << "the mean grows while nothing moves";
}

}  // namespace
}  // namespace lampyris::overlay
