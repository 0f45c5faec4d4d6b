// The Thesis' numbers against what they say of each other: a slip of the finger shows.
#include "thesis/printed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace lampyris::sandbox::thesis {
namespace {

constexpr double kRange = 206.0;  ///< of the Thesis' reference image, as its NRMSE tells

TEST(Printed, NrmseFollowsFromMse) {
    for (const auto table : {table61(), table62()})
        for (const PrintedRow& row : table)
            EXPECT_NEAR(std::sqrt(row.mse) / kRange, row.nrmse, 1.1e-4) << row.mse;
    for (const PrintedSystem& system : table63())
        EXPECT_NEAR(std::sqrt(system.mse) / kRange, system.nrmse, 1.1e-4) << system.name;
}

TEST(Printed, CostsGrowWithPathsAndRadius) {
    const auto rows = table61();
    ASSERT_EQ(rows.size(), 25u);
    for (size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].radiusMetres, kRadiiMetres[i % 5]);
        EXPECT_LT(rows[i].stored, rows[i].paths);
        if (i % 5 > 0) {
            EXPECT_GT(rows[i].milliseconds, rows[i - 1].milliseconds);
        }
        if (i >= 5) {
            EXPECT_GT(rows[i].paths, rows[i - 5].paths);
            EXPECT_GT(rows[i].milliseconds, rows[i - 5].milliseconds);
        }
    }
    for (const PrintedScene& scene : tablesB())
        for (size_t i = 0; i < scene.rows.size(); ++i)
            for (size_t r = 0; r < kRadiiMetres.size(); ++r) {
                const double cost = scene.rows[i].costs[r].milliseconds;
                if (r > 0) {
                    EXPECT_GT(cost, scene.rows[i].costs[r - 1].milliseconds);
                }
                if (i > 0) {
                    EXPECT_GT(cost, scene.rows[i - 1].costs[r].milliseconds);
                }
            }
}

TEST(Printed, TableB1RepeatsTable61) {
    const PrintedScene& boxes = tablesB().front();
    for (size_t i = 0; i < 25; ++i) {
        const PrintedRow& row = table61()[i];
        EXPECT_EQ(boxes.rows[i / 5].paths, row.paths);
        EXPECT_EQ(boxes.rows[i / 5].costs[i % 5].milliseconds, row.milliseconds);
        EXPECT_EQ(boxes.rows[i / 5].costs[i % 5].stddev, row.stddev);
    }
}

TEST(Printed, Table62KeepsItsBudget) {
    const auto rows = table62();
    ASSERT_EQ(rows.size(), 8u);
    for (size_t i = 0; i < rows.size(); ++i) {
        EXPECT_DOUBLE_EQ(rows[i].radiusMetres, 0.25 * static_cast<double>(i + 1));
        EXPECT_NEAR(rows[i].milliseconds, 11.4, 0.11);
        if (i > 0) {
            EXPECT_LT(rows[i].paths, rows[i - 1].paths);
        }
    }
    // 1000 paths at 1.0 m stand in both tables.
    EXPECT_EQ(rows[3].mse, table61()[7].mse);
    EXPECT_EQ(rows[3].mssim, table61()[7].mssim);
}

// Summed apart from this code, from the tables as printed.
TEST(Printed, ColumnsAddUp) {
    double milliseconds = 0.0, mse = 0.0, mssim = 0.0;
    for (const PrintedRow& row : table61()) {
        milliseconds += row.milliseconds;
        mse += row.mse;
        mssim += row.mssim;
    }
    EXPECT_NEAR(milliseconds, 759.8000, 1e-6);
    EXPECT_NEAR(mse, 7257.2700, 1e-6);
    EXPECT_NEAR(mssim, 23.6802, 1e-6);
    const std::array<double, 4> costs{759.8, 872.2, 1370.2, 761.9};
    const std::array<double, 4> spreads{13.38, 12.28, 14.38, 9.80};
    for (size_t i = 0; i < 4; ++i) {
        double cost = 0.0, spread = 0.0;
        for (const PrintedCosts& row : tablesB()[i].rows)
            for (const PrintedCost& c : row.costs) {
                cost += c.milliseconds;
                spread += c.stddev;
            }
        EXPECT_NEAR(cost, costs[i], 1e-6) << tablesB()[i].table;
        EXPECT_NEAR(spread, spreads[i], 1e-6) << tablesB()[i].table;
    }
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
