/// \file Bars of parts that stand on each other.
#pragma once

#include <string>
#include <vector>

#include "plot/panel.h"

namespace lampyris::sandbox::plot {

struct Bar {
    std::string label, subLabel;  ///< below it, in two lines
    std::vector<double> parts;    ///< from the bottom; what is below 0 counts as 0
};

struct StackedBars {
    std::string title, yLabel;
    std::vector<std::string> parts;  ///< their names; one alone needs no legend
    std::vector<Bar> bars;           ///< each with as many parts
};

void draw(Svg& svg, Point topLeft, const StackedBars& chart);

}  // namespace lampyris::sandbox::plot
