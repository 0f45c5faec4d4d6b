#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

class HistoryTest : public test::ExecuteTest {
 protected:
    /// One frame of current = previous + 1; gives what the image holds then.
    float accumulate(graph::Extent size = {16, 16}, const char* name = "sum") {
        graph::Frame frame;
        const graph::ImageDesc desc{graph::Format::R32Float, size};
        const bool known = executor().history().known(name, desc);
        auto past = frame.history(name, desc, known);
        EXPECT_EQ(past.firstFrame, !known);
        auto node = frame.compute("accumulate", gpu_test::shaders::accumulate);
        node.sample(0, past.previous);
        past.current = node.write(1, past.current);
        node.dispatchOver(size);
        frame.output(past.current);
        const auto result = run(frame, {.readBackImages = {past.current}});
        return execute::toImage(result.images[0]).at(3, 5, 0);
    }
};

TEST_F(HistoryTest, StartsWithZerosAndCarriesOn) {
    for (int frame = 1; frame <= 5; ++frame) EXPECT_EQ(accumulate(), static_cast<float>(frame));
}

TEST_F(HistoryTest, NamesAreKeptApart) {
    EXPECT_EQ(accumulate({16, 16}, "one"), 1.0f);
    EXPECT_EQ(accumulate({16, 16}, "one"), 2.0f);
    EXPECT_EQ(accumulate({16, 16}, "two"), 1.0f);
    EXPECT_EQ(accumulate({16, 16}, "one"), 3.0f);
}

TEST_F(HistoryTest, AnotherSizeStartsAnew) {
    EXPECT_EQ(accumulate({16, 16}), 1.0f);
    EXPECT_EQ(accumulate({16, 16}), 2.0f);
    EXPECT_EQ(accumulate({24, 16}), 1.0f);
    EXPECT_FALSE(executor().history().known("sum", {graph::Format::R32Float, {16, 16}}));
}

TEST_F(HistoryTest, KnowsOnlyWhatAFrameWrote) {
    const graph::ImageDesc desc{graph::Format::R32Float, {16, 16}};
    EXPECT_FALSE(executor().history().known("sum", desc));
    accumulate();
    EXPECT_TRUE(executor().history().known("sum", desc));
    executor().history().forgetAll();
    EXPECT_FALSE(executor().history().known("sum", desc));
}

}  // namespace
}  // namespace lampyris
