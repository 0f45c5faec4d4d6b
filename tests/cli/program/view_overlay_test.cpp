// `lampyris view` as a user meets it: panels, keys and mouse, a window that is pulled about, what
// it records.
#include <algorithm>

#include "cli/program/view_fixture.h"

namespace lampyris::test {
namespace {

class ViewOverlay : public View {
 protected:
    void focus() const {
        (void)ask({"search", "--name", "lampyris: cornell", "windowfocus", "--sync"});
    }
    void press(const std::string& key) const { (void)ask({"key", key}); }
    void click(int x, int y) const {
        (void)ask({"mousemove", std::to_string(x), std::to_string(y), "click", "1"});
    }
    /// The green axis of what is picked, half way up, near x.
    [[nodiscard]] bool showsUpwardHandle(uint32_t x) const {
        const ScreenFile now = screen();
        for (uint32_t i = x - 4; i <= x + 4; ++i) {
            const auto [red, green, blue] = now.pixel(i, 130);
            if (green > red + 50 && green > blue + 50) return true;
        }
        return false;
    }
    /// A click is taken in by the next frame, and its outcome stands in the one after it.
    [[nodiscard]] bool changes(const ScreenFile& before, uint32_t x0, uint32_t y0, uint32_t x1,
                               uint32_t y1, size_t least) const {
        return eventually([&] { return screen().differing(before, x0, y0, x1, y1) >= least; });
    }
};

// The whole picture is known while nothing moves: it is shown again until something is asked for.
TEST_F(ViewOverlay, OpensEveryPanelFromTheMenu) {
    const auto view = startView({"--size", "1280x720", "--pipeline", "direct"});
    ASSERT_TRUE(showsFrames(*view));
    focus();
    struct Panel {
        const char* name;
        int menuY;
        uint32_t x, y, width, height;  // a part of where it comes to lie, free of others
    };
    for (const Panel& panel :
         {Panel{"Graph", 46, 450, 130, 400, 90}, Panel{"Photons", 63, 70, 560, 300, 100},
          Panel{"Truth", 80, 900, 60, 300, 100}, Panel{"Scene", 97, 900, 600, 300, 100},
          Panel{"Settings", 114, 420, 620, 400, 80}}) {
        const ScreenFile before = screen();
        click(24, 9);
        EXPECT_TRUE(changes(before, 10, 20, 120, 110, 2000)) << "the menu, for " << panel.name;
        click(40, panel.menuY);
        EXPECT_TRUE(changes(before, panel.x, panel.y, panel.x + panel.width, panel.y + panel.height,
                            panel.width * panel.height / 3))
            << panel.name;
    }
    // Hidden, all of it is gone.
    const ScreenFile open = screen();
    press("F1");
    EXPECT_TRUE(changes(open, 0, 0, 1280, 720, 400000));
    press("Escape");
    expectQuietEnd(*view);
}

TEST_F(ViewOverlay, PicksAndMovesWhatIsPointedAt) {
    ASSERT_TRUE(
        core::writeFile(folder_ / "a.json", std::string(R"({"panels":{"timing":false}})")).ok());
    const auto view =
        startView({"--size", "640x360", "--pipeline", "direct", "--settings", folder_ / "a.json"});
    ASSERT_TRUE(showsFrames(*view));
    focus();
    press("l");  // a light, picked; its handles stand in the middle
    ASSERT_TRUE(eventually([&] { return showsUpwardHandle(320); }));
    // Dragged to the right along the red one.
    (void)ask({"mousemove", "380", "180"});
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    (void)ask({"mousedown", "1"});
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    (void)ask({"mousemove", "430", "180"});
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    (void)ask({"mouseup", "1"});
    EXPECT_TRUE(eventually([&] { return showsUpwardHandle(370); })) << "it went with the red one";
    press("Delete");
    EXPECT_TRUE(eventually([&] { return !showsUpwardHandle(370); }));
    press("Escape");
    expectQuietEnd(*view);
}

TEST_F(ViewOverlay, ReplaysWhatWasRecordedToTheByte) {
    const std::filesystem::path first = folder_ / "first";
    const std::filesystem::path second = folder_ / "second";
    std::filesystem::create_directories(first);
    std::filesystem::create_directories(second);
    const auto shots = [](const std::filesystem::path& folder) {
        std::vector<std::string> names;
        for (const auto& file : std::filesystem::directory_iterator(folder))
            names.push_back(file.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    };
    const auto view = startView({"--size", "320x180", "--record", folder_ / "log", "--screenshots",
                                 first.string(), "--exposure", "-1"});
    ASSERT_TRUE(showsFrames(*view));
    focus();
    (void)ask({"keydown", "w"});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    (void)ask({"keyup", "w"});
    click(200, 150);
    press("b");
    press("l");
    press("F12");
    ASSERT_TRUE(eventually([&] { return shots(first).size() == 1; }));
    press("bracketright");
    press("space");
    press("F12");
    ASSERT_TRUE(eventually([&] { return shots(first).size() == 2; }));
    press("Escape");
    expectQuietEnd(*view);
    const auto again = startView({"--replay", folder_ / "log", "--screenshots", second.string()});
    expectQuietEnd(*again);
    ASSERT_EQ(shots(second), shots(first));
    for (const std::string& name : shots(first))
        EXPECT_EQ(textOf(first / name), textOf(second / name)) << name;
    EXPECT_NE(textOf(first / shots(first)[0]), "");
}

TEST_F(ViewOverlay, SurvivesAStormOfSizes) {
    const auto view = startView({"--size", "200x120", "--validation", "--pipeline", "direct",
                                 "--report", folder_ / "a.json"});
    ASSERT_TRUE(showsFrames(*view));
    for (int i = 0; i < 40; ++i)
        (void)ask({"search", "--name", "lampyris: cornell", "windowsize",
                   std::to_string(1 + i * 37 % 400), std::to_string(1 + i * 53 % 300)});
    (void)ask({"search", "--name", "lampyris: cornell", "windowsize", "160", "90"});
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ASSERT_TRUE(showsFrames(*view));
    focus();
    press("Escape");
    expectQuietEnd(*view);
    const auto report = jsonOf(folder_ / "a.json");
    EXPECT_EQ(report["validation_messages"], 0);
    EXPECT_EQ(report["size"], (nlohmann::json{160, 90}));
}

TEST_F(ViewOverlay, ComesBackFromTheTaskBarAndFromFullScreen) {
    const auto manager = startManager();
    const auto view = startView({"--size", "200x120", "--pipeline", "direct"});
    ASSERT_TRUE(showsFrames(*view));
    (void)ask({"search", "--name", "lampyris: cornell", "windowminimize", "--sync"});
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    EXPECT_TRUE(view->running());
    ASSERT_TRUE(eventually([&] {
        (void)ask({"search", "--name", "lampyris: cornell", "windowmap", "windowactivate"});
        return !ask({"getactivewindow"}).empty();
    }));
    const auto geometry = [&] {
        return ask({"search", "--name", "lampyris: cornell", "getwindowgeometry"});
    };
    press("F11");
    EXPECT_TRUE(eventually([&] { return geometry().find("1360x800") != std::string::npos; }));
    press("F11");
    EXPECT_TRUE(eventually([&] { return geometry().find("200x120") != std::string::npos; }));
    press("Escape");
    expectQuietEnd(*view);
}

TEST_F(ViewOverlay, KeepsTheSizeOfItsWindowWhereItEndsInFullScreen) {
    const auto manager = startManager();
    const std::string file = folder_ / "a.json";
    const auto view = startView({"--size", "200x120", "--pipeline", "direct", "--settings", file});
    ASSERT_TRUE(showsFrames(*view));
    (void)ask({"search", "--name", "lampyris: cornell", "windowactivate", "--sync"});
    press("F11");
    EXPECT_TRUE(eventually([&] {
        return ask({"search", "--name", "lampyris: cornell", "getwindowgeometry"})
                   .find("1360x800") != std::string::npos;
    }));
    press("Escape");
    expectQuietEnd(*view);
    EXPECT_EQ(jsonOf(file)["full_screen"], true);
    EXPECT_EQ(jsonOf(file)["size"], (nlohmann::json{200, 120}));
}

TEST_F(ViewOverlay, KeepsItsSettingsWhereTheRecordHasNoPlaceAnyMore) {
    std::filesystem::create_directories(folder_ / "gone");
    const std::string file = folder_ / "a.json";
    const auto view = startView({"--size", "64x36", "--pipeline", "direct", "--settings", file,
                                 "--record", folder_ / "gone/log"});
    ASSERT_TRUE(showsFrames(*view));
    std::filesystem::remove_all(folder_ / "gone");
    focus();
    press("Escape");
    expectFailure(view->wait(kViewSeconds), "gone/log");
    EXPECT_TRUE(jsonOf(file).contains("settings"));
}

TEST_F(ViewOverlay, GetsTimeGoingAgainFromAScaleOfZero) {
    const std::string file = folder_ / "a.json";
    ASSERT_TRUE(core::writeFile(file, std::string(R"({"time_scale":0})")).ok());
    const auto view = startView({"--size", "64x36", "--pipeline", "direct", "--settings", file});
    ASSERT_TRUE(showsFrames(*view));
    focus();
    press("bracketright");
    press("Escape");
    expectQuietEnd(*view);
    EXPECT_EQ(jsonOf(file)["time_scale"], 0.03125);
}

TEST_F(ViewOverlay, EndsWhereItIsClosedWhileItLoads) {
    const std::string file = folder_ / "a.json";
    const auto view =
        start({programPath(), "view", "cornell_statue", "--size", "160x90", "--settings", file});
    ASSERT_TRUE(eventually([&] {
        return !ask({"search", "--name", "lampyris: cornell_statue"}).empty();
    }));
    (void)ask({"search", "--name", "lampyris: cornell_statue", "windowfocus", "key", "Escape"});
    expectQuietEnd(*view);
    // No frame may have been drawn, so there may be no size to keep; never one of no window.
    const nlohmann::json drawn{160, 90};
    EXPECT_EQ(jsonOf(file).value("size", drawn), drawn);
}

TEST_F(ViewOverlay, EndsWithOneLineWhereItsDisplayIsLost) {
    const auto view = startView({"--size", "160x90", "--settings", folder_ / "a.json"});
    ASSERT_TRUE(showsFrames(*view));
    server_.reset();
    const Ran ran = view->wait(kViewSeconds);
    EXPECT_EQ(ran.code, 1) << "signal " << ran.signal;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find("the display is lost"), std::string::npos) << ran.err;
    EXPECT_TRUE(jsonOf(folder_ / "a.json").contains("settings")) << "what is to be kept is kept";
}

TEST_F(ViewOverlay, GoesBackFromSettingsThatNoFrameIsDrawnWith) {
    const std::string file = folder_ / "a.json";
    const std::string panels = R"({"panels":{"timing":false,"settings":true}})";
    ASSERT_TRUE(core::writeFile(file, panels).ok());
    const auto view =
        startView({"--size", "1280x720", "--render-scale", "0.1", "--settings", file});
    ASSERT_TRUE(showsFrames(*view));
    focus();
    const ScreenFile before = screen();
    (void)ask({"mousemove", "535", "396", "keydown", "ctrl", "click", "1", "keyup", "ctrl"});
    EXPECT_TRUE(changes(before, 500, 385, 570, 407, 20)) << "the field of photons is typed into";
    (void)ask({"key", "ctrl+a"});
    (void)ask({"type", "4294967295"});
    (void)ask({"key", "Return"});
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    press("Escape");
    const Ran ran = view->wait(kViewSeconds);
    EXPECT_EQ(ran.code, 0);
    EXPECT_NE(ran.err.find("back to the last settings that drew"), std::string::npos) << ran.err;
    EXPECT_EQ(jsonOf(file)["settings"]["photons"], 2500);
}

TEST_F(ViewOverlay, KeepsItsSettingsInAFile) {
    const std::string file = folder_ / "a.json";
    expectQuietEnd(*startView({"--size", "160x90", "--frames", "2", "--photons", "77", "--exposure",
                               "-2", "--settings", file}));
    EXPECT_EQ(jsonOf(file)["settings"]["photons"], 77);
    EXPECT_EQ(jsonOf(file)["exposure"], -2.0);
    EXPECT_EQ(jsonOf(file)["size"], (nlohmann::json{160, 90}));
    expectQuietEnd(*startView({"--frames", "2", "--radius", "0.5", "--settings", file}));
    EXPECT_EQ(jsonOf(file)["settings"]["photons"], 77) << "as it was";
    EXPECT_EQ(jsonOf(file)["settings"]["radius"], 0.5) << "as it was asked for";
    EXPECT_EQ(jsonOf(file)["size"], (nlohmann::json{160, 90}));
    // Defaults that are asked for stand against the file too.
    expectQuietEnd(*startView({"--frames", "2", "--photons", "2500", "--tonemap", "clip",
                               "--no-overlay", "--settings", file}));
    EXPECT_EQ(jsonOf(file)["settings"]["photons"], 2500);
    EXPECT_EQ(jsonOf(file)["settings"]["radius"], 0.5) << "as it was";
    EXPECT_EQ(jsonOf(file)["exposure"], -2.0) << "as it was";
    EXPECT_EQ(jsonOf(file)["overlay"], false);
    expectQuietEnd(*startView({"--frames", "2", "--overlay", "--settings", file}));
    EXPECT_EQ(jsonOf(file)["overlay"], true);
}

TEST_F(ViewOverlay, RefusesFilesThatAreNone) {
    const auto write = [&](const char* name, const std::string& text) {
        EXPECT_TRUE(core::writeFile(folder_ / name, text).ok());
        return (folder_ / name).string();
    };
    const std::string wrong = write("a.json", R"({"settings":{"photons":-1}})");
    const auto view = startView({"--settings", wrong});
    expectFailure(view->wait(kViewSeconds), "a.json: settings.photons");
    EXPECT_EQ(textOf(wrong), R"({"settings":{"photons":-1}})");
    const std::string others = write("package.json", R"({"name":"npm","version":"1.0.0"})");
    const auto packages = startView({"--settings", others});
    expectFailure(packages->wait(kViewSeconds), "package.json: name: there is no such key");
    EXPECT_EQ(textOf(others), R"({"name":"npm","version":"1.0.0"})");
    const std::string head = R"({"lampyris_inputs":2,"state":{"exposure":"dim"}})";
    const std::string moment =
        R"({"seconds":0.1,"window":[64,36],"size":[64,36],"held":[],"pressed":[],"buttons":[],)"
        R"("clicked":[],"typed":[],"cursor":[0,0],"moved":[0,0],"scrolled":0})";
    const auto dim = startView({"--replay", write("dim.log", head + "\n" + moment + "\n")});
    expectFailure(dim->wait(kViewSeconds), "dim.log:1: exposure: \"dim\" is no number");
    const auto replay = startView({"--replay", write("log", "no log")});
    expectFailure(replay->wait(kViewSeconds), "log:1:");
    expectWrongCall(lampyris({"view", "cornell", "--record", "a", "--replay", "b"}), "--replay");
}

}  // namespace
}  // namespace lampyris::test
