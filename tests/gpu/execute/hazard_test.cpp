// That the layer is silent elsewhere means something only if it speaks here.
#include <algorithm>
#include <string>

#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::addDouble;
using test::need;

class HazardTest : public test::ExecuteTest {
 protected:
    /// Runs the frame as compiled, or with every barrier between its nodes taken out.
    void run(const graph::Frame& frame, bool withBarriers) {
        graph::CompileOptions options;
        options.memory = &executor().memoryModel();
        auto graph = need(graph::compile(frame, options));
        if (!withBarriers)
            for (graph::Step& step : graph.steps) {
                step.barriers.clear();
                step.handover = {};
            }
        need(executor().run(frame, graph, {.timed = false}));
    }
    void expectHazard(const graph::Frame& frame, const std::string& node) {
        run(frame, true);
        EXPECT_TRUE(device().validationMessages().empty());
        run(frame, false);
        const auto messages = takeMessages();
        EXPECT_TRUE(std::any_of(messages.begin(), messages.end(),
                                [&](const std::string& message) {
                                    return message.find("SYNC-HAZARD") != std::string::npos &&
                                           message.find("(in " + node + ")") != std::string::npos;
                                }))
            << messages.size() << " messages, none about a hazard in " << node << ": "
            << (messages.empty() ? "" : messages.front());
    }
};

TEST_F(HazardTest, ReadAfterWriteFromDispatchToDispatch) {
    const auto source = makeBuffer(std::vector<uint32_t>(64, 1));
    graph::Frame frame;
    const auto first = addDouble(frame, "first", import(frame, source), 64);
    frame.output(addDouble(frame, "second", first, 64));
    expectHazard(frame, "second");
}

TEST_F(HazardTest, DispatchAfterFill) {
    graph::Frame frame;
    auto fill = frame.transfer("fill");
    const auto filled = fill.fill(frame.buffer("filled", {256}), 1);
    frame.output(addDouble(frame, "double", filled, 64));
    expectHazard(frame, "double");
}

TEST_F(HazardTest, CopyAfterDispatch) {
    const auto source = makeBuffer(std::vector<uint32_t>(64, 1));
    graph::Frame frame;
    const auto first = addDouble(frame, "first", import(frame, source), 64);
    auto copy = frame.transfer("copy");
    frame.output(copy.copy(first, 0, frame.buffer("copied", {256}), 0, 256));
    expectHazard(frame, "copy");
}

}  // namespace
}  // namespace lampyris
