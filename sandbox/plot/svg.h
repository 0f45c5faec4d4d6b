/// \file A picture of lines, rectangles, circles and text, as SVG.
#pragma once

#include <span>
#include <string>

namespace lampyris::sandbox::plot {

/// Pixels, from the top left.
struct Point {
    double x = 0.0;
    double y = 0.0;
};

struct Stroke {
    std::string colour = "#333333";
    double width = 1.0;
    bool dashed = false;
};

enum class Anchor { Start, Middle, End };

struct TextStyle {
    Anchor anchor = Anchor::Start;
    double size = 12.0;    ///< pixels
    double degrees = 0.0;  ///< clockwise about its place
    bool bold = false;
};

/// On a white ground. All numbers must be finite.
class Svg {
 public:
    Svg(double width, double height);

    void line(Point from, Point to, const Stroke& stroke);
    void polyline(std::span<const Point> points, const Stroke& stroke);
    void rectangle(Point topLeft, double width, double height, const std::string& fill);
    void circle(Point centre, double radius, const std::string& fill);
    /// The place is the baseline's start, middle or end.
    void text(Point place, const std::string& text, const TextStyle& style = {});

    /// The whole file.
    [[nodiscard]] std::string finish() const { return body_ + "</svg>\n"; }

 private:
    std::string body_;
};

}  // namespace lampyris::sandbox::plot
