/// \file Lines and points over two axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plot/panel.h"

namespace lampyris::sandbox::plot {

struct Series {
    std::string name;
    std::vector<Point> points;  ///< values, from left to right
    bool line = true, markers = true, dashed = false;
};

struct Chart {
    std::string title, xLabel, yLabel;
    Scale yScale = Scale::Linear;
    std::vector<Series> series;
    std::optional<Range> y{};  ///< shown at least: the same for charts to compare
};

/// Points that have no place on a logarithmic axis (0 and less) are left out; so is all where
/// nothing is left.
void draw(Svg& svg, Point topLeft, const Chart& chart);

}  // namespace lampyris::sandbox::plot
