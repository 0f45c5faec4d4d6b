#include "plot/chart.h"

#include <algorithm>
#include <limits>

namespace lampyris::sandbox::plot {
namespace {

Series withoutMissing(const Series& series, Scale scale) {
    Series kept = series;
    if (scale == Scale::Logarithmic)
        std::erase_if(kept.points, [](const Point& p) { return p.y <= 0.0; });
    return kept;
}

struct Bounds {
    Range x{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    Range y = x;
};

void widen(Range& range, double value) {
    range = {std::min(range.low, value), std::max(range.high, value)};
}

Bounds boundsOf(const std::vector<Series>& all, const std::optional<Range>& shown) {
    Bounds bounds;
    for (const Series& series : all)
        for (const Point& p : series.points) {
            widen(bounds.x, p.x);
            widen(bounds.y, p.y);
        }
    if (shown)
        for (const double value : {shown->low, shown->high}) widen(bounds.y, value);
    return bounds;
}

void drawSeries(Svg& svg, const Series& series, const std::string& colour, const Axis& x,
                const Axis& y) {
    std::vector<Point> places;
    for (const Point& p : series.points) places.push_back({x.pixelOf(p.x), y.pixelOf(p.y)});
    if (series.line) svg.polyline(places, {colour, 2.0, series.dashed});
    if (!series.markers) return;
    for (const Point& place : places) svg.circle(place, 3.0, colour);
}

}  // namespace

void draw(Svg& svg, Point topLeft, const Chart& chart) {
    drawTitle(svg, topLeft, chart.title);
    std::vector<Series> all;
    for (const Series& series : chart.series) all.push_back(withoutMissing(series, chart.yScale));
    std::erase_if(all, [](const Series& series) { return series.points.empty(); });
    if (all.empty()) return;
    const Bounds bounds = boundsOf(all, chart.y);
    const PlotArea area = plotAreaOf(topLeft);
    const Axis x(bounds.x, area.x);
    const Axis y(bounds.y, area.y, chart.yScale);
    drawVerticalAxis(svg, area, y, chart.yLabel);
    drawHorizontalAxis(svg, area, x, chart.xLabel);
    std::vector<LegendEntry> legend;
    for (size_t i = 0; i < all.size(); ++i) {
        drawSeries(svg, all[i], colourOf(i), x, y);
        legend.push_back({all[i].name, colourOf(i), all[i].dashed, all[i].line});
    }
    drawLegend(svg, topLeft, legend);
}

}  // namespace lampyris::sandbox::plot
