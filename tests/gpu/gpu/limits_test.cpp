#include "gpu/buffer.h"
#include "gpu/image.h"
#include "support/gpu_test.h"

namespace lampyris {
namespace {

using test::errorOf;
using test::need;

class LimitsTest : public test::GpuTest {
 protected:
    static bool names(const std::string& message, const char* what) {
        return message.find(what) != std::string::npos;
    }
};

TEST_F(LimitsTest, BuffersBeyondMaxBufferSize) {
    const auto refused = gpu::Buffer::create(
        device(), {.bytes = device().limits().maxBufferSize + 1, .name = "endless"});
    EXPECT_TRUE(names(errorOf(refused), "endless"));
    EXPECT_TRUE(names(errorOf(refused), "maxBufferSize"));
}

TEST_F(LimitsTest, ViewsBeyondMaxTexelBufferElements) {
    const uint64_t texels = device().limits().core.maxTexelBufferElements;
    const auto buffer =
        need(gpu::Buffer::createUnbound(device(), {.bytes = texels + 4096, .name = "texels"}));
    const auto refused = buffer.view(VK_FORMAT_R8_UINT, 1);
    EXPECT_TRUE(names(errorOf(refused), "texels"));
    EXPECT_TRUE(names(errorOf(refused), "maxTexelBufferElements"));
}

TEST_F(LimitsTest, ViewsAreMadeOnce) {
    const auto buffer = need(gpu::Buffer::create(device(), {.bytes = 4096, .name = "texels"}));
    const auto view = need(buffer.view(VK_FORMAT_R32_UINT, 4));
    EXPECT_EQ(need(buffer.view(VK_FORMAT_R32_UINT, 4)), view);
    EXPECT_NE(need(buffer.view(VK_FORMAT_R32_SFLOAT, 4)), view);
    EXPECT_NE(need(buffer.view(VK_FORMAT_R32_UINT, 4, 256)), view);
}

TEST_F(LimitsTest, ImagesBeyondTheirLimits) {
    const VkPhysicalDeviceLimits& limits = device().limits().core;
    gpu::ImageOptions options{
        .format = VK_FORMAT_R8G8B8A8_UNORM, .usage = VK_IMAGE_USAGE_SAMPLED_BIT, .name = "picture"};
    options.extent = {limits.maxImageDimension2D + 1, 1};
    EXPECT_TRUE(names(errorOf(gpu::Image::create(device(), options)), "maxImageDimension2D"));
    options.extent = {1, 1};
    options.layers = limits.maxImageArrayLayers + 1;
    EXPECT_TRUE(names(errorOf(gpu::Image::create(device(), options)), "maxImageArrayLayers"));
}

TEST_F(LimitsTest, ImagesOfAFormatThatTheDeviceCannotUse) {
    const auto refused = gpu::Image::create(device(), {.format = VK_FORMAT_R8G8B8A8_SRGB,
                                                       .extent = {4, 4},
                                                       .usage = VK_IMAGE_USAGE_STORAGE_BIT,
                                                       .name = "stored"});
    EXPECT_TRUE(names(errorOf(refused), "stored"));
}

}  // namespace
}  // namespace lampyris
