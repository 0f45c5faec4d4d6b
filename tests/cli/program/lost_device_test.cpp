// A device that is lost, played by tests/cli/lost_device: one line, and nothing lost or
// half-written.
#include <fstream>

#include "cli/program/view_fixture.h"

namespace lampyris::test {
namespace {

/// The device of a program that starts with `variables` is lost `submissions` after this.
void lose(const ScratchFolder& folder, int submissions) {
    std::ofstream(folder / "lost") << submissions;
}

std::vector<std::string> variables(const ScratchFolder& folder) {
    // The first of two that have one name counts.
    return {"LD_PRELOAD=" LAMPYRIS_LOST_DEVICE,
            "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0",
            "LAMPYRIS_LOST_DEVICE=" + (folder / "lost").string()};
}

TEST(LostDevice, EndsARenderWithOneLineAndNoPicture) {
    const ScratchFolder folder;
    const std::string picture = folder / "a.exr";
    const Arguments call{"render", "cornell", "-o", picture, "--size", "160x90", "--frames", "1"};
    ASSERT_EQ(lampyris(call, variables(folder)).code, 0) << "not lost without the file";
    std::filesystem::remove(picture);
    // In the uploads, in the frame's nodes, wherever it was; and at last not in the call's time.
    bool survived = false;
    for (int submissions = 0; submissions < 40 && !survived; ++submissions) {
        lose(folder, submissions);
        const Ran ran = lampyris(call, variables(folder));
        survived = ran.code == 0;
        if (!survived) expectFailure(ran, "VK_ERROR_DEVICE_LOST");
        EXPECT_EQ(std::filesystem::exists(picture), survived) << submissions << " submissions";
        EXPECT_EQ(folder.files(), survived ? 2u : 1u) << submissions << " submissions";
        EXPECT_TRUE(submissions > 0 || !survived);
    }
    EXPECT_TRUE(survived) << "a frame takes fewer submissions than that";
}

class LostDeviceView : public View {
 protected:
    /// All panels, the truth with its workers among them.
    [[nodiscard]] std::unique_ptr<Process> startOnAGoodDevice() const {
        std::vector<std::string> all = variables(folder_);
        all.push_back(display_);
        std::ofstream(folder_ / "a.json")
            << R"({"overlay":true,"panels":{"timing":true,"graph":true,"photons":true,)"
               R"("truth":true,"scene":true,"settings":true,"shaders":true}})";
        return std::make_unique<Process>(
            Arguments{programPath(), "view", "cornell", "--size", "160x90", "--photons", "77",
                      "--settings", folder_ / "a.json"},
            all);
    }
};

TEST_F(LostDeviceView, EndsWithOneLineAndKeepsItsSettings) {
    for (const int submissions : {0, 1, 2, 3, 7}) {
        std::filesystem::remove(folder_ / "lost");
        const auto view = startOnAGoodDevice();
        ASSERT_TRUE(showsFrames(*view));
        lose(folder_, submissions);
        expectFailure(view->wait(kViewSeconds), "VK_ERROR_DEVICE_LOST");
        EXPECT_EQ(jsonOf(folder_ / "a.json")["settings"]["photons"], 77)
            << "what is to be kept is kept";
    }
}

}  // namespace
}  // namespace lampyris::test
