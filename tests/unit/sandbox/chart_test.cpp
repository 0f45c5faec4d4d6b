#include "plot/chart.h"

#include "unit/sandbox/svg_reader.h"

namespace lampyris::sandbox::plot {
namespace {

Chart twoSeries() {
    Chart chart{"A title", "radius", "error", Scale::Linear, {}};
    chart.series.push_back({"lower", {{0.0, 0.0}, {5.0, 5.0}, {10.0, 10.0}}});
    chart.series.push_back({"upper", {{0.0, 10.0}, {10.0, 8.0}}});
    return chart;
}

TEST(Chart, PointsStandWhereTheirValuesBelong) {
    const std::string svg = sideBySide(std::vector{twoSeries()});
    const PlotArea area = plotAreaOf({0.0, 0.0});
    const auto circles = elementsNamed(svg, "circle");
    ASSERT_EQ(circles.size(), 5u);
    EXPECT_NEAR(circles[0].number("cx"), area.x.low, 0.01);
    EXPECT_NEAR(circles[0].number("cy"), area.y.low, 0.01);
    EXPECT_NEAR(circles[1].number("cx"), 0.5 * (area.x.low + area.x.high), 0.01);
    EXPECT_NEAR(circles[1].number("cy"), 0.5 * (area.y.low + area.y.high), 0.01);
    EXPECT_NEAR(circles[2].number("cx"), area.x.high, 0.01);
    EXPECT_NEAR(circles[2].number("cy"), area.y.high, 0.01);
    EXPECT_NEAR(circles[3].number("cy"), area.y.high, 0.01);
    EXPECT_NE(circles[0].attributes.at("fill"), circles[3].attributes.at("fill"));
}

TEST(Chart, IsLabelled) {
    const std::string svg = sideBySide(std::vector{twoSeries()});
    for (const char* label : {"A title", "radius", "error", "lower", "upper"}) labelled(svg, label);
    // The mark of a value stands beside the point of that value.
    const auto circles = elementsNamed(svg, "circle");
    std::vector<Element> tens;
    for (const Element& text : elementsNamed(svg, "text"))
        if (text.text == "10") tens.push_back(text);
    ASSERT_EQ(tens.size(), 2u) << "one an axis";
    EXPECT_NEAR(tens[0].number("y"), circles[2].number("cy"), 5.0);
    EXPECT_NEAR(tens[1].number("x"), circles[2].number("cx"), 0.01);
}

TEST(Chart, LeavesOutWhatALogarithmHasNoPlaceFor) {
    Chart chart = twoSeries();
    chart.yScale = Scale::Logarithmic;
    EXPECT_EQ(elementsNamed(sideBySide(std::vector{chart}), "circle").size(), 4u);
    chart.series = {{"nothing", {{1.0, 0.0}, {2.0, -3.0}}}};
    EXPECT_TRUE(elementsNamed(sideBySide(std::vector{chart}), "circle").empty());
}

TEST(Chart, SharesARangeAndAPicture) {
    Chart first = twoSeries();
    Chart second = twoSeries();
    second.series = {{"low", {{0.0, 0.0}, {10.0, 1.0}}}};
    for (Chart* chart : {&first, &second}) chart->y = Range{0.0, 10.0};
    const std::string svg = sideBySide(std::vector{first, second});
    const auto circles = elementsNamed(svg, "circle");
    ASSERT_EQ(circles.size(), 7u);
    EXPECT_NEAR(circles[5].number("cx"), circles[0].number("cx") + kPanelWidth, 0.01);
    const PlotArea area = plotAreaOf({0.0, 0.0});
    EXPECT_NEAR(circles[6].number("cy"), area.y.low + 0.1 * (area.y.high - area.y.low), 0.01);
}

}  // namespace
}  // namespace lampyris::sandbox::plot
