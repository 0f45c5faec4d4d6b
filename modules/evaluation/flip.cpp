#include "evaluation/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "evaluation/flip_colour.h"
#include "evaluation/flip_feature.h"
#include "evaluation/plane.h"

namespace lampyris::evaluation {
namespace {

using Planes = std::array<Plane, 3>;

/// A term of the eye's sensitivity to contrast: height · exp(−spread · frequency²), per degree.
struct ContrastTerm {
    double height, spread;
};
// [eq] Andersson et al. 2020, table 1: Y, Cx, and the two terms of Cz.
constexpr ContrastTerm kLight{1.0, 0.0047};
constexpr ContrastTerm kRedGreen{1.0, 0.0053};
constexpr ContrastTerm kBlueYellowWide{34.1, 0.04};
constexpr ContrastTerm kBlueYellowNarrow{13.5, 0.025};

// [eq] Andersson et al. 2020: exponent of colours, and the two ends of the piece that maps the
// lower 40 % of differences to 95 % of the scale.
constexpr double kColourExponent = 0.7;
constexpr double kKneeIn = 0.4;
constexpr double kKneeOut = 0.95;

double sigmaInPixels(const ContrastTerm& term) {
    return kPixelsPerDegree * std::sqrt(0.5 * term.spread) / std::numbers::pi;
}

std::vector<double> kernelOf(const ContrastTerm& term) {
    return gaussian(sigmaInPixels(term),
                    static_cast<int>(std::ceil(3.0 * sigmaInPixels(kBlueYellowWide))));
}

Plane blur(const Plane& plane, const std::vector<double>& kernel) {
    return filterColumns(filterRows(plane, kernel), kernel);
}

/// What the sum of a term's weights over its square is, before it is brought to 1.
double weightOf(const ContrastTerm& term, const std::vector<double>& kernel) {
    const double sum = 1.0 / kernel[kernel.size() / 2];
    return term.height * std::sqrt(std::numbers::pi / term.spread) * sum * sum;
}

Plane blurBlueYellow(const Plane& plane) {
    const auto wide = kernelOf(kBlueYellowWide);
    const auto narrow = kernelOf(kBlueYellowNarrow);
    const double wideWeight = weightOf(kBlueYellowWide, wide);
    const double share = wideWeight / (wideWeight + weightOf(kBlueYellowNarrow, narrow));
    Plane blurred = blur(plane, wide);
    const Plane other = blur(plane, narrow);
    for (size_t p = 0; p < blurred.values.size(); ++p)
        blurred.values[p] = share * blurred.values[p] + (1.0 - share) * other.values[p];
    return blurred;
}

Planes opponentPlanes(const core::DisplayImage& image) {
    std::array<double, 256> decoded{};
    for (size_t v = 0; v < decoded.size(); ++v)
        decoded[v] = core::decodeSrgb(static_cast<float>(v) / 255.0f);
    Planes planes;
    planes.fill(Plane(image.width, image.height));
    for (size_t p = 0; p < planes[0].values.size(); ++p) {
        const uint8_t* rgb = image.values.data() + p * 3;
        const Colour opponent = opponentOf({decoded[rgb[0]], decoded[rgb[1]], decoded[rgb[2]]});
        for (size_t c = 0; c < 3; ++c) planes[c].values[p] = opponent[c];
    }
    return planes;
}

Plane luminanceOf(const Planes& opponent) {
    Plane luminance = opponent[0];
    for (double& value : luminance.values) value = (value + 16.0) / 116.0;
    return luminance;
}

/// What reaches the eye of each pixel, as a colour of even differences.
std::vector<Colour> perceive(const Planes& opponent) {
    const Planes seen{blur(opponent[0], kernelOf(kLight)), blur(opponent[1], kernelOf(kRedGreen)),
                      blurBlueYellow(opponent[2])};
    std::vector<Colour> colours(seen[0].values.size());
    for (size_t p = 0; p < colours.size(); ++p)
        colours[p] =
            huntLabOf(screenColourOf({seen[0].values[p], seen[1].values[p], seen[2].values[p]}));
    return colours;
}

/// From a distance of colours to 0 … 1, most of which small differences get.
double redistribute(double distance) {
    static const double kMost = std::pow(
        hyabDistance(huntLabOf({0.0, 1.0, 0.0}), huntLabOf({0.0, 0.0, 1.0})), kColourExponent);
    const double share = std::pow(distance, kColourExponent) / kMost;
    return share < kKneeIn ? share * kKneeOut / kKneeIn
                           : kKneeOut + (share - kKneeIn) / (1.0 - kKneeIn) * (1.0 - kKneeOut);
}

}  // namespace

core::Result<Measure> flip(const Picture& image, const Picture& reference) {
    TRY_VOID(checkComparable(image, reference));
    const Planes a = opponentPlanes(image.display);
    const Planes b = opponentPlanes(reference.display);
    const Plane features = featureDifference(luminanceOf(a), luminanceOf(b), kPixelsPerDegree);
    const std::vector<Colour> coloursA = perceive(a);
    const std::vector<Colour> coloursB = perceive(b);
    Measure measure{0.0, core::Image(image.display.width, image.display.height, 1)};
    for (size_t p = 0; p < coloursA.size(); ++p) {
        const double colour = redistribute(hyabDistance(coloursA[p], coloursB[p]));
        const double difference = std::pow(colour, 1.0 - features.values[p]);
        measure.map.values[p] = static_cast<float>(difference);
        measure.value += difference;
    }
    measure.value /= static_cast<double>(coloursA.size());
    return measure;
}

}  // namespace lampyris::evaluation
