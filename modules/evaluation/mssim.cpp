#include "evaluation/mssim.h"

#include "evaluation/plane.h"

namespace lampyris::evaluation {
namespace {

// [eq] Wang et al. 2004, section III.C.
constexpr double kSigma = 1.5;
constexpr double kC1 = (0.01 * 255.0) * (0.01 * 255.0);
constexpr double kC2 = (0.03 * 255.0) * (0.03 * 255.0);
constexpr uint32_t kRadius = kSsimWindow / 2;

Plane weigh(const Plane& plane) {
    const auto kernel = gaussian(kSigma, kRadius);
    return filterColumns(filterRows(plane, kernel), kernel);
}

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (size_t p = 0; p < a.values.size(); ++p) result.values[p] = a.values[p] * b.values[p];
    return result;
}

struct Moments {
    Plane a, b, aa, bb, ab;  ///< weighted means of the values and of their products

    [[nodiscard]] double ssim(size_t p) const {
        const double meanA = a.values[p];
        const double meanB = b.values[p];
        const double varianceA = aa.values[p] - meanA * meanA;
        const double varianceB = bb.values[p] - meanB * meanB;
        const double covariance = ab.values[p] - meanA * meanB;
        return (2.0 * meanA * meanB + kC1) * (2.0 * covariance + kC2) /
               ((meanA * meanA + meanB * meanB + kC1) * (varianceA + varianceB + kC2));
    }
};

}  // namespace

core::Result<Measure> mssim(const Picture& image, const Picture& reference) {
    TRY_VOID(checkComparable(image, reference));
    const Plane a = lumaOf(image.display);
    const Plane b = lumaOf(reference.display);
    if (a.width < kSsimWindow || a.height < kSsimWindow)
        return core::error("{} is {}x{}: MSSIM needs {}x{} pixels or more", image.name, a.width,
                           a.height, kSsimWindow, kSsimWindow);
    const Moments moments{weigh(a), weigh(b), weigh(product(a, a)), weigh(product(b, b)),
                          weigh(product(a, b))};
    Measure measure{0.0, core::Image(a.width - 2 * kRadius, a.height - 2 * kRadius, 1)};
    for (uint32_t y = 0; y < measure.map.height; ++y)
        for (uint32_t x = 0; x < measure.map.width; ++x) {
            const double ssim = moments.ssim(size_t{y + kRadius} * a.width + x + kRadius);
            measure.map.at(x, y, 0) = static_cast<float>(ssim);
            measure.value += ssim;
        }
    measure.value /= static_cast<double>(measure.map.values.size());
    return measure;
}

}  // namespace lampyris::evaluation
