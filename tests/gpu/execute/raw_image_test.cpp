#include "execute/raw_image.h"

#include <cmath>

#include "core/display.h"
#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

template <typename T>
execute::RawImage rawOf(graph::Format format, const std::vector<T>& values) {
    execute::RawImage raw;
    const auto* first = reinterpret_cast<const std::byte*>(values.data());
    raw.bytes.assign(first, first + values.size() * sizeof(T));
    const auto texels = static_cast<uint32_t>(raw.bytes.size() / graph::bytesPerTexel(format));
    raw.desc = {format, {texels, 1}};
    return raw;
}

TEST(RawImage, HalfFloats) {
    // 1, −2, the largest, the smallest normal; the smallest of all, −0, infinity, NaN
    const std::vector<uint16_t> halves{0x3c00, 0xc000, 0x7bff, 0x0400,
                                       0x0001, 0x8000, 0x7c00, 0x7e00};
    const core::Image image = execute::toImage(rawOf(graph::Format::RGBA16Float, halves));
    EXPECT_EQ(image.values[0], 1.0f);
    EXPECT_EQ(image.values[1], -2.0f);
    EXPECT_EQ(image.values[2], 65504.0f);
    EXPECT_EQ(image.values[3], 0x1p-14f);
    EXPECT_EQ(image.values[4], 0x1p-24f);
    EXPECT_TRUE(std::signbit(image.values[5]));
    EXPECT_TRUE(std::isinf(image.values[6]));
    EXPECT_TRUE(std::isnan(image.values[7]));
}

TEST(RawImage, EightBits) {
    const std::vector<uint8_t> bytes{255, 0, 51, 128};
    EXPECT_EQ(execute::toImage(rawOf(graph::Format::RGBA8Unorm, bytes)).values[2], 0.2f);
    const core::Image swapped = execute::toImage(rawOf(graph::Format::BGRA8Unorm, bytes));
    EXPECT_EQ(swapped.values[0], 0.2f);
    EXPECT_EQ(swapped.values[2], 1.0f);
    const core::Image decoded = execute::toImage(rawOf(graph::Format::RGBA8Srgb, bytes));
    EXPECT_EQ(decoded.values[2], core::decodeSrgb(0.2f));
    EXPECT_NEAR(decoded.values[3], 128.0f / 255.0f, 1e-6f);
}

TEST(RawImage, FloatsAndUints) {
    const auto floats = execute::toImage(rawOf<float>(graph::Format::RG32Float, {1.5f, -2.5f}));
    EXPECT_EQ(floats.channels, 2u);
    EXPECT_EQ(floats.values[1], -2.5f);
    const auto uints = execute::toImage(rawOf<uint32_t>(graph::Format::R32Uint, {12, 34}));
    EXPECT_EQ(uints.channels, 1u);
    EXPECT_EQ(uints.at(1, 0, 0), 34.0f);
}

}  // namespace
}  // namespace lampyris
