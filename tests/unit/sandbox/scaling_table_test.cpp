#include "thesis/scaling_table.h"

#include <gtest/gtest.h>

namespace lampyris::sandbox::thesis {
namespace {

ScalingRow rowOf(const PrintedRow& printed) {
    return {printed,
            printed.radiusMetres,
            {{kPaths, {1000.0, 0.0}},
             {kStored, {703.4, 2.0}},
             {kFrame, {33.26, 1.234}},
             {"MSE", {150.126, 2.5}},
             {"NRMSE", {0.05, 0.0}},
             {"MSSIM", {0.97, 0.001}},
             {"FLIP", {0.1, 0.0}}}};
}

TEST(ScalingTable, StandsBesideTheThesis) {
    const Table table = scalingTable("full", "A title", {rowOf(table61()[7])});
    ASSERT_EQ(table.rows.size(), 1u);
    ASSERT_EQ(table.rows[0].size(), table.header.size());
    const auto cell = [&](const std::string& column) {
        for (size_t i = 0; i < table.header.size(); ++i)
            if (table.header[i] == column) return table.rows[0][i];
        return "no column " + column;
    };
    EXPECT_EQ(cell("paths"), "1000");
    EXPECT_EQ(cell("radius m"), "1.00");
    EXPECT_EQ(cell("stored"), "703");
    EXPECT_EQ(cell("ms"), "33.3");
    EXPECT_EQ(cell("σ ms"), "1.23");
    EXPECT_EQ(cell("MSE"), "150.13");
    EXPECT_EQ(cell("σ MSE"), "2.50");
    EXPECT_EQ(cell("paper stored"), "703");
    EXPECT_EQ(cell("paper ms"), "11.3");
    EXPECT_EQ(cell("paper σ ms"), "2.24");
    EXPECT_EQ(cell("paper MSE"), "167.09");
    EXPECT_EQ(cell("paper NRMSE"), "0.0627");
    EXPECT_EQ(cell("paper MSSIM"), "0.9607");
}

TEST(ScalingTable, ChartHasALineAPathCount) {
    const plot::Chart chart =
        chartOverRadius("title", "MSE", plot::Scale::Linear,
                        {{500, 0.25, 9.0}, {500, 0.5, 4.0}, {1000, 0.25, 7.0}});
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.series[0].name, "500 paths");
    ASSERT_EQ(chart.series[0].points.size(), 2u);
    EXPECT_EQ(chart.series[0].points[1].x, 0.5);
    EXPECT_EQ(chart.series[0].points[1].y, 4.0);
    EXPECT_EQ(chart.series[1].points.size(), 1u);
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
