#include <numeric>

#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::need;
namespace shaders = gpu_test::shaders;

class TransferTest : public test::ExecuteTest {
 protected:
    static graph::Image coordinates(graph::Frame& frame, graph::Extent size) {
        auto node = frame.compute("coordinates", shaders::coordinates);
        const auto image =
            node.write(0, frame.image("coordinates", {graph::Format::RGBA32Float, size}));
        node.dispatchOver(size);
        return image;
    }
};

TEST_F(TransferTest, FillsAndCopiesRunInTheirOrder) {
    std::vector<uint32_t> values(64);
    std::iota(values.begin(), values.end(), 0u);
    const auto source = makeBuffer(values);
    graph::Frame frame;
    auto node = frame.transfer("patch");
    auto target = node.fill(frame.buffer("target", {256}), 77);
    target = node.copy(import(frame, source), 64, target, 128, 16);
    frame.output(target);
    const auto got = test::valuesOf<uint32_t>(run(frame, {.readBackBuffers = {target}}).buffers[0]);
    EXPECT_EQ(got[31], 77u);
    EXPECT_EQ(got[32], 16u);
    EXPECT_EQ(got[35], 19u);
    EXPECT_EQ(got[36], 77u);
}

TEST_F(TransferTest, ImagesThroughBuffersAndBack) {
    const graph::Extent size{12, 10};
    graph::Frame frame;
    const auto first = coordinates(frame, size);
    auto out = frame.transfer("out");
    const auto bytes = out.copyToBuffer(first, frame.buffer("bytes", {12 * 10 * 16}));
    auto in = frame.transfer("in");
    const auto second =
        in.copyToImage(bytes, 0, frame.image("second", {graph::Format::RGBA32Float, size}));
    auto copy = frame.transfer("copy");
    const auto third = copy.copy(second, frame.image("third", {graph::Format::RGBA32Float, size}));
    frame.output(third);
    const auto result = run(frame, {.readBackImages = {third}});
    const core::Image got = execute::toImage(result.images[0]);
    EXPECT_EQ(got.at(11, 9, 0), 11.0f);
    EXPECT_EQ(got.at(11, 9, 1), 9.0f);
}

TEST_F(TransferTest, BlitsScaleAndConvert) {
    graph::Frame frame;
    const auto source = coordinates(frame, {16, 16});
    auto node = frame.transfer("blit");
    const auto half = node.blit(source, frame.image("half", {graph::Format::RGBA16Float, {8, 8}}));
    frame.output(half);
    const auto result = run(frame, {.readBackImages = {half}});
    const core::Image got = execute::toImage(result.images[0]);
    EXPECT_NEAR(got.at(3, 5, 0), 6.5f, 0.01f);
    EXPECT_NEAR(got.at(3, 5, 1), 10.5f, 0.01f);
}

TEST_F(TransferTest, UploadsFromMappedMemory) {
    const auto upload = need(gpu::Buffer::create(
        device(), {.bytes = 256, .memory = gpu::MemoryUse::Upload, .name = "mapped"}));
    for (uint32_t round = 1; round < 4; ++round) {
        std::vector<uint32_t> values(64, round);
        std::memcpy(upload.mapped().data(), values.data(), 256);
        graph::Frame frame;
        auto node = frame.transfer("upload");
        const auto mapped =
            frame.importBuffer("mapped", {256}, {&upload}, graph::Access::TransferRead);
        const auto target = node.copy(mapped, 0, frame.buffer("target", {256}), 0, 256);
        frame.output(target);
        const auto got = run(frame, {.readBackBuffers = {target}});
        EXPECT_EQ(test::valuesOf<uint32_t>(got.buffers[0]), values);
    }
}

}  // namespace
}  // namespace lampyris
