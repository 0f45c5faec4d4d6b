#include "plot/panel.h"

#include <array>

namespace lampyris::sandbox::plot {
namespace {

constexpr double kLeft = 66.0, kRight = 18.0, kTop = 34.0, kBottom = 106.0;
constexpr double kTick = 4.0;
constexpr double kLabelSize = 11.0;
constexpr size_t kLegendColumns = 2;

const Stroke kAxisStroke{"#333333", 1.0};
const Stroke kGridStroke{"#dddddd", 1.0};

}  // namespace

std::string colourOf(size_t index) {
    constexpr std::array<const char*, 8> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#f0e442", "#000000"};
    return kColours[index % kColours.size()];
}

PlotArea plotAreaOf(Point topLeft) {
    return {{topLeft.x + kLeft, topLeft.x + kPanelWidth - kRight},
            {topLeft.y + kPanelHeight - kBottom, topLeft.y + kTop}};
}

void drawTitle(Svg& svg, Point topLeft, const std::string& title) {
    const PlotArea area = plotAreaOf(topLeft);
    svg.text({0.5 * (area.x.low + area.x.high), topLeft.y + 0.6 * kTop}, title,
             {Anchor::Middle, 13.0, 0.0, true});
}

void drawVerticalAxis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label) {
    for (const double tick : axis.ticks()) {
        const double y = axis.pixelOf(tick);
        svg.line({area.x.low, y}, {area.x.high, y}, kGridStroke);
        svg.line({area.x.low - kTick, y}, {area.x.low, y}, kAxisStroke);
        svg.text({area.x.low - 2.0 * kTick, y + 0.35 * kLabelSize}, tickLabel(tick),
                 {Anchor::End, kLabelSize});
    }
    svg.line({area.x.low, area.y.low}, {area.x.low, area.y.high}, kAxisStroke);
    svg.text({area.x.low - 48.0, 0.5 * (area.y.low + area.y.high)}, label,
             {Anchor::Middle, kLabelSize, -90.0});
}

void drawHorizontalAxis(Svg& svg, const PlotArea& area, const Axis& axis,
                        const std::string& label) {
    for (const double tick : axis.ticks()) {
        const double x = axis.pixelOf(tick);
        svg.line({x, area.y.low}, {x, area.y.low + kTick}, kAxisStroke);
        svg.text({x, area.y.low + kTick + 1.2 * kLabelSize}, tickLabel(tick),
                 {Anchor::Middle, kLabelSize});
    }
    svg.line({area.x.low, area.y.low}, {area.x.high, area.y.low}, kAxisStroke);
    svg.text({0.5 * (area.x.low + area.x.high), area.y.low + 34.0}, label,
             {Anchor::Middle, kLabelSize});
}

void drawLegend(Svg& svg, Point topLeft, const std::vector<LegendEntry>& entries) {
    const PlotArea area = plotAreaOf(topLeft);
    const double column = (area.x.high - area.x.low) / kLegendColumns;
    for (size_t i = 0; i < entries.size(); ++i) {
        const LegendEntry& entry = entries[i];
        const double x = area.x.low + column * static_cast<double>(i % kLegendColumns);
        const size_t row = i / kLegendColumns;
        const double y = area.y.low + 56.0 + 15.0 * static_cast<double>(row);
        if (entry.line)
            svg.line({x, y - 4.0}, {x + 20.0, y - 4.0}, {entry.colour, 2.0, entry.dashed});
        else
            svg.rectangle({x + 5.0, y - 9.0}, 10.0, 10.0, entry.colour);
        svg.text({x + 26.0, y}, entry.name, {Anchor::Start, kLabelSize});
    }
}

}  // namespace lampyris::sandbox::plot
