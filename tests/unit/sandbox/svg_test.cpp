#include "plot/svg.h"

#include <array>
#include <cmath>

#include "unit/sandbox/svg_reader.h"

namespace lampyris::sandbox::plot {
namespace {

TEST(Svg, ShapesStandWhereTheyWereDrawn) {
    Svg svg(200.0, 100.0);
    svg.line({1.0, 2.0}, {3.0, 4.5}, {"#ff0000", 2.0, true});
    svg.circle({10.0, 20.0}, 3.0, "#00ff00");
    svg.rectangle({5.0, 6.0}, 7.0, 8.0, "#0000ff");
    svg.polyline(std::array{Point{0.0, 1.0}, Point{2.0, 3.25}}, {});
    const auto all = readSvg(svg.finish());
    ASSERT_EQ(all.size(), 6u);
    EXPECT_EQ(all[0].attributes.at("viewBox"), "0 0 200.00 100.00");
    EXPECT_EQ(all[1].number("width"), 200.0) << "the white ground";
    EXPECT_EQ(all[2].number("y2"), 4.5);
    EXPECT_EQ(all[2].attributes.at("stroke"), "#ff0000");
    EXPECT_EQ(all[2].attributes.count("stroke-dasharray"), 1u);
    EXPECT_EQ(all[3].number("cx"), 10.0);
    EXPECT_EQ(all[4].number("height"), 8.0);
    EXPECT_EQ(all[5].attributes.at("points"), "0.00,1.00 2.00,3.25");
    EXPECT_EQ(all[5].attributes.at("fill"), "none");
}

TEST(Svg, TextIsEscapedAndTurned) {
    Svg svg(10.0, 10.0);
    svg.text({1.0, 2.0}, "a < b & \"c\" > d", {Anchor::End, 9.0, -90.0, true});
    const auto texts = elementsNamed(svg.finish(), "text");
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_EQ(texts[0].text, "a &lt; b &amp; &quot;c&quot; &gt; d");
    EXPECT_EQ(texts[0].attributes.at("text-anchor"), "end");
    EXPECT_EQ(texts[0].attributes.at("transform"), "rotate(-90.00 1.00 2.00)");
}

TEST(Svg, RefusesWhatIsNoNumber) {
    Svg svg(10.0, 10.0);
    EXPECT_DEATH(svg.circle({NAN, 0.0}, 1.0, "#000000"), "isfinite");
}

}  // namespace
}  // namespace lampyris::sandbox::plot
