// The graph panel knows a node by its name: frames may have other nodes before it.
#include "overlay/graph_panel.h"

#include "support/overlay_test.h"

namespace lampyris::overlay {
namespace {

constexpr graph::Extent kSize{1280, 720};

class GraphPanelTest : public test::OverlayTest {
 protected:
    static void addNode(graph::Frame& frame, const char* name) {
        auto node = frame.raster(name, {8, 8});
        frame.output(node.clearedColour(0, frame.image(name, {graph::Format::RGBA8Unorm, {8, 8}}),
                                        {0, 0, 0, 1}));
        node.record({}, [](graph::RasterCommands&) {});
    }
    /// A frame of the panel over a graph of those nodes, with the mouse there.
    void point(const std::vector<const char*>& nodes, double y, bool down) {
        graph::Frame frame;
        for (const char* name : nodes) addNode(frame, name);
        const auto compiled = test::need(graph::compile(frame, {}));
        const FrameSeen seen{{}, frame, compiled, {}, {}, {}, kSize};
        window::Input input;
        input.cursorX = 850.0;  // right of the tabs
        input.cursorY = y;
        input.buttons[0] = down;
        overlay_->begin(input, kSize, kSize, 0.1);
        bool open = true;
        panel_.draw(seen, choice_, &open);
        overlay_->end();
    }

    /// Opens the uppermost node, and says where it stands.
    double openFirst() {
        for (int i = 0; i < 3; ++i) point(kFew, 600.0, false);
        for (int y = 120; y < 300; y += 4) {
            for (const bool down : {false, true, false}) point(kFew, y, down);
            if (panel_.opened()) return y;
        }
        ADD_FAILURE() << "no node can be opened";
        return 0.0;
    }

    const std::vector<const char*> kFew{"first", "second", "second"};
    const std::vector<const char*> kMore{"before", "first", "second", "second"};
    GraphPanel panel_;
    LookChoice choice_;
};

TEST_F(GraphPanelTest, TheOpenedNodeStaysWhereStepsComeAndGo) {
    (void)openFirst();
    EXPECT_EQ(panel_.opened(), (NodeName{"first", 0}));
    for (int i = 0; i < 3; ++i) point(kMore, 600.0, false);
    EXPECT_EQ(panel_.opened(), (NodeName{"first", 0}));
}

TEST_F(GraphPanelTest, APressAndItsReleaseMayLieInDifferingFrames) {
    constexpr double kRow = 16.0;  // pixels: a line and what lies between two
    const double y = openFirst();
    for (const bool down : {false, true, false}) point(kFew, y, down);
    ASSERT_FALSE(panel_.opened());
    point(kFew, y, true);
    point(kMore, y + kRow, true);
    point(kMore, y + kRow, false);
    EXPECT_EQ(panel_.opened(), (NodeName{"first", 0}));
}

}  // namespace
}  // namespace lampyris::overlay
