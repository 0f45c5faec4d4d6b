// The timing panel's history: the budget's line lies where the plot has that value.
#include "overlay/timing_panel.h"

#include <algorithm>

#include "overlay/overlay.h"
#include "support/frame_test.h"

namespace lampyris::overlay {
namespace {

using test::need;

constexpr graph::Extent kSize{640, 360};
constexpr uint32_t kColumn = 400;  // pixels; a part of the plot in which nothing else is written

class TimingPanelTest : public test::FrameTest {
 protected:
    TimingPanelTest() : executor_(need(execute::Executor::create(device()))) {}

    /// Of frames of 1 ms, behind one of 10 ms.
    core::Image draw(float budgetMilliseconds) {
        Overlay overlay = need(Overlay::create(device()));
        TimingPanel panel;
        panel.budgetMilliseconds = budgetMilliseconds;
        for (int i = 0; i < 20; ++i) {
            execute::FrameStatistics statistics;
            statistics.gpuMilliseconds = i == 0 ? 10.0 : 1.0;
            panel.add(statistics, 0.1);
        }
        core::Image image;
        for (int i = 0; i < 3; ++i) {  // ImGui finds its layout in the first frames
            graph::Frame frame;
            overlay.begin({}, kSize, kSize, 0.1);
            bool open = true;
            panel.draw(&open);
            auto node = frame.raster("ground", kSize);
            auto shown = node.clearedColour(
                0, frame.image("shown", {graph::Format::RGBA8Unorm, kSize}), {0, 0, 0, 1});
            node.record({}, [](graph::RasterCommands&) {});
            shown = overlay.addNode(frame, shown);
            frame.output(shown);
            execute::RunOptions options;
            options.readBackImages = {shown};
            image = execute::toImage(need(executor_.run(frame, options)).images.front());
        }
        return image;
    }

    execute::Executor executor_;
};

TEST_F(TimingPanelTest, DrawsTheBudgetWhereThePlotHasItsValue) {
    const core::Image over = draw(1.0f);
    uint32_t line = 0;
    float reddest = 0.0f;
    for (uint32_t y = 0; y < kSize.height; ++y) {
        const float red = over.at(kColumn, y, 0) - over.at(kColumn, y, 2);
        if (red > reddest) line = y;
        reddest = std::max(reddest, red);
    }
    ASSERT_GT(reddest, 0.2f) << "the budget's line";
    const core::Image apart = draw(0.1f);
    const auto grey = [&](uint32_t y) {
        return std::min(
            {apart.at(kColumn, y, 0), apart.at(kColumn, y, 1), apart.at(kColumn, y, 2)});
    };
    EXPECT_GT(grey(line), 0.25f) << "1 ms of the plot, where the line no longer covers it";
}

}  // namespace
}  // namespace lampyris::overlay
