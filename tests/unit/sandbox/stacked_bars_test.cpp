#include "plot/stacked_bars.h"

#include "unit/sandbox/svg_reader.h"

namespace lampyris::sandbox::plot {
namespace {

/// The bars' rectangles, without the ground and the legend.
std::vector<Element> partsOf(const std::string& svg, size_t count) {
    auto all = elementsNamed(svg, "rect");
    all.erase(all.begin());
    all.resize(count);
    return all;
}

TEST(StackedBars, PartsStandOnEachOther) {
    const StackedBars chart{
        "Costs", "ms", {"first", "second"}, {{"a", "(1)", {2.0, 6.0}}, {"b", "(2)", {4.0, -1.0}}}};
    const std::string svg = sideBySide(std::vector{chart});
    const PlotArea area = plotAreaOf({0.0, 0.0});
    const double unit = (area.y.low - area.y.high) / 8.0;  // the highest bar is 8
    const auto parts = partsOf(svg, 4);
    EXPECT_NEAR(parts[0].number("height"), 2.0 * unit, 0.02);
    EXPECT_NEAR(parts[0].number("y") + parts[0].number("height"), area.y.low, 0.02);
    EXPECT_NEAR(parts[1].number("height"), 6.0 * unit, 0.02);
    EXPECT_NEAR(parts[1].number("y") + parts[1].number("height"), parts[0].number("y"), 0.02);
    EXPECT_NEAR(parts[2].number("height"), 4.0 * unit, 0.02);
    EXPECT_EQ(parts[3].number("height"), 0.0) << "less than nothing is nothing";
    EXPECT_NE(parts[0].attributes.at("fill"), parts[1].attributes.at("fill"));
    EXPECT_EQ(parts[0].attributes.at("fill"), parts[2].attributes.at("fill"));
    EXPECT_GT(parts[2].number("x"), parts[0].number("x") + parts[0].number("width"));
}

TEST(StackedBars, AreLabelled) {
    const StackedBars chart{"Costs", "ms", {"first", "second"}, {{"a", "(1)", {2.0, 6.0}}}};
    const std::string svg = sideBySide(std::vector{chart});
    for (const char* label : {"Costs", "ms", "first", "second", "(1)"}) labelled(svg, label);
    const Element bar = partsOf(svg, 1)[0];
    EXPECT_NEAR(labelled(svg, "a").number("x"), bar.number("x") + 0.5 * bar.number("width"), 0.02);
}

TEST(StackedBars, ABarForEachPartOrNone) {
    const StackedBars chart{"Costs", "ms", {"first", "second"}, {{"a", "", {2.0}}}};
    EXPECT_DEATH(sideBySide(std::vector{chart}), "parts");
}

}  // namespace
}  // namespace lampyris::sandbox::plot
