// `lampyris view` on a display of its own: it shows frames, and ends with 0 when the user ends it.
#include <algorithm>
#include <fstream>

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

TEST_F(View, InfoTellsOfTheDisplay) {
    const Ran with = run({"env", display_, programPath(), "info"});
    EXPECT_NE(with.out.find("display: screen, 1360x800"), std::string::npos) << with.out;
    const Ran without =
        run({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", programPath(), "info"});
    EXPECT_NE(without.out.find("display: none, no display"), std::string::npos) << without.out;
    EXPECT_EQ(without.code, 0);
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
        {"--size", "64x36", "--frames", "93", "--validation", "--flicker", folder / "a.csv"});
    const Ran ran = view->wait(kViewSeconds);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("over 5 frames; no change was followed"), std::string::npos) << ran.out;
    const std::string csv = textOf(folder / "a.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 94);
    EXPECT_NE(csv.find("\n92,92,"), std::string::npos) << "the last frames too";
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

TEST_F(View, GivesUpWhatABudgetDoesNotAllow) {
    const auto view = startView({"--size", "64x36", "--retrace", "all", "--budget-ms", "0.01"});
    EXPECT_TRUE(eventually([&] {
        const std::string title = ask({"search", "--name", "lampyris", "getwindowname"});
        return title.find(" instead of 2500") != std::string::npos &&
               title.find("out of reach") != std::string::npos;
    }));
    ask({"search", "--name", "lampyris", "windowfocus", "--sync", "key", "Escape"});
    expectQuietEnd(*view);
}

TEST_F(View, ReloadsShadersAndSaysWhatIsBroken) {
    const ScratchFolder folder;
    std::filesystem::copy(LAMPYRIS_SOURCE_DIR "/shaders", folder / "shaders",
                          std::filesystem::copy_options::recursive);
    const auto view = startView({"--size", "64x36", "--shaders", folder / "shaders"});
    ASSERT_TRUE(showsFrames(*view));
    const std::string text = textOf(folder / "shaders/photon_gi/composite.comp");
    const auto write = [&](const std::string& more) {
        std::ofstream(folder / "shaders/photon_gi/composite.comp") << text << more;
    };
    const auto says = [&](const std::string& what) {
        return eventually([&] { return view->errorsSoFar().find(what) != std::string::npos; });
    };
    const auto line = std::count(text.begin(), text.end(), '\n') + 1;
    write("int broken = ;\n");
    EXPECT_TRUE(says("photon_gi/composite.comp stays as it was: photon_gi/composite.comp:" +
                     std::to_string(line) + ": "));
    EXPECT_TRUE(view->running());
    write("// mended\n");
    EXPECT_TRUE(says("photon_gi/composite.comp reloaded in "));
    ask({"search", "--name", "lampyris", "windowfocus", "--sync", "key", "Escape"});
    EXPECT_EQ(view->wait(kViewSeconds).code, 0);
}

TEST_F(View, TakesShadersThatAreNotWatched) {
    const auto view = startView({"--size", "64x36", "--frames", "2", "--shaders", "off"});
    expectQuietEnd(*view);
}

TEST(ViewWithoutADisplay, NamesAFolderOfShadersThatIsNotThere) {
    expectFailure(lampyris({"view", "cornell", "--shaders", "no/such/folder"}), "no/such/folder");
}

TEST(ViewWithoutADisplay, SaysSo) {
    const Ran ran = run({"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", programPath(), "view"});
    expectFailure(ran, "no display");
}

}  // namespace
}  // namespace lampyris::test
