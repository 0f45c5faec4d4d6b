#include "core/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/file.h"
#include "core/image_io.h"
#include "unit/core/scratch_folder.h"

namespace lampyris::core {
namespace {

Image gradient(uint32_t width, uint32_t height, uint32_t channels) {
    Image image(width, height, channels);
    for (size_t i = 0; i < image.values.size(); ++i)
        image.values[i] = 0.001f * static_cast<float>(i * i) - 0.5f;
    return image;
}

TEST(Image, IsStoredByRowsFromTheTopWithChannelsTogether) {
    Image image(4, 3, 2);
    EXPECT_EQ(image.values.size(), 24u);
    image.at(2, 1, 1) = 5.0f;
    EXPECT_EQ(image.values[(1 * 4 + 2) * 2 + 1], 5.0f);
    EXPECT_EQ(std::as_const(image).at(2, 1, 1), 5.0f);
}

TEST(ImageDeath, CatchesAPixelOutside) {
    Image image(4, 3, 3);
    EXPECT_DEATH(image.at(4, 0, 0) = 1.0f, "x < width.*4 < 4");
    EXPECT_DEATH(image.at(0, 3, 0) = 1.0f, "3 < 3");
    EXPECT_DEATH(image.at(0, 0, 3) = 1.0f, "3 < 3");
}

TEST(ImageExr, BringsEveryFloatBack) {
    const ScratchFolder folder;
    Image image = gradient(17, 9, 3);
    image.values[0] = 1e30f;
    image.values[1] = std::numeric_limits<float>::denorm_min();
    image.values[2] = std::numeric_limits<float>::infinity();
    ASSERT_TRUE(writeExr(folder / "a.exr", image).ok());
    const auto read = readExr(folder / "a.exr");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->width, 17u);
    EXPECT_EQ(read->height, 9u);
    EXPECT_EQ(read->values, image.values);
}

TEST(ImageExr, SpreadsOneChannelAndDropsTheFourth) {
    const ScratchFolder folder;
    const Image grey = gradient(5, 4, 1);
    ASSERT_TRUE(writeExr(folder / "grey.exr", grey).ok());
    const Image spread = readExr(folder / "grey.exr").value();
    const Image rgba = gradient(5, 4, 4);
    ASSERT_TRUE(writeExr(folder / "rgba.exr", rgba).ok());
    const Image rgb = readExr(folder / "rgba.exr").value();
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 5; ++x)
            for (uint32_t c = 0; c < 3; ++c) {
                EXPECT_EQ(spread.at(x, y, c), grey.at(x, y, 0));
                EXPECT_EQ(rgb.at(x, y, c), rgba.at(x, y, c));
            }
}

TEST(ImageExr, GivesTheSameBytesForTheSameImage) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeExr(folder / "a.exr", gradient(20, 20, 3)).ok());
    ASSERT_TRUE(writeExr(folder / "b.exr", gradient(20, 20, 3)).ok());
    EXPECT_EQ(readFile(folder / "a.exr").value(), readFile(folder / "b.exr").value());
}

TEST(ImageExr, NamesAFileThatIsNoneOrCutOff) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeExr(folder / "whole.exr", gradient(40, 40, 3)).ok());
    std::vector<uint8_t> bytes = readFile(folder / "whole.exr").value();
    for (const size_t kept : {size_t{0}, size_t{3}, size_t{200}, bytes.size() / 2}) {
        ASSERT_TRUE(writeFile(folder / "cut.exr", std::span(bytes).first(kept)).ok());
        const auto read = readExr(folder / "cut.exr");
        ASSERT_FALSE(read.ok()) << kept << " bytes of " << bytes.size();
        EXPECT_NE(read.error().message.find("cut.exr: EXR: "), std::string::npos)
            << read.error().message;
    }
    ASSERT_TRUE(
        writeFile(folder / "text.exr", "not a picture at all, whatever its name says").ok());
    EXPECT_FALSE(readExr(folder / "text.exr").ok());
}

TEST(ImagePng, BringsEveryByteBack) {
    const ScratchFolder folder;
    DisplayImage image{7, 5, std::vector<uint8_t>(7 * 5 * 3)};
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<uint8_t>(i * 37);
    ASSERT_TRUE(writePng(folder / "a.png", image).ok());
    const auto read = readPng(folder / "a.png");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->width, 7u);
    EXPECT_EQ(read->height, 5u);
    EXPECT_EQ(read->values, image.values);
}

TEST(ImagePng, NamesAFileThatIsNone) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeFile(folder / "text.png", "not a picture").ok());
    const auto read = readPng(folder / "text.png");
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message.find("text.png: PNG: "), std::string::npos);
}

TEST(ImagePng, NamesAFileThatIsCutOrDamagedAnywhere) {
    const ScratchFolder folder;
    DisplayImage image{7, 5, std::vector<uint8_t>(7 * 5 * 3)};
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<uint8_t>(i * 37);
    ASSERT_TRUE(writePng(folder / "whole.png", image).ok());
    const auto whole = readFile(folder / "whole.png").value();
    const auto expectRefused = [&](const std::vector<uint8_t>& bytes) {
        ASSERT_TRUE(writeFile(folder / "bad.png", bytes).ok());
        const auto read = readPng(folder / "bad.png");
        ASSERT_FALSE(read.ok());
        EXPECT_NE(read.error().message.find("bad.png: PNG: "), std::string::npos);
    };
    for (size_t i = 0; i < whole.size(); ++i) {
        SCOPED_TRACE(i);
        expectRefused({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i)});
        auto damaged = whole;
        damaged[i] ^= 0x10;
        expectRefused(damaged);
    }
}

TEST(ImageFiles, AreWrittenAsTheirEndingSays) {
    const ScratchFolder folder;
    const Image image = gradient(6, 6, 3);
    ASSERT_TRUE(writeImage(folder / "a.exr", image, {}).ok());
    EXPECT_EQ(readExr(folder / "a.exr")->values, image.values);
    ASSERT_TRUE(writeImage(folder / "a.png", image, {}).ok());
    EXPECT_EQ(readPng(folder / "a.png")->values, toDisplay(image, {}).values);
    const auto other = writeImage(folder / "a.jpg", image, {});
    ASSERT_FALSE(other.ok());
    EXPECT_NE(other.error().message.find("a.jpg: the file's name must end in"), std::string::npos);
    EXPECT_EQ(folder.files(), 2u);
}

}  // namespace
}  // namespace lampyris::core
