// The truth panel: what it shows is of the view that is drawn, and its buttons stand still.
#include "overlay/truth_panel.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "overlay/overlay.h"
#include "support/frame_test.h"

namespace lampyris::overlay {
namespace {

using test::need;

constexpr graph::Extent kWindow{1280, 720};
constexpr graph::Extent kView{64, 36};

class TruthPanelTest : public test::FrameTest {
 protected:
    TruthPanelTest()
        : overlay_(need(Overlay::create(device()))),
          executor_(need(execute::Executor::create(device()))),
          panel_(need(TruthPanel::create(device()))) {
        auto node = frame_.raster("radiance", kView);
        radiance_ =
            node.clearedColour(0, frame_.image("radiance", {graph::Format::RGBA32Float, kView}),
                               {0.5f, 0.5f, 0.5f, 1});
        node.record({}, [](graph::RasterCommands&) {});
        frame_.output(radiance_);
        (void)need(executor_.run(frame_));
    }

    /// A frame with the mouse there, over the panel's left border.
    void point(double y, bool down) {
        graph::Frame frame;
        const graph::CompiledGraph compiled;
        const FrameSeen seen{{}, frame, compiled, {}, {}, {}, kWindow};
        window::Input input;
        input.cursorX = 885.0;
        input.cursorY = y;
        input.buttons[0] = down;
        overlay_.begin(input, kWindow, kWindow, 0.1);
        bool open = true;
        panel_.draw(seen, choice_, &open);
        overlay_.end();
    }
    void click(double y) {
        for (const bool down : {false, false, true, false}) point(y, down);
    }
    /// By its check box, from under the title on.
    double turnOn() {
        for (int y = 56; y < 200; y += 4) {
            click(y);
            if (panel_.on()) return y;
        }
        ADD_FAILURE() << "it cannot be turned on";
        return 0.0;
    }

    /// A frame was drawn, with the camera that far to the right.
    void follow(float metres = 0.0f) {
        scene::SnapshotCamera camera = snapshot_.cameras.front();
        camera.cameraToWorld[3].x += metres;
        need(panel_.follow({snapshot_, camera, kView.width, kView.height}, display_,
                           executor_.outputImage(radiance_), frame_.desc(radiance_)));
    }
    [[nodiscard]] bool shows() {
        LookChoice choice;
        choice.name = kTruthDifference;
        graph::Frame frame;
        panel_.addNode(frame, choice);
        return std::any_of(frame.resources().begin(), frame.resources().end(),
                           [](const auto& resource) { return resource.name == kTruthDifference; });
    }
    [[nodiscard]] bool comesToShow(float metres = 0.0f) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!shows() && std::chrono::steady_clock::now() < end) {
            follow(metres);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return shows();
    }

    scene::SceneSnapshot snapshot_ = test::builtinSnapshot("cornell");
    core::DisplayTransform display_;
    Overlay overlay_;
    execute::Executor executor_;
    graph::Frame frame_;
    graph::Image radiance_;
    TruthPanel panel_;
    LookChoice choice_;
};

TEST_F(TruthPanelTest, ShowsNothingOfAnotherViewOrDisplay) {
    follow();
    EXPECT_FALSE(shows()) << "nobody asked for it";
    (void)turnOn();
    ASSERT_TRUE(comesToShow());
    panel_.rest();
    EXPECT_FALSE(shows()) << "nothing is followed";
    follow();
    EXPECT_TRUE(shows()) << "what was measured stays, for the same view";
    follow(0.5f);
    EXPECT_FALSE(shows());
    ASSERT_TRUE(comesToShow(0.5f));
    display_.exposureEv = 1.0f;
    follow(0.5f);
    EXPECT_FALSE(shows()) << "it was measured with another exposure";
    ASSERT_TRUE(comesToShow(0.5f));
    panel_.switchOff();
    EXPECT_FALSE(shows());
}

TEST_F(TruthPanelTest, ItsButtonsStandStillWhenFiguresCome) {
    const double box = turnOn();
    double y = box + 24.0;
    for (; y < 520.0 && choice_.name.empty(); y += 4.0) click(y);
    ASSERT_EQ(choice_.name, kTruthDifference);
    choice_ = {};
    ASSERT_TRUE(comesToShow());
    click(y - 4.0);
    EXPECT_EQ(choice_.name, kTruthDifference);
}

}  // namespace
}  // namespace lampyris::overlay
