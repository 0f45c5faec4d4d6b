#include "thesis/figures.h"

#include <gtest/gtest.h>

#include "thesis/content_id.h"

namespace lampyris::sandbox::thesis {
namespace {

Contestant contestantOf(const std::vector<execute::FrameStatistics>& frames) {
    Contestant c{"full"};
    for (const auto& frame : frames) c.series.add(frame);
    return c;
}

execute::FrameStatistics frameOf(double scale) {
    execute::FrameStatistics frame;
    frame.nodes = {{"gbuffer", 1.0 * scale, 0.0},        {"shadow/trace", 2.0 * scale, 0.0},
                   {"sphere_direct", 3.0 * scale, 0.0},  {"photon_trace", 4.0 * scale, 0.0},
                   {"tile_bin/count", 5.0 * scale, 0.0}, {"final_gather", 6.0 * scale, 0.0},
                   {"composite", 7.0 * scale, 0.0}};
    frame.gpuMilliseconds = 30.0 * scale;
    return frame;
}

TEST(Figures, CostsAreSplitAndAddUpToTheFrame) {
    Contestant c = contestantOf({frameOf(1.0), frameOf(3.0)});
    c.photonsStored = {700.0, 710.0};
    c.report.paths = 1000;
    const Figures f = costsOf(c);
    EXPECT_DOUBLE_EQ(f.at(kFrame).mean, 60.0);
    EXPECT_DOUBLE_EQ(f.at(kFrame).stddev, 30.0);
    EXPECT_DOUBLE_EQ(f.at(kDirect).mean, 26.0);
    EXPECT_DOUBLE_EQ(f.at(kTrace).mean, 8.0);
    EXPECT_DOUBLE_EQ(f.at(kEstimate).mean, 22.0) << "whatever is not direct light nor tracing";
    EXPECT_DOUBLE_EQ(f.at(kBetween).mean, 4.0);
    EXPECT_DOUBLE_EQ(f.at(kStored).mean, 705.0);
    EXPECT_DOUBLE_EQ(f.at(kPaths).mean, 1000.0);
    EXPECT_EQ(indirectMilliseconds(c), (std::vector<double>{15.0, 45.0}));
}

TEST(Figures, ErrorsAreMeanAndSpreadOverPictures) {
    core::Image black(16, 16, 3), white(16, 16, 3);
    for (float& value : white.values) value = 1.0f;
    const core::DisplayTransform display{};
    const auto reference = evaluation::fromLinear("reference", black, display).value();
    const std::vector<core::Image> pictures{black, white};
    const Figures f = errorsOf(pictures, reference, display).value();
    EXPECT_DOUBLE_EQ(f.at("MSE").mean, 0.5 * 255.0 * 255.0);
    EXPECT_DOUBLE_EQ(f.at("MSE").stddev, 0.5 * 255.0 * 255.0);
    for (const char* name : {"NRMSE", "MSSIM", "FLIP", "relMSE"}) EXPECT_EQ(f.count(name), 1u);

    const std::vector<core::Image> other{core::Image(20, 16, 3)};
    EXPECT_FALSE(errorsOf(other, reference, display).ok());
}

TEST(Figures, ContentIdTellsBytesApart) {
    EXPECT_EQ(idOf(std::string("")), "cbf29ce484222325");  // FNV-1a's own test values
    EXPECT_EQ(idOf(std::string("a")), "af63dc4c8601ec8c");
    EXPECT_EQ(idOf(std::string("foobar")), "85944171f73967e8");
    EXPECT_EQ(programId().value(), programId().value());
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
