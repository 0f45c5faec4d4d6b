// `lampyris compare`: a line a measure, a map if asked for, and one line for what cannot be
// compared.
#include <cmath>
#include <limits>
#include <sstream>

#include "cli/program/program.h"
#include "core/file.h"
#include "core/image_io.h"

namespace lampyris::test {
namespace {

class Compare : public testing::Test {
 protected:
    /// A picture whose left half is darker, as a file whose ending says which kind.
    std::string write(const std::string& name, float left, float right, uint32_t width = 32) {
        core::Image image(width, 16, 3);
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                for (uint32_t c = 0; c < 3; ++c) image.at(x, y, c) = x < width / 2 ? left : right;
        EXPECT_TRUE(core::writeImage(folder_ / name, image, {}).ok());
        return folder_ / name;
    }
    /// A file that holds the first part of another.
    std::string cut(const std::string& whole, size_t part, size_t parts) {
        const std::string bytes = textOf(whole);
        std::string path = folder_ / ("cut" + whole.substr(whole.rfind('.')));
        EXPECT_TRUE(core::writeFile(path, bytes.substr(0, bytes.size() * part / parts)).ok());
        return path;
    }
    ScratchFolder folder_;
};

std::vector<std::pair<std::string, double>> figures(const Ran& ran) {
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    std::vector<std::pair<std::string, double>> lines;
    std::istringstream text(ran.out);
    std::string name;
    double value = 0.0;
    while (text >> name >> value) lines.emplace_back(name, value);
    return lines;
}

TEST_F(Compare, PrintsALineAMeasure) {
    const Ran ran = lampyris({"compare", write("a.png", 0.0f, 1.0f), write("b.png", 0.0f, 1.0f)});
    EXPECT_EQ(ran.out, "MSE 0\nNRMSE 0\nMSSIM 1\nFLIP 0\nrelMSE 0\n");
    EXPECT_EQ(ran.code, 0);
}

TEST_F(Compare, MeasuresPngs) {
    // Linear 0.5 is 188 of 255, 1 is 255.
    const auto lines =
        figures(lampyris({"compare", write("a.png", 0.0f, 0.5f), write("b.png", 0.0f, 1.0f)}));
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_NEAR(lines[0].second, 67.0 * 67.0 / 2.0, 1e-2);
    EXPECT_NEAR(lines[1].second, 67.0 / std::sqrt(2.0) / 255.0, 1e-5);
    const double light = core::decodeSrgb(188.0f / 255.0f);
    EXPECT_NEAR(lines[4].second, (1.0 - light) * (1.0 - light) / 1.01 / 2.0, 1e-5);
}

TEST_F(Compare, MeasuresExrsAsTheyAreShownAndTheirLightAsItIs) {
    const std::string a = write("a.exr", 0.0f, 8.0f);
    const std::string b = write("b.exr", 0.0f, 4.0f);
    const auto clipped = figures(lampyris({"compare", a, b}));
    EXPECT_EQ(clipped[0].second, 0.0) << "both are white";
    EXPECT_NEAR(clipped[4].second, 16.0 / 16.01 / 2.0, 1e-5);
    const auto exposed = figures(lampyris({"compare", a, b, "--exposure", "-3"}));
    EXPECT_NEAR(exposed[0].second, 67.0 * 67.0 / 2.0, 1e-2);
    EXPECT_EQ(exposed[4].second, clipped[4].second) << "exposure is for display values alone";
    EXPECT_GT(figures(lampyris({"compare", a, b, "--tonemap", "filmic"}))[0].second, 0.0);
}

TEST_F(Compare, MeasuresAPngAgainstAnExr) {
    const std::string png = write("a.png", 0.0f, 0.25f);
    const auto lines =
        figures(lampyris({"compare", png, write("b.exr", 0.0f, 1.0f), "--exposure", "-2"}));
    EXPECT_EQ(lines[0].second, 0.0);
    EXPECT_EQ(lines[4].second, 0.0) << "both lights are those of display values";
}

TEST_F(Compare, WritesTheMapsInOnePicture) {
    const std::string map = folder_ / "map.png";
    figures(lampyris(
        {"compare", write("a.png", 0.0f, 0.5f), write("b.png", 0.0f, 1.0f), "--map", map}));
    const auto picture = core::readPng(map);
    ASSERT_TRUE(picture.ok()) << picture.error().message;
    EXPECT_EQ(picture->width, 3u * 32);
    EXPECT_EQ(picture->height, 16u);
    EXPECT_EQ(picture->values[3 * (8 * 96 + 4)], 0) << "the left halves are equal";
    EXPECT_GT(picture->values[3 * (8 * 96 + 28)], 200) << "the right halves are not";
    EXPECT_EQ(folder_.files(), 3u);
}

TEST_F(Compare, NamesWhatCannotBeCompared) {
    const std::string a = write("a.png", 0.0f, 0.5f);
    expectFailure(lampyris({"compare", a, folder_ / "missing.png"}), "missing.png: No such file");
    expectFailure(lampyris({"compare", folder_ / "missing.exr", a}), "missing.exr: No such file");
    const Ran sizes = lampyris({"compare", a, write("wide.png", 0.0f, 0.5f, 40)});
    expectFailure(sizes, "a.png is 32x16");
    expectFailure(sizes, "wide.png is 40x16");
    const Ran lights =
        lampyris({"compare", write("a.exr", 0.0f, 0.5f), write("wide.exr", 0.0f, 0.5f, 40)});
    expectFailure(lights, "a.exr is 32x16");
    expectFailure(lights, "wide.exr is 40x16");
    const std::string narrow = write("narrow.png", 0.0f, 0.5f, 10);
    expectFailure(lampyris({"compare", narrow, narrow}), "11x11");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::string good = write("good.exr", 0.0f, 0.5f);
    expectFailure(lampyris({"compare", good, write("nan.exr", 0.5f, nan)}),
                  "nan.exr: NaN in red of the pixel at (16, 0)");
    const float infinity = std::numeric_limits<float>::infinity();
    expectFailure(lampyris({"compare", write("inf.exr", infinity, 0.5f), good}),
                  "inf.exr: infinity in red of the pixel at (0, 0)");
    ASSERT_TRUE(core::writeFile(folder_ / "notes.txt", "a letter").ok());
    expectFailure(lampyris({"compare", a, folder_ / "notes.txt"}), "notes.txt");
    std::filesystem::create_directory(folder_ / "folder.png");
    expectFailure(lampyris({"compare", a, folder_ / "folder.png"}), "folder");
    std::filesystem::create_directory(folder_ / "folder.exr");
    expectFailure(lampyris({"compare", folder_ / "folder.exr", good}), "folder.exr: is a folder");
}

TEST_F(Compare, NamesFilesThatAreCutOrAnotherKind) {
    const std::string png = write("a.png", 0.0f, 0.5f);
    const std::string exr = write("a.exr", 0.0f, 0.5f);
    for (const size_t part : {0u, 1u, 3u, 5u, 7u}) {
        expectFailure(lampyris({"compare", cut(png, part, 8), png}), "cut.png: PNG: ");
        expectFailure(lampyris({"compare", exr, cut(exr, part, 8)}), "cut.exr: EXR: ");
    }
    std::filesystem::copy_file(exr, folder_ / "false.png");
    expectFailure(lampyris({"compare", png, folder_ / "false.png"}), "false.png: PNG: ");
    std::filesystem::copy_file(png, folder_ / "false.exr");
    expectFailure(lampyris({"compare", exr, folder_ / "false.exr"}), "false.exr: EXR: ");
}

TEST_F(Compare, NamesAMapThatCannotBeWritten) {
    const std::string a = write("a.png", 0.0f, 0.5f);
    expectFailure(lampyris({"compare", a, a, "--map", folder_ / "no_folder/map.png"}), "no_folder");
    std::filesystem::create_directory(folder_ / "taken.png");
    expectFailure(lampyris({"compare", a, a, "--map", folder_ / "taken.png"}), "taken.png");
    EXPECT_EQ(folder_.files(), 2u);
}

TEST_F(Compare, RefusesWrongCalls) {
    const std::string a = write("a.png", 0.0f, 0.5f);
    expectWrongCall(lampyris({"compare"}), "required");
    expectWrongCall(lampyris({"compare", a}), "required");
    expectWrongCall(lampyris({"compare", a, a, a}), "a.png");
    expectWrongCall(lampyris({"compare", a, a, "--map", folder_ / "map.exr"}), "must end in .png");
    expectWrongCall(lampyris({"compare", a, a, "--exposure", "nan"}), "--exposure");
    expectWrongCall(lampyris({"compare", a, a, "--tonemap", "aces"}), "aces");
    expectWrongCall(lampyris({"compare", a, a, "--frames", "3"}), "--frames");
    EXPECT_EQ(lampyris({"compare", "--help"}).code, 0);
    EXPECT_EQ(folder_.files(), 1u);
}

}  // namespace
}  // namespace lampyris::test
