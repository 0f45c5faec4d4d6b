// EXR files that other programs write, and files that are broken. What is read beyond their end, or
// not freed, shows under the sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/file.h"
#include "core/image_io.h"
#include "unit/core/exr_builder.h"
#include "unit/core/scratch_folder.h"

namespace lampyris::core {
namespace {

constexpr size_t kStep = 7;  // bytes; every one takes seconds

class ExrFiles : public testing::Test {
 protected:
    Result<Image> read(const std::vector<uint8_t>& bytes) {
        EXPECT_TRUE(writeFile(folder_ / "a.exr", bytes).ok());
        return readExr(folder_ / "a.exr");
    }
    void expectRgb(const std::vector<uint8_t>& bytes, float red, float green, float blue) {
        const auto image = read(bytes);
        ASSERT_TRUE(image.ok()) << image.error().message;
        ASSERT_EQ(image->width, kExrWidth);
        ASSERT_EQ(image->height, kExrHeight);
        for (uint32_t y = 0; y < kExrHeight; ++y)
            for (uint32_t x = 0; x < kExrWidth; ++x) {
                ASSERT_EQ(image->at(x, y, 0), exrValue(red, x, y)) << x << " " << y;
                ASSERT_EQ(image->at(x, y, 1), exrValue(green, x, y)) << x << " " << y;
                ASSERT_EQ(image->at(x, y, 2), exrValue(blue, x, y)) << x << " " << y;
            }
    }
    void expectRefused(const std::vector<uint8_t>& bytes, const std::string& what) {
        const auto image = read(bytes);
        ASSERT_FALSE(image.ok()) << what;
        EXPECT_NE(image.error().message.find("a.exr: EXR: "), std::string::npos);
        EXPECT_NE(image.error().message.find(what), std::string::npos)
            << "no '" << what << "' in: " << image.error().message;
        EXPECT_EQ(image.error().message.find('\n'), std::string::npos);
    }
    ScratchFolder folder_;
};

template <typename T>
void put(std::vector<uint8_t>& bytes, size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof(T));
}

TEST_F(ExrFiles, OfEveryCompressionAndKindOfFloat) {
    for (const int compression :
         {TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_RLE, TINYEXR_COMPRESSIONTYPE_ZIPS,
          TINYEXR_COMPRESSIONTYPE_ZIP, TINYEXR_COMPRESSIONTYPE_PIZ})
        for (const int kind : {TINYEXR_PIXELTYPE_HALF, TINYEXR_PIXELTYPE_FLOAT}) {
            SCOPED_TRACE(testing::Message() << "compression " << compression << " kind " << kind);
            expectRgb(rgbExrFile(kind, compression), 10.0f, 20.0f, 30.0f);
        }
}

TEST_F(ExrFiles, ChannelsAreFoundByName) {
    const int uint = TINYEXR_PIXELTYPE_UINT;
    expectRgb(exrFile({{"A", 1.0f},
                       {"B", 2.0f},
                       {"G", 3.0f, TINYEXR_PIXELTYPE_HALF},
                       {"Id", 0.0f, uint},
                       {"R", 4.0f},
                       {"Y", 5.0f}}),
              4.0f, 3.0f, 2.0f);
    expectRgb(exrFile({{"A", 1.0f}, {"Y", 5.0f}}), 5.0f, 5.0f, 5.0f);
    expectRefused(exrFile({{"A", 1.0f}, {"Z", 5.0f}}), "no channel R");
    expectRefused(exrFile({{"B", 1.0f}, {"R", 5.0f}}), "no channel G");
    expectRefused(exrFile({{"BY", 1.0f}, {"RY", 2.0f}, {"Y", 5.0f}}), "RY and BY");
    expectRefused(exrFile({{"B", 1.0f}, {"G", 2.0f}, {"R", 0.0f, uint}}), "integers");
}

TEST_F(ExrFiles, WhoseRowsAreStoredFromTheBottom) {
    for (const int compression : {TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_ZIP}) {
        auto bytes = rgbExrFile(TINYEXR_PIXELTYPE_FLOAT, compression);
        bytes[exrAttribute(bytes, "lineOrder", "lineOrder")] = 1;
        expectRgb(bytes, 10.0f, 20.0f, 30.0f);
    }
}

TEST_F(ExrFiles, OfKindsThatAreNotSupported) {
    const auto flagged = [](uint8_t flag) {
        auto bytes = rgbExrFile();
        bytes[5] = flag;
        return bytes;
    };
    expectRefused(flagged(0x02), "tiles");
    expectRefused(flagged(0x08), "deep data");
    expectRefused(flagged(0x10), "several parts");
    auto version = rgbExrFile();
    version[4] = 1;
    expectRefused(version, "version 2");
    auto compressed = rgbExrFile();
    compressed[exrAttribute(compressed, "compression", "compression")] = 8;
    expectRefused(compressed, "compression");
    auto subsampled = rgbExrFile();
    // A name, its zero, kind, flags, then the two steps of the samples.
    subsampled[exrAttribute(subsampled, "channels", "chlist") + 2 + 8] = 2;
    expectRefused(subsampled, "B is subsampled");
}

TEST_F(ExrFiles, WithATypeThatIsNone) {
    const auto typed = [](const std::string& value) {
        auto bytes = rgbExrFile();
        std::string attribute = std::string("type") + '\0' + "string" + '\0';
        attribute += static_cast<char>(value.size());
        attribute += std::string(3, '\0') + value;
        bytes.insert(bytes.begin() + 8, attribute.begin(), attribute.end());
        return bytes;
    };
    expectRefused(typed("poem"), "type 'poem'");
    expectRefused(typed("scanlineimage"), "row");  // the table of rows points beside them now
}

TEST_F(ExrFiles, OfImpossibleSizes) {
    const auto window = [](int32_t maxX, int32_t maxY) {
        auto bytes = rgbExrFile();
        const size_t at = exrAttribute(bytes, "dataWindow", "box2i");
        put(bytes, at + 8, maxX);
        put(bytes, at + 12, maxY);
        return bytes;
    };
    expectRefused(window(-1, 34), "0x35");
    expectRefused(window(8, -7), "9x-6");
    expectRefused(window(0x7fffffff, 34), "2147483648x35");
    expectRefused(window(65534, 65534), "65535x65535");
    expectRefused(window(8, 60000), "row");
}

TEST_F(ExrFiles, WhoseTableOfRowsIsWrong) {
    const auto table = [](const std::vector<uint8_t>& bytes) {
        // Behind the last attribute's four bytes and the header's zero.
        return exrAttribute(bytes, "screenWindowWidth", "float") + 5;
    };
    auto bytes = rgbExrFile();
    const size_t at = table(bytes);
    put<uint64_t>(bytes, at + 8, 0);
    expectRefused(bytes, "cut off at row 16 of 35");
    put<uint64_t>(bytes, at + 8, ~uint64_t{0});
    expectRefused(bytes, "cut off at row 16 of 35");
    std::memcpy(bytes.data() + at + 8, bytes.data() + at, 8);
    expectRefused(bytes, "row 16 of 35 is not where the file says");
}

TEST_F(ExrFiles, CutAnywhere) {
    for (const int compression : {TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_ZIP}) {
        const auto whole = rgbExrFile(TINYEXR_PIXELTYPE_HALF, compression);
        for (size_t length = whole.size() - 1; length >= kStep; length -= kStep)
            expectRefused({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}, "");
    }
    expectRefused({}, "");
}

TEST_F(ExrFiles, WithAnyByteWrongAreReadOrRefused) {
    for (const int compression :
         {TINYEXR_COMPRESSIONTYPE_RLE, TINYEXR_COMPRESSIONTYPE_ZIP, TINYEXR_COMPRESSIONTYPE_PIZ}) {
        const auto whole = rgbExrFile(TINYEXR_PIXELTYPE_HALF, compression);
        for (size_t i = 0; i < whole.size(); i += kStep) {
            auto bytes = whole;
            bytes[i] ^= 0xff;
            const auto image = read(bytes);
            if (image.ok()) {
                EXPECT_EQ(image->values.size(), size_t{image->width} * image->height * 3);
            } else {
                EXPECT_NE(image.error().message.find("a.exr: EXR: "), std::string::npos);
            }
        }
    }
}

}  // namespace
}  // namespace lampyris::core
