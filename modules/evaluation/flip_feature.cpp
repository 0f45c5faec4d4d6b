#include "evaluation/flip_feature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lampyris::evaluation {
namespace {

// [eq] Andersson et al. 2020: how wide a line the eye detects, and the exponent of features.
constexpr double kFeatureDegrees = 0.082;
constexpr double kFeatureExponent = 0.5;

struct Detectors {
    std::vector<double> smooth, edge, point;
};

struct Features {
    Plane edges, points;  ///< magnitudes
};

/// Weights above 0 get the sum 1, and those below it −1.
void balance(std::vector<double>& weights) {
    double above = 0.0;
    double below = 0.0;
    for (const double weight : weights) (weight > 0.0 ? above : below) += std::abs(weight);
    for (double& weight : weights) weight /= weight > 0.0 ? above : below;
}

/// A Gaussian, and its first and second derivative.
Detectors detectorsFor(double pixelsPerDegree) {
    const double sigma = 0.5 * kFeatureDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    Detectors detectors{gaussian(sigma, radius), {}, {}};
    for (int x = -radius; x <= radius; ++x) {
        const double weight = detectors.smooth[detectors.edge.size()];
        detectors.edge.push_back(-x * weight);
        detectors.point.push_back((x * x / (sigma * sigma) - 1.0) * weight);
    }
    balance(detectors.edge);
    balance(detectors.point);
    return detectors;
}

Plane magnitude(const Plane& horizontal, const Plane& vertical) {
    Plane result(horizontal.width, horizontal.height);
    for (size_t p = 0; p < result.values.size(); ++p)
        result.values[p] = std::hypot(horizontal.values[p], vertical.values[p]);
    return result;
}

Features detect(const Plane& luminance, const Detectors& d) {
    const Plane smooth = filterRows(luminance, d.smooth);
    const auto across = [&](const std::vector<double>& kernel) {
        return magnitude(filterColumns(filterRows(luminance, kernel), d.smooth),
                         filterColumns(smooth, kernel));
    };
    return {across(d.edge), across(d.point)};
}

}  // namespace

Plane featureDifference(const Plane& luminanceA, const Plane& luminanceB, double pixelsPerDegree) {
    const Detectors detectors = detectorsFor(pixelsPerDegree);
    const Features a = detect(luminanceA, detectors);
    const Features b = detect(luminanceB, detectors);
    Plane result(luminanceA.width, luminanceA.height);
    for (size_t p = 0; p < result.values.size(); ++p) {
        const double strongest = std::max(std::abs(a.edges.values[p] - b.edges.values[p]),
                                          std::abs(a.points.values[p] - b.points.values[p]));
        result.values[p] =
            std::min(std::pow(strongest / std::numbers::sqrt2, kFeatureExponent), 1.0);
    }
    return result;
}

}  // namespace lampyris::evaluation
