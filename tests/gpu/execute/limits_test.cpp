#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::need;

class ExecuteLimitsTest : public test::ExecuteTest {
 protected:
    void expectError(const graph::Frame& frame, const std::vector<std::string>& words) {
        const std::string message = test::errorOf(executor().run(frame));
        for (const std::string& word : words)
            EXPECT_NE(message.find(word), std::string::npos) << message;
    }
};

TEST_F(ExecuteLimitsTest, AStorageRangeThatIsTooLarge) {
    const uint64_t most = device().limits().core.maxStorageBufferRange;
    if (most > uint64_t{1} << 30) GTEST_SKIP() << "the device's range is beyond the test's memory";
    const auto large = need(gpu::Buffer::create(device(), {.bytes = most + 16, .name = "photons"}));
    graph::Frame frame;
    auto node = frame.compute("read all", gpu_test::shaders::doubled);
    node.read(0, import(frame, large)).push(test::DoublePush{1, 0});
    frame.output(node.write(1, frame.buffer("out", {4})));
    node.dispatch(1);
    expectError(frame, {"read all", "slot 0", "source", "photons", "maxStorageBufferRange"});
}

TEST_F(ExecuteLimitsTest, ATexelBufferBeyondTheStorageRangeWorks) {
    // 160 MiB: more than a storage buffer may be here.
    constexpr uint32_t kTexels = 40 << 20;
    std::vector<float> values(kTexels, 0.0f);
    values.back() = 8.0f;
    const auto large = makeBuffer(values);
    graph::Frame frame;
    auto node = frame.compute("copy", gpu_test::shaders::texels);
    node.texels(0, import(frame, large), graph::Format::R32Float).uniformData(2, 2.0f);
    const auto out =
        node.writeTexels(1, frame.buffer("out", {uint64_t{4} * kTexels}), graph::Format::R32Float);
    node.dispatch(65535, 1);  // covers a tenth
    frame.output(out);
    need(executor().run(frame));
}

TEST_F(ExecuteLimitsTest, TooManyWorkgroups) {
    const uint32_t most = device().limits().core.maxComputeWorkGroupCount[1];
    if (most == UINT32_MAX) GTEST_SKIP() << "the device has no such limit";
    graph::Frame frame;
    auto clear = frame.transfer("clear");
    auto node = frame.compute("count", gpu_test::shaders::count);
    frame.output(node.update(0, clear.fill(frame.buffer("counter", {4}), 0)));
    node.dispatch(1, most + 1);
    expectError(frame, {"node count", "axis 1", "maxComputeWorkGroupCount"});
}

TEST_F(ExecuteLimitsTest, AnImportThatIsNotAsDescribed) {
    const auto small = makeBuffer(std::vector<uint32_t>(4, 0));
    graph::Frame frame;
    auto node = frame.compute("double", gpu_test::shaders::doubled);
    node.read(0, frame.importBuffer("described", {4096}, {&small})).push(test::DoublePush{1, 0});
    frame.output(node.write(1, frame.buffer("out", {4})));
    node.dispatch(1);
    expectError(frame, {"described", "4096"});
}

TEST_F(ExecuteLimitsTest, AnImportWithNothingBehindIt) {
    graph::Frame frame;
    auto node = frame.compute("double", gpu_test::shaders::doubled);
    node.read(0, frame.importBuffer("nothing", {64}, {})).push(test::DoublePush{1, 0});
    frame.output(node.write(1, frame.buffer("out", {4})));
    node.dispatch(1);
    expectError(frame, {"nothing", "no object"});
}

}  // namespace
}  // namespace lampyris
