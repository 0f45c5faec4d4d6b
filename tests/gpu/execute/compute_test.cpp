#include <numeric>

#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::addDouble;
namespace shaders = gpu_test::shaders;

class ComputeTest : public test::ExecuteTest {
 protected:
    static constexpr uint32_t kCount = 1000;
    static std::vector<uint32_t> ramp() {
        std::vector<uint32_t> values(kCount);
        std::iota(values.begin(), values.end(), 0u);
        return values;
    }
};

TEST_F(ComputeTest, ChainsOfNodesSeeEachOthersWrites) {
    const auto source = makeBuffer(ramp());
    graph::Frame frame;
    graph::Buffer last = import(frame, source);
    for (const char* name : {"one", "two", "three", "four"})
        last = addDouble(frame, name, last, kCount, 1);
    frame.output(last);
    const auto got = test::valuesOf<uint32_t>(run(frame, {.readBackBuffers = {last}}).buffers[0]);
    for (uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(got[i], 16 * i + 15);
}

TEST_F(ComputeTest, TexelBuffersUniformsAndSpecialisation) {
    std::vector<float> values(kCount);
    for (uint32_t i = 0; i < kCount; ++i) values[i] = static_cast<float>(i);
    const auto source = makeBuffer(values);
    graph::Frame frame;
    auto node = frame.compute("texels", shaders::texels);
    node.texels(0, import(frame, source), graph::Format::R32Float)
        .uniformData(2, 3.0f)
        .specialise(3, std::bit_cast<uint32_t>(0.5f));
    const auto out =
        node.writeTexels(1, frame.buffer("out", {4 * kCount}), graph::Format::R32Float);
    node.dispatch((kCount + 63) / 64);
    frame.output(out);
    const auto got = test::valuesOf<float>(run(frame, {.readBackBuffers = {out}}).buffers[0]);
    for (uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(got[i], 3.0f * values[i] + 0.5f);
}

TEST_F(ComputeTest, OneShaderWithTwoSpecialisations) {
    const auto source = makeBuffer(std::vector<float>(64, 1.0f));
    graph::Frame frame;
    std::vector<graph::Buffer> outs;
    for (const float offset : {10.0f, 20.0f}) {
        auto node = frame.compute("texels", shaders::texels);
        node.texels(0, import(frame, source), graph::Format::R32Float)
            .uniformData(2, 1.0f)
            .specialise(3, std::bit_cast<uint32_t>(offset));
        outs.push_back(node.writeTexels(1, frame.buffer("out", {256}), graph::Format::R32Float));
        node.dispatch(1);
        frame.output(outs.back());
    }
    const auto result = run(frame, {.readBackBuffers = outs});
    EXPECT_EQ(test::valuesOf<float>(result.buffers[0])[7], 11.0f);
    EXPECT_EQ(test::valuesOf<float>(result.buffers[1])[7], 21.0f);
}

TEST_F(ComputeTest, RangesOfABuffer) {
    const auto source = makeBuffer(ramp());
    graph::Frame frame;
    auto node = frame.compute("range", shaders::doubled);
    node.readRange(0, import(frame, source), 1024, 256).push(test::DoublePush{64, 0});
    const auto out = node.write(1, frame.buffer("out", {256}));
    node.dispatch(1);
    frame.output(out);
    const auto got = test::valuesOf<uint32_t>(run(frame, {.readBackBuffers = {out}}).buffers[0]);
    EXPECT_EQ(got[0], 512u);
    EXPECT_EQ(got[63], 638u);
}

TEST_F(ComputeTest, IndirectDispatchesTakeTheirSizeFromTheDevice) {
    for (const uint32_t groups : {0u, 1u, 5u}) {
        graph::Frame frame;
        auto count = frame.compute("count groups", shaders::groupCounts);
        count.push(groups);
        const auto arguments = count.write(0, frame.buffer("groups", {12}));
        count.dispatch(1);
        auto clear = frame.transfer("clear");
        auto counter = clear.fill(frame.buffer("counter", {4}), 0);
        auto node = frame.compute("count", shaders::count);
        counter = node.update(0, counter);
        node.dispatchIndirect(arguments);
        frame.output(counter);
        const auto got = run(frame, {.readBackBuffers = {counter}});
        EXPECT_EQ(test::valuesOf<uint32_t>(got.buffers[0])[0], 32 * groups);
    }
}

TEST_F(ComputeTest, ImagesAreWrittenAndSampled) {
    graph::Frame frame;
    const graph::Extent size{37, 21};
    auto write = frame.compute("coordinates", shaders::coordinates);
    const auto image =
        write.write(0, frame.image("coordinates", {graph::Format::RGBA32Float, size}));
    write.dispatchOver(size);
    auto add = frame.compute("accumulate", shaders::accumulate);
    add.sample(0, image);
    const auto sum = add.write(1, frame.image("sum", {graph::Format::R32Float, size}));
    add.dispatchOver(size);
    frame.output(sum);
    const auto result = run(frame, {.readBackImages = {sum, image}});
    const core::Image sums = execute::toImage(result.images[0]);
    const core::Image coordinates = execute::toImage(result.images[1]);
    for (uint32_t y = 0; y < size.height; ++y)
        for (uint32_t x = 0; x < size.width; ++x) {
            ASSERT_EQ(coordinates.at(x, y, 0), static_cast<float>(x));
            ASSERT_EQ(coordinates.at(x, y, 1), static_cast<float>(y));
            ASSERT_EQ(sums.at(x, y, 0), static_cast<float>(x) + 1.0f);
        }
}

}  // namespace
}  // namespace lampyris
