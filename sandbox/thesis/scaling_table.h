/// \file Tables and plots of paths and radius, beside the Thesis' own columns.
#pragma once

#include <string>
#include <vector>

#include "plot/chart.h"
#include "table.h"
#include "thesis/figures.h"
#include "thesis/printed.h"

namespace lampyris::sandbox::thesis {

/// One way of drawing at one setting, and what the Thesis has there.
struct ScalingRow {
    PrintedRow printed;
    double radiusMetres;
    Figures here;
};

/// Means and standard deviations of cost and error.
[[nodiscard]] Table scalingTable(const std::string& name, const std::string& title,
                                 const std::vector<ScalingRow>& rows);

struct ScalingSample {
    uint32_t paths;
    double radiusMetres;
    double value;
};

/// A line a path count.
[[nodiscard]] plot::Chart chartOverRadius(const std::string& title, const std::string& yLabel,
                                          plot::Scale yScale,
                                          const std::vector<ScalingSample>& samples);

}  // namespace lampyris::sandbox::thesis
