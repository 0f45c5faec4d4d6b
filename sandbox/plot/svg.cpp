#include "plot/svg.h"

#include <fmt/format.h>

#include <cmath>

#include "core/check.h"

namespace lampyris::sandbox::plot {
namespace {

/// A hundredth of a pixel is finer than any screen.
std::string number(double value) {
    CHECK(std::isfinite(value));
    return fmt::format("{:.2f}", value);
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string strokeOf(const Stroke& stroke) {
    return fmt::format(R"(stroke="{}" stroke-width="{}"{})", escaped(stroke.colour),
                       number(stroke.width), stroke.dashed ? R"( stroke-dasharray="5 3")" : "");
}

const char* nameOf(Anchor anchor) {
    switch (anchor) {
        case Anchor::Start:
            return "start";
        case Anchor::Middle:
            return "middle";
        case Anchor::End:
            break;
    }
    return "end";
}

}  // namespace

Svg::Svg(double width, double height) {
    body_ = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" )"
        R"(font-family="DejaVu Sans, Verdana, sans-serif">)"
        "\n",
        number(width), number(height));
    rectangle({0.0, 0.0}, width, height, "#ffffff");
}

void Svg::line(Point from, Point to, const Stroke& stroke) {
    body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(from.x),
                         number(from.y), number(to.x), number(to.y), strokeOf(stroke));
}

void Svg::polyline(std::span<const Point> points, const Stroke& stroke) {
    std::string places;
    for (const Point& p : points)
        places += fmt::format("{}{},{}", places.empty() ? "" : " ", number(p.x), number(p.y));
    body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", places, strokeOf(stroke));
}

void Svg::rectangle(Point topLeft, double width, double height, const std::string& fill) {
    body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                         number(topLeft.x), number(topLeft.y), number(width), number(height),
                         escaped(fill));
}

void Svg::circle(Point centre, double radius, const std::string& fill) {
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", number(centre.x),
                         number(centre.y), number(radius), escaped(fill));
}

void Svg::text(Point place, const std::string& text, const TextStyle& style) {
    const std::string turned =
        style.degrees == 0.0 ? ""
                             : fmt::format(" transform=\"rotate({} {} {})\"", number(style.degrees),
                                           number(place.x), number(place.y));
    body_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}{} "
        "fill=\"#222222\">{}</text>\n",
        number(place.x), number(place.y), number(style.size), nameOf(style.anchor),
        style.bold ? " font-weight=\"bold\"" : "", turned, escaped(text));
}

}  // namespace lampyris::sandbox::plot
