// Images that are looked at: which of a name, and what is counted of it.
#include "overlay/image_look.h"

#include <limits>

#include "support/frame_test.h"

namespace lampyris::overlay {
namespace {

using test::need;

class ImageLooks : public test::FrameTest {
 protected:
    ImageLooks() : executor_(need(execute::Executor::create(device()))) {}

    void run(graph::Frame& frame, graph::Image shown) {
        frame.output(shown);
        (void)need(executor_.run(frame));
    }

    execute::Executor executor_;
};

TEST_F(ImageLooks, LooksAtWhatHistoryBringsWhereNothingIsTakenAlong) {
    ImageLook look = need(ImageLook::create(device()));
    look.choice.name = "kept floats";
    look.choice.channel = 0;
    constexpr graph::ImageDesc kDesc{graph::Format::RGBA32Float, {32, 32}};
    for (int i = 0; i < 3; ++i) {
        graph::Frame frame;
        const auto past = frame.history("kept floats", kDesc, i > 0);
        if (i == 0) {
            auto node = frame.raster("floats", kDesc.extent);
            (void)node.clearedColour(0, past.current, {0.75f, 0, 0, 0});
            node.record({}, [](graph::RasterCommands&) {});
        }
        const graph::Image picture = look.addNode(frame);
        ASSERT_TRUE(picture.valid());
        run(frame, picture);
    }
    EXPECT_EQ(look.range()[0], 0.75f);
    EXPECT_EQ(look.range()[1], 0.75f);
}

TEST_F(ImageLooks, CountsChannelsThatAnImageHasAlone) {
    ImageLook look = need(ImageLook::create(device()));
    look.choice.name = "one channel";
    for (int i = 0; i < 3; ++i) {
        graph::Frame frame;
        auto node = frame.raster("one channel", {32, 32});
        const auto image = node.clearedColour(
            0, frame.image("one channel", {graph::Format::R32Float, {32, 32}}), {5.0f, 0, 0, 0});
        node.record({}, [](graph::RasterCommands&) {});
        frame.output(image);
        run(frame, look.addNode(frame));
    }
    EXPECT_EQ(look.range()[0], 5.0f) << "absent green is no zero";
    EXPECT_EQ(look.range()[1], 5.0f);
    uint32_t total = 0;
    for (const uint32_t count : look.findings()->bins) total += count;
    EXPECT_EQ(total, 32u * 32u);
}

TEST_F(ImageLooks, CountsEveryTexelOfImagesThatAreShownInSteps) {
    constexpr graph::Extent kWide{1283, 21};
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    ImageLook look = need(ImageLook::create(device()));
    look.choice.name = "wide";
    look.choice.channel = 0;
    for (int i = 0; i < 3; ++i) {
        graph::Frame frame;
        auto node = frame.raster("wide", kWide);
        const auto image = node.clearedColour(
            0, frame.image("wide", {graph::Format::RGBA32Float, kWide}), {0.5f, kNan, 0, 0});
        node.record({}, [](graph::RasterCommands&) {});
        frame.output(image);
        run(frame, look.addNode(frame));
    }
    const shared::LookFindings* found = look.findings();
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->bins[32], 1283u * 21u) << "half of the range";
    EXPECT_EQ(found->notFinite, 1283u * 21u);
}

}  // namespace
}  // namespace lampyris::overlay
