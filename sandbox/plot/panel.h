/// \file What all plots have round them: a title, axes with marks and labels, a legend below.
#pragma once

#include <string>
#include <vector>

#include "plot/axis.h"
#include "plot/svg.h"

namespace lampyris::sandbox::plot {

constexpr double kPanelWidth = 440.0;  ///< pixels
constexpr double kPanelHeight = 400.0;

/// Colours that differ for colour-blind eyes too (Okabe and Ito); the ninth is the first again.
[[nodiscard]] std::string colourOf(size_t index);

/// Where a panel's plot lies on the picture, below its title.
struct PlotArea {
    Range x, y;  ///< pixels; y.low is the bottom
};
[[nodiscard]] PlotArea plotAreaOf(Point topLeft);

struct LegendEntry {
    std::string name;
    std::string colour;
    bool dashed = false;
    bool line = true;  ///< else a square
};

void drawTitle(Svg& svg, Point topLeft, const std::string& title);
/// The vertical axis with a light line across the plot at each mark.
void drawVerticalAxis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label);
void drawHorizontalAxis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label);
void drawLegend(Svg& svg, Point topLeft, const std::vector<LegendEntry>& entries);

/// Panels from left to right on one picture. `draw(svg, topLeft, panel)` draws one.
template <typename Panel>
std::string sideBySide(const std::vector<Panel>& panels) {
    Svg svg(kPanelWidth * static_cast<double>(panels.size()), kPanelHeight);
    for (size_t i = 0; i < panels.size(); ++i)
        draw(svg, {kPanelWidth * static_cast<double>(i), 0.0}, panels[i]);
    return svg.finish();
}

}  // namespace lampyris::sandbox::plot
