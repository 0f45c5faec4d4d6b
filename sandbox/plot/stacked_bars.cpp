#include "plot/stacked_bars.h"

#include <algorithm>

#include "core/check.h"

namespace lampyris::sandbox::plot {
namespace {

constexpr double kBarShare = 0.7;  ///< of the room from bar to bar
constexpr double kMostWidth = 60.0;
constexpr double kLabelSize = 10.0;

double highestOf(const std::vector<Bar>& bars) {
    double highest = 0.0;
    for (const Bar& bar : bars) {
        double sum = 0.0;
        for (const double part : bar.parts) sum += std::max(part, 0.0);
        highest = std::max(highest, sum);
    }
    return highest;
}

void drawBar(Svg& svg, const Bar& bar, double middle, double width, const Axis& y) {
    double sum = 0.0;
    for (size_t i = 0; i < bar.parts.size(); ++i) {
        const double below = y.pixelOf(sum);
        sum += std::max(bar.parts[i], 0.0);
        const double above = y.pixelOf(sum);
        svg.rectangle({middle - 0.5 * width, above}, width, below - above, colourOf(i));
    }
    const double ground = y.pixelOf(0.0);
    svg.text({middle, ground + 15.0}, bar.label, {Anchor::Middle, kLabelSize});
    svg.text({middle, ground + 28.0}, bar.subLabel, {Anchor::Middle, kLabelSize});
}

}  // namespace

void draw(Svg& svg, Point topLeft, const StackedBars& chart) {
    drawTitle(svg, topLeft, chart.title);
    const PlotArea area = plotAreaOf(topLeft);
    const Axis y({0.0, highestOf(chart.bars)}, area.y);
    drawVerticalAxis(svg, area, y, chart.yLabel);
    const double step = (area.x.high - area.x.low) / static_cast<double>(chart.bars.size());
    for (size_t i = 0; i < chart.bars.size(); ++i) {
        CHECK(chart.bars[i].parts.size() == chart.parts.size());
        const double middle = area.x.low + (static_cast<double>(i) + 0.5) * step;
        drawBar(svg, chart.bars[i], middle, std::min(kBarShare * step, kMostWidth), y);
    }
    svg.line({area.x.low, area.y.low}, {area.x.high, area.y.low}, {});
    if (chart.parts.size() < 2) return;
    std::vector<LegendEntry> legend;
    for (size_t i = 0; i < chart.parts.size(); ++i)
        legend.push_back({chart.parts[i], colourOf(i), false, false});
    drawLegend(svg, topLeft, legend);
}

}  // namespace lampyris::sandbox::plot
