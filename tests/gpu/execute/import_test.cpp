#include "gpu/execute/execute_test.h"
#include "gpu/image.h"

namespace lampyris {
namespace {

using test::need;

class ImportTest : public test::ExecuteTest {
 protected:
    /// An array of 2 x 2 texels, the texels of layer i being (10 i, 10 i + 1, 10 i + 2, 10 i + 3).
    gpu::Image makeArray(uint32_t layers) {
        auto image = need(gpu::Image::create(
            device(), {.format = VK_FORMAT_R8G8B8A8_UNORM,
                       .extent = {2, 2},
                       .layers = layers,
                       .array = true,
                       .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                       .name = "textures"}));
        auto staging = need(gpu::Staging::create(device()));
        for (uint32_t layer = 0; layer < layers; ++layer) {
            std::vector<uint8_t> bytes(16);
            for (size_t i = 0; i < bytes.size(); ++i)
                bytes[i] = static_cast<uint8_t>(10 * layer + i % 4);
            need(staging.write(image, layer, std::as_bytes(std::span{bytes})));
        }
        need(staging.flush());
        return image;
    }
};

TEST_F(ImportTest, LayersOfAnArrayAreSampledEvenWhenThereIsOne) {
    for (const uint32_t layers : {1u, 5u}) {
        const gpu::Image image = makeArray(layers);
        graph::Frame frame;
        auto node = frame.compute("layers", gpu_test::shaders::layers);
        node.sample(0, frame.importImage("textures", {graph::Format::RGBA8Unorm, {2, 2}, layers},
                                         {&image}, graph::Access::Sampled));
        const auto out = node.write(1, frame.buffer("out", {uint64_t{16} * layers}));
        node.dispatch(layers);
        frame.output(out);
        const auto got = test::valuesOf<float>(run(frame, {.readBackBuffers = {out}}).buffers[0]);
        for (uint32_t layer = 0; layer < layers; ++layer)
            for (uint32_t channel = 0; channel < 4; ++channel)
                EXPECT_NEAR(got[layer * 4 + channel] * 255.0f, 10 * layer + channel, 1e-3);
    }
}

TEST_F(ImportTest, SeveralGibibytesAtOnce) {
    constexpr uint64_t kBytes = uint64_t{3} << 29;  // 1.5 GiB each
    std::vector<gpu::Buffer> buffers;
    auto staging = need(gpu::Staging::create(device()));
    for (uint32_t i = 0; i < 3; ++i) {
        auto buffer = gpu::Buffer::create(device(), {.bytes = kBytes, .name = "large"});
        if (!buffer.ok()) GTEST_SKIP() << buffer.error().message;
        buffers.push_back(std::move(buffer).value());
        need(staging.write(buffers.back(), kBytes - 4, std::as_bytes(std::span{&i, 1})));
        need(staging.flush());
    }
    for (uint32_t i = 0; i < 3; ++i) {
        const auto last = need(staging.read(buffers[i], kBytes - 4, 4));
        EXPECT_EQ(test::valuesOf<uint32_t>(last)[0], i);
    }
}

}  // namespace
}  // namespace lampyris
