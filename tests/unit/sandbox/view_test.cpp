// What `view` keeps in files, and how its user walks and picks.
#include <gtest/gtest.h>

#include "core/file.h"
#include "fly_camera.h"
#include "overlay/setting_list.h"
#include "scene/builtin/builtin.h"
#include "scene/extract.h"
#include "scene/motion.h"
#include "unit/core/scratch_folder.h"
#include "view/edits.h"
#include "view/frame_rate.h"
#include "view/input_log.h"
#include "view/settings_file.h"
#include "view/walk_camera.h"

namespace lampyris::sandbox::view {
namespace {

using core::ScratchFolder;

Moment aMoment() {
    Moment m;
    m.seconds = 1.0f / 3.0f;
    m.windowSize = {640, 360};
    m.size = {1280, 720};
    m.input.held['W'] = true;
    m.input.pressed[window::kKeyF1 + 11] = true;
    m.input.buttons[2] = m.input.clicked[0] = true;
    m.input.typed = U"aß€";
    m.input.cursorX = 0.1;
    m.input.movedY = -1e-9;
    m.input.scrolled = 2.0;
    return m;
}

TEST(FrameRate, CountsFromFrameToFrameAndLeavesInterruptionsOut) {
    FrameRate rate;
    FrameRate::Clock::time_point now{};
    EXPECT_EQ(rate.summary(), "no two frames followed each other");
    for (int i = 0; i <= 100; ++i) {
        rate.add(now);
        now += std::chrono::milliseconds(i == 99 ? 400 : 10);
    }
    rate.interrupt();
    rate.add(now + std::chrono::seconds(60));
    EXPECT_EQ(rate.summary(),
              "100 frames in 1.4 s, 71.9 a second; median 10.0 ms, 99 % within 10.0, longest "
              "400.0");
}

TEST(InputLog, GivesBackWhatWasRecordedToTheBit) {
    const ScratchFolder folder;
    InputRecorder recorder({"cornell", "close", ""}, R"({"exposure":-1.5})");
    recorder.add(aMoment());
    recorder.add(Moment{{}, 0.5f, {1, 1}, {2, 2}});
    ASSERT_TRUE(recorder.write(folder / "log").ok());
    const auto log = readInputLog(folder / "log", {"cornell", "close", ""});
    ASSERT_TRUE(log.ok()) << log.error().message;
    EXPECT_EQ(log.value().state, R"({"exposure":-1.5})");
    ASSERT_EQ(log.value().moments.size(), 2u);
    const Moment& m = log.value().moments.front();
    const Moment wanted = aMoment();
    EXPECT_EQ(m.seconds, wanted.seconds);
    EXPECT_EQ(m.windowSize, wanted.windowSize);
    EXPECT_EQ(m.size, wanted.size);
    EXPECT_EQ(m.input.held, wanted.input.held);
    EXPECT_EQ(m.input.pressed, wanted.input.pressed);
    EXPECT_EQ(m.input.buttons, wanted.input.buttons);
    EXPECT_EQ(m.input.clicked, wanted.input.clicked);
    EXPECT_EQ(m.input.typed, wanted.input.typed);
    EXPECT_EQ(m.input.cursorX, wanted.input.cursorX);
    EXPECT_EQ(m.input.movedY, wanted.input.movedY);
    EXPECT_EQ(m.input.scrolled, wanted.input.scrolled);
}

TEST(InputLog, NamesWhatIsWrong) {
    const ScratchFolder folder;
    const auto errorOf = [&](const std::string& text) {
        EXPECT_TRUE(core::writeFile(folder / "log", text).ok());
        const auto log = readInputLog(folder / "log", {"cornell", "close", ""});
        return log.ok() ? std::string("none") : log.error().message;
    };
    EXPECT_NE(errorOf("").find("no inputs"), std::string::npos);
    EXPECT_NE(errorOf("{}\n").find("no log of inputs"), std::string::npos);
    EXPECT_NE(errorOf("{\"lampyris_inputs\":2,\"scene\":\"two_rooms\"}\n").find("two_rooms"),
              std::string::npos);
    EXPECT_NE(errorOf("{\"lampyris_inputs\":2,\"scene\":\"cornell\",\"camera\":\"far\"}\n")
                  .find("camera 'far', not 'close'"),
              std::string::npos);
    const std::string head = "{\"lampyris_inputs\":2,\"scene\":\"cornell\",\"camera\":\"close\"}\n";
    EXPECT_NE(errorOf(head + "{}\n").find(":2: is no moment"), std::string::npos);
    EXPECT_NE(errorOf(head + "{\"seconds\":1,\"window\":[0,1]").find(":2:"), std::string::npos);
    EXPECT_FALSE(readInputLog(folder / "none", {"cornell", "close", ""}).ok());
}

TEST(ViewState, ComesBackFromItsFile) {
    const ScratchFolder folder;
    ViewState state;
    state.settings.photonPaths = 777;
    state.settings.radiusMetres = 0.3f;
    state.settings.gather = photon_gi::Gather::Tiles;
    state.settings.guiding = false;
    state.display = {-1.25f, core::Tonemap::Filmic};
    state.panels.truth = true;
    state.panels.timing = false;
    state.overlay = false;
    state.size = graph::Extent{300, 200};
    state.cameraToWorld = glm::translate(glm::mat4(1.0f), glm::vec3(0.1f, 2.0f, -3.7f));
    state.timeScale = 0.5f;
    state.defaults = state.settings;
    state.defaults->photonPaths = 778;
    ASSERT_TRUE(writeState(folder / "a.json", state).ok());
    ViewState back;
    ASSERT_TRUE(readState(folder / "a.json", back).ok());
    EXPECT_EQ(back.settings, state.settings);
    EXPECT_EQ(back.display.exposureEv, -1.25f);
    EXPECT_EQ(back.display.tonemap, core::Tonemap::Filmic);
    EXPECT_TRUE(back.panels.truth);
    EXPECT_FALSE(back.panels.timing);
    EXPECT_FALSE(back.overlay);
    EXPECT_EQ(back.size, state.size);
    EXPECT_EQ(back.cameraToWorld, state.cameraToWorld);
    EXPECT_EQ(back.timeScale, 0.5f);
    EXPECT_EQ(back.defaults, state.defaults);
}

TEST(ViewState, ComesBackAtBothEndsOfEverySetting) {
    const ScratchFolder folder;
    for (const overlay::SettingInfo& info : overlay::settingList())
        for (const double end : {info.least, info.most}) {
            ViewState state;
            std::visit(
                [&](auto field) {
                    using T = std::remove_reference_t<decltype(state.settings.*field)>;
                    if constexpr (std::is_same_v<T, float> || std::is_same_v<T, uint32_t>)
                        state.settings.*field = static_cast<T>(end);
                },
                info.field);
            ASSERT_TRUE(writeState(folder / "a.json", state).ok());
            ViewState back;
            const auto read = readState(folder / "a.json", back);
            EXPECT_TRUE(read.ok()) << info.name << ": " << read.error().message;
            EXPECT_EQ(back.settings, state.settings) << info.name;
        }
}

TEST(ViewState, IsLeftAsItWasByAFileThatIsNotThere) {
    ViewState state;
    EXPECT_TRUE(readState("/nowhere/at/all.json", state).ok());
    EXPECT_EQ(state.settings, photon_gi::Settings{});
}

TEST(ViewState, NamesTheValueThatIsWrongAndTakesNone) {
    for (const auto& [text, named] :
         {std::pair{R"({"exposure":2,"settings":{"photons":0}})", "settings.photons"},
          std::pair{R"({"exposure":2,"settings":{"photons":2.5}})", "whole"},
          std::pair{R"({"exposure":2,"settings":{"gather":"rays"}})", "rays"},
          std::pair{R"({"exposure":2,"settings":{"phtons":1}})", "phtons"},
          std::pair{R"({"exposure":2,"size":[0,1]})", "size"},
          std::pair{R"({"exposure":2,"tonemap":"aces"})", "aces"},
          std::pair{R"({"exposure":2,"camera_to_world":[1,2]})", "camera_to_world"},
          std::pair{R"({"exposure":2,"camera_to_world":[2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})",
                    "rigid"},
          std::pair{R"({"exposure":2,"camera_to_world":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})",
                    "rigid"},
          std::pair{R"({"exposure":2,"exposur":-2})", "exposur: there is no such key"},
          std::pair{R"({"exposure":2,"name":"npm","version":"1.0.0"})", "name: there is no such"},
          std::pair{R"({"exposure":2,"panels":{"timings":true}})", "panels.timings"},
          std::pair{R"({"exposure":2,"panels":5})", "panels: 5 is no object"},
          std::pair{R"({"exposure":2,"panels":{"truth":1}})", "panels.truth: 1 is not true"},
          std::pair{R"({"exposure":2,"settings":[]})", "settings: [] is no object"},
          std::pair{R"({"exposure":2,"settings":{"guiding":"on"}})", "settings.guiding: \"on\""},
          std::pair{R"({"exposure":2,"settings":{"photons":"many"}})", "photons: \"many\" is no"},
          std::pair{R"({"exposure":2,"settings":{"gather":3}})", "settings.gather: 3 is no word"},
          std::pair{R"({"exposure":2,"tonemap":null})", "tonemap: null"},
          std::pair{R"({"exposure":2,"overlay":"yes"})", "overlay: \"yes\""},
          std::pair{R"({"exposure":2,"size":7})", "size: 7 is no list"},
          std::pair{R"({"exposure":2,"size":[1,2,3]})", "size: [1,2,3] is no list"},
          std::pair{R"([1,2])", "[1,2] is no object of settings"},
          std::pair{R"(null)", "null is no object of settings"},
          std::pair{R"({"exposure":2)", "parse"}}) {
        ViewState state;
        const auto parsed = parseState(text, state);
        ASSERT_FALSE(parsed.ok()) << text;
        EXPECT_NE(parsed.error().message.find(named), std::string::npos) << parsed.error().message;
        EXPECT_EQ(state.display.exposureEv, 0.0f);
    }
}

TEST(ViewState, MakesACameraRigidThatNearlyIs) {
    ViewState state;
    ASSERT_TRUE(
        parseState(R"({"camera_to_world":[1.0004,0,0,0,0,1,0,0,0,0,1,0,3,2,1,1]})", state).ok());
    EXPECT_EQ(*state.cameraToWorld, glm::translate(glm::mat4(1.0f), glm::vec3(3, 2, 1)));
    // What was turned a few times comes back to the bit, or a replay would differ.
    window::Input input;
    input.buttons[0] = true;
    input.movedX = 33.0;
    input.movedY = 7.0;
    for (int i = 0; i < 50; ++i) state.cameraToWorld = fly(*state.cameraToWorld, input, 1.0f, 0.0f);
    ViewState back;
    ASSERT_TRUE(parseState(stateText(state), back).ok());
    EXPECT_EQ(back.cameraToWorld, state.cameraToWorld);
}

scene::SceneSnapshot cornell() {
    const ecs::World world = scene::builtinScene("cornell").value();
    return scene::extract(world, {}, 0);
}

TEST(Picking, FindsWhatIsSeenAtAPixel) {
    const scene::SceneSnapshot snapshot = cornell();
    const scene::SnapshotCamera& camera = snapshot.cameras.front();
    const graph::Extent size{1280, 720};
    const ecs::Entity lamp = pick(snapshot, camera, size, 637, 180);
    ASSERT_FALSE(snapshot.lights.empty());
    EXPECT_EQ(lamp, snapshot.lights.front().entity);
    EXPECT_EQ(pick(snapshot, camera, size, 10, 360), ecs::Entity{}) << "beside the box";
    const ecs::Entity red = pick(snapshot, camera, size, 320, 400);
    const ecs::Entity green = pick(snapshot, camera, size, 960, 400);
    EXPECT_NE(red, ecs::Entity{});
    EXPECT_NE(green, ecs::Entity{});
    EXPECT_NE(red, green);
}

TEST(WalkCamera, ComesToStandOnTheFloorAndStopsAtAWall) {
    const scene::SceneSnapshot snapshot = cornell();
    WalkCamera walker;
    glm::mat4 camera = glm::translate(glm::mat4(1.0f), glm::vec3(-1.0f, 4.0f, 4.0f));
    window::Input input;
    for (int i = 0; i < 200; ++i) camera = walker.walk(camera, input, snapshot, 1.0f / 60.0f);
    EXPECT_NEAR(camera[3].y, WalkCamera::kEyeMetres, 1e-3f);
    EXPECT_NEAR(camera[3].z, 4.0f, 1e-6f);
    input.held['W'] = true;
    for (int i = 0; i < 60; ++i) camera = walker.walk(camera, input, snapshot, 1.0f / 60.0f);
    EXPECT_NEAR(camera[3].z, 1.5f, 0.3f) << "two and a half metres in a second";
    input.held['W'] = false;
    input.held['A'] = true;
    for (int i = 0; i < 600; ++i) camera = walker.walk(camera, input, snapshot, 1.0f / 60.0f);
    EXPECT_GT(camera[3].x, -5.0f) << "the red wall";
    EXPECT_LT(camera[3].x, -3.0f);
}

}  // namespace
}  // namespace lampyris::sandbox::view
