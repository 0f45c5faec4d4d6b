#include "plot/axis.h"

#include <gtest/gtest.h>

namespace lampyris::sandbox::plot {
namespace {

using Ticks = std::vector<double>;

TEST(Axis, WidensLinearValuesToWholeSteps) {
    const Axis axis({0.3, 9.1}, {0.0, 100.0});
    EXPECT_EQ(axis.ticks(), (Ticks{0, 2, 4, 6, 8, 10}));
    EXPECT_DOUBLE_EQ(axis.pixelOf(0.0), 0.0);
    EXPECT_DOUBLE_EQ(axis.pixelOf(5.0), 50.0);
    EXPECT_DOUBLE_EQ(axis.pixelOf(10.0), 100.0);
    EXPECT_EQ(Axis({0.25, 2.0}, {0, 1}).ticks(), (Ticks{0, 0.5, 1, 1.5, 2}));
    EXPECT_EQ(Axis({0.0, 10.0}, {0, 1}).ticks(), (Ticks{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(Axis({-3.0, 1.0}, {0, 1}).ticks(), (Ticks{-3, -2, -1, 0, 1}));
}

TEST(Axis, TakesValuesThatAreAllTheSame) {
    EXPECT_GT(Axis({5.0, 5.0}, {0.0, 1.0}).ticks().size(), 1u);
    EXPECT_GT(Axis({0.0, 0.0}, {0.0, 1.0}).ticks().size(), 1u);
    const Axis axis({100.0, 100.0}, {0.0, 1.0}, Scale::Logarithmic);
    EXPECT_EQ(axis.ticks(), (Ticks{100, 200}));
}

TEST(Axis, LogarithmicStepsAreFactors) {
    const Axis axis({30.0, 900.0}, {300.0, 0.0}, Scale::Logarithmic);
    EXPECT_EQ(axis.ticks(), (Ticks{20, 50, 100, 200, 500, 1000}));
    EXPECT_NEAR(axis.pixelOf(20.0), 300.0, 1e-9);
    EXPECT_NEAR(axis.pixelOf(1000.0), 0.0, 1e-9);
    const double step = axis.pixelOf(50.0) - axis.pixelOf(100.0);
    EXPECT_NEAR(axis.pixelOf(100.0) - axis.pixelOf(200.0), step, 1e-9);
    EXPECT_NEAR(Axis({0.01, 0.02}, {0, 1}, Scale::Logarithmic).ticks().front(), 0.01, 1e-12);
}

TEST(Axis, HoldsAllItsValues) {
    for (const double low : {0.0013, 0.7, 3.0, 41.0, 12345.0})
        for (const double factor : {1.0, 1.3, 2.0, 7.0, 1000.0})
            for (const Scale scale : {Scale::Linear, Scale::Logarithmic}) {
                const Axis axis({low, low * factor}, {10.0, 20.0}, scale);
                EXPECT_GE(axis.pixelOf(low), 10.0 - 1e-9);
                EXPECT_LE(axis.pixelOf(low * factor), 20.0 + 1e-9);
                EXPECT_LE(axis.ticks().size(), 16u);
            }
}

TEST(Axis, LabelsAreShort) {
    EXPECT_EQ(tickLabel(0.25), "0.25");
    EXPECT_EQ(tickLabel(1500.0), "1500");
    EXPECT_EQ(tickLabel(3 * 0.1), "0.3");
    EXPECT_EQ(tickLabel(1e-17), "0");
}

}  // namespace
}  // namespace lampyris::sandbox::plot
