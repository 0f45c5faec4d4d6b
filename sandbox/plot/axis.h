/// \file From values to pixels, and the values that are marked on the way.
#pragma once

#include <string>
#include <vector>

namespace lampyris::sandbox::plot {

struct Range {
    double low = 0.0;
    double high = 1.0;
};

enum class Scale { Linear, Logarithmic };

/// Runs over the values given, widened to whole steps; a logarithmic one must be over values
/// above 0.
class Axis {
 public:
    Axis(Range values, Range pixels, Scale scale = Scale::Linear);

    [[nodiscard]] double pixelOf(double value) const;
    /// At steps of 1, 2 or 5 times a power of ten; all within the axis.
    [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }
    [[nodiscard]] Range values() const { return values_; }

 private:
    Range values_, pixels_;
    Scale scale_;
    std::vector<double> ticks_;
};

/// The shortest text that tells the value to six digits: "0.25", "1500".
[[nodiscard]] std::string tickLabel(double value);

}  // namespace lampyris::sandbox::plot
