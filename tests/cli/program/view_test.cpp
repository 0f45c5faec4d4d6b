// `lampyris view` on a display of its own: it shows frames, and ends with 0 when the user ends it.
#include "cli/program/view_fixture.h"

namespace lampyris::test {
namespace {

TEST_F(View, EndsWithEscape) {
    const auto view = startView();
    ASSERT_TRUE(showsFrames(*view));
    ask({"search", "--name", "lampyris", "windowfocus", "--sync", "key", "Escape"});
    expectQuietEnd(*view);
}

TEST_F(View, EndsWithTheWindowManagersClose) {
    const auto manager = startManager();
    const auto view = startView();
    ASSERT_TRUE(showsFrames(*view));
    // What the close button does, by the manager's key for it.
    ASSERT_TRUE(eventually([&] {
        ask({"search", "--name", "lampyris", "windowactivate"});
        return !ask({"getactivewindow"}).empty();
    }));
    ask({"key", "alt+F4"});
    expectQuietEnd(*view);
}

TEST_F(View, EndsAfterTheFramesAskedFor) {
    const ScratchFolder folder;
    const auto view = startView({"--size", "160x90", "--frames", "3", "--warmup", "1",
                                 "--validation", "--report", folder / "a.json"});
    expectQuietEnd(*view);
    const auto report = jsonOf(folder / "a.json");
    EXPECT_EQ(report["frames"], 3);
    EXPECT_EQ(report["validation_messages"], 0);
}

TEST_F(View, MeasuresFlickerOfWhatItShows) {
    const ScratchFolder folder;
    const auto view = startView(
        {"--size", "64x36", "--frames", "45", "--validation", "--flicker", folder / "a.csv"});
    const Ran ran = view->wait(kViewSeconds);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("over 5 frames; no change was followed"), std::string::npos) << ran.out;
    const std::string csv = textOf(folder / "a.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 46);
    EXPECT_NE(csv.find("\n44,44,"), std::string::npos) << "the last frames too";
}

TEST_F(View, MarksAFrameThatOverflowedAndDrawsTheNextOneRight) {
    // Every photon reaches every tile: the first guess is too small.
    const ScratchFolder folder;
    const auto view =
        startView({"--gather", "tiles", "--radius", "100", "--gather-divisor", "8", "--photons",
                   "300", "--size", "640x360", "--frames", "3", "--report", folder / "a.json"});
    bool marked = false;
    EXPECT_TRUE(eventually([&] {
        marked =
            marked || ask({"search", "--name", "INVALID FRAME", "getwindowname"}).find("dropped") !=
                          std::string::npos;
        return marked || !view->running();
    }));
    expectQuietEnd(*view);
    const auto report = jsonOf(folder / "a.json");
    EXPECT_TRUE(report["valid"].get<bool>());
    EXPECT_EQ(report["frames"], 2) << "the one that overflowed is no measurement";
}

TEST(ViewWithoutADisplay, SaysSo) {
    const Ran ran = run({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", programPath(), "view"});
    expectFailure(ran, "no display");
}

}  // namespace
}  // namespace lampyris::test
