#include "execute/copy_ring.h"

#include "execute/barriers.h"
#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::need;

constexpr graph::ImageDesc desc(uint32_t width) {
    return {graph::Format::RGBA8Unorm, {width, 3}};
}

class CopyRing : public test::ExecuteTest {
 protected:
    /// An image whose texels are all `red` of 255, as the executor leaves one.
    gpu::Image makeImage(uint32_t width, float red) {
        gpu::Image image = need(gpu::Image::create(
            device(), {.format = VK_FORMAT_R8G8B8A8_UNORM,
                       .extent = {width, 3},
                       .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                       .name = "shown"}));
        auto commands = need(gpu::Commands::create(device(), "clear"));
        VkCommandBuffer recorded = need(commands.begin());
        execute::changeLayout(recorded, image, VK_IMAGE_LAYOUT_UNDEFINED,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        VkClearValue value{};
        value.color.float32[0] = red / 255.0f;
        execute::clearImage(recorded, image, value);
        execute::changeLayout(recorded, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        EXPECT_TRUE(commands.end().ok());
        EXPECT_TRUE(gpu::submitAndWait(device(), commands).ok());
        return image;
    }
};

int redOf(const std::optional<execute::RawImage>& copy) {
    return copy ? std::to_integer<int>(copy->bytes.at(0)) : -1;
}

TEST_F(CopyRing, GivesEachCopyTwoTurnsLater) {
    std::vector<gpu::Image> images;
    auto ring = need(execute::CopyRing::create(device()));
    for (int i = 0; i < 7; ++i) {
        images.push_back(makeImage(5, static_cast<float>(10 * i)));
        EXPECT_EQ(redOf(need(ring.turn(images.back(), desc(5)))), i < 2 ? -1 : 10 * (i - 2));
    }
    EXPECT_EQ(redOf(need(ring.takeOldest())), 50);
    EXPECT_EQ(redOf(need(ring.takeOldest())), 60);
    EXPECT_EQ(redOf(need(ring.takeOldest())), -1);
}

TEST_F(CopyRing, FollowsAnotherSize) {
    std::vector<gpu::Image> images;
    auto ring = need(execute::CopyRing::create(device()));
    for (const uint32_t width : {4u, 40u, 2u, 8u, 8u}) {
        images.push_back(makeImage(width, static_cast<float>(width)));
        const auto copy = need(ring.turn(images.back(), desc(width)));
        if (!copy) continue;
        EXPECT_EQ(copy->bytes.size(), size_t{4} * 3 * copy->desc.extent.width);
        EXPECT_EQ(redOf(copy), static_cast<int>(copy->desc.extent.width));
    }
}

TEST_F(CopyRing, MayEndWithCopiesNobodyTook) {
    const gpu::Image image = makeImage(4, 1.0f);
    auto ring = need(execute::CopyRing::create(device()));
    EXPECT_FALSE(need(ring.turn(image, desc(4))).has_value());
}

}  // namespace
}  // namespace lampyris
