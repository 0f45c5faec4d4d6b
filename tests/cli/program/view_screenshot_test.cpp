// `lampyris view`: pictures of the frame, and with Shift of the window.
#include <algorithm>

#include "cli/program/view_fixture.h"
#include "core/image_io.h"

namespace lampyris::test {
namespace {

class ViewScreenshot : public View {
 protected:
    void SetUp() override {
        View::SetUp();
        std::filesystem::create_directories(shots_);
    }
    /// In the order in which they were taken.
    [[nodiscard]] std::vector<std::filesystem::path> shots() const {
        std::vector<std::filesystem::path> files;
        for (const auto& file : std::filesystem::directory_iterator(shots_))
            files.push_back(file.path());
        std::sort(files.begin(), files.end());
        return files;
    }
    [[nodiscard]] bool takes(const std::string& key) const {
        const size_t before = shots().size();
        (void)ask({"key", key});
        return eventually([&] { return shots().size() > before; });
    }

    std::filesystem::path shots_ = folder_ / "shots";
};

TEST_F(ViewScreenshot, ShowsTheOverlayWhereShiftIsHeldAndOnlyThen) {
    const auto view = startView({"--size", "640x360", "--render-scale", "0.5", "--pipeline",
                                 "direct", "--screenshots", shots_.string()});
    ASSERT_TRUE(showsFrames(*view));
    (void)ask({"search", "--name", "lampyris: cornell", "windowfocus", "--sync"});
    for (const char* key : {"F12", "shift+F12", "F12"}) ASSERT_TRUE(takes(key)) << key;
    (void)ask({"key", "Escape"});
    expectQuietEnd(*view);
    const auto files = shots();
    ASSERT_EQ(files.size(), 3u);
    const auto widthOf = [](const std::filesystem::path& file) {
        const auto picture = core::readPng(file);
        return picture.ok() ? picture.value().width : 0;
    };
    EXPECT_EQ(widthOf(files[0]), 320u);
    EXPECT_EQ(widthOf(files[1]), 640u) << "of the window, as it is enlarged";
    EXPECT_EQ(widthOf(files[2]), 320u);
    EXPECT_EQ(textOf(files[0]), textOf(files[2])) << "nothing moves";
}

}  // namespace
}  // namespace lampyris::test
