#include "overlay/timing_panel.h"

#include <gtest/gtest.h>

namespace lampyris::overlay {
namespace {

TEST(TimingPanel, KeepsFramesOfOneSettingAndSize) {
    TimingPanel panel;
    const execute::FrameStatistics frame;
    TimedWith with{{}, {640, 360}};
    for (int i = 0; i < 3; ++i) panel.add(frame, 5.0, with);
    EXPECT_EQ(panel.times().frames().size(), 3u);
    with.settings.photonPaths += 1;
    panel.add(frame, 1.0, with);
    EXPECT_EQ(panel.times().frames().size(), 1u);
    EXPECT_EQ(panel.overlayMilliseconds(), 1.0f);
    panel.add(frame, 1.0, with);
    with.size = {320, 180};
    panel.add(frame, 1.0, with);
    EXPECT_EQ(panel.times().frames().size(), 1u);
}

}  // namespace
}  // namespace lampyris::overlay
