#include "flicker/watch.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "flicker/call.h"

namespace lampyris::sandbox::flicker {
namespace {

core::DisplayImage grey(int value, uint32_t width = 12, uint32_t height = 12) {
    return {width, height,
            std::vector<uint8_t>(size_t{width} * height * 3, static_cast<uint8_t>(value))};
}

struct Player {
    Watched watched;
    Shown shown{1, glm::mat4(1.0f), {12, 12}};
    void show(int value) { EXPECT_TRUE(watched.add(shown, grey(value)).ok()); }
};

TEST(Watched, MeasuresWhatIsStill) {
    Player p;
    for (uint32_t i = 0; i < kSettled; ++i) p.show(200);
    for (int i = 0; i < 10; ++i) p.show(i % 2 == 0 ? 97 : 103);
    EXPECT_NE(p.watched.summary().find("static 3.000, p99 3.00 over 10 frames"), std::string::npos)
        << p.watched.summary();
    EXPECT_TRUE(p.watched.csv().starts_with("frame,since_change,change\n0,0,0\n1,1,0\n"));
    EXPECT_TRUE(p.watched.csv().ends_with(fmt::format("{0},{0},6\n", kSettled + 9)));
}

TEST(Watched, SaysThatNothingWasStill) {
    Player p;
    p.show(1);
    EXPECT_NE(p.watched.summary().find("nothing was still"), std::string::npos);
}

TEST(Watched, CountsLagFromTheLastChangeOfTheScene) {
    Player p;
    for (int i = 0; i < 50; ++i) p.show(200);
    ++p.shown.sceneVersion;
    for (int i = 0; i < 5; ++i) p.show(150);
    ++p.shown.sceneVersion;
    p.show(150);  // frame 1 after the last change
    p.show(100);
    for (int i = 0; i < 100; ++i) p.show(20);
    EXPECT_NE(p.watched.summary().find("lag 3 frames (flicker leaves 0.0 % of the change)"),
              std::string::npos)
        << p.watched.summary();
    EXPECT_NE(p.watched.summary().find("static 0.000"), std::string::npos);
    EXPECT_NE(p.watched.csv().find("50,0,50\n"), std::string::npos);
}

TEST(Watched, FollowsNoChangeThatTheCameraMovesThrough) {
    Player p;
    p.show(200);
    ++p.shown.sceneVersion;
    p.show(100);
    p.shown.cameraToWorld[3].x = 1.0f;
    for (int i = 0; i < 100; ++i) p.show(50);
    EXPECT_NE(p.watched.summary().find("no change was followed"), std::string::npos);
}

TEST(Watched, FollowsAnotherSize) {
    Player p;
    p.show(200);
    p.shown.size = {8, 9};
    EXPECT_TRUE(p.watched.add(p.shown, grey(3, 8, 9)).ok());
    EXPECT_TRUE(p.watched.csv().ends_with("1,0,0\n"));
}

}  // namespace
}  // namespace lampyris::sandbox::flicker
