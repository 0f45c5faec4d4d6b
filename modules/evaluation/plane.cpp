#include "evaluation/plane.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace lampyris::evaluation {

Plane::Plane(uint32_t planeWidth, uint32_t planeHeight)
    : width(planeWidth), height(planeHeight), values(size_t{planeWidth} * planeHeight, 0.0) {}

Plane lumaOf(const core::DisplayImage& image) {
    Plane luma(image.width, image.height);
    for (size_t p = 0; p < luma.values.size(); ++p)
        luma.values[p] = 0.2126 * image.values[p * 3] + 0.7152 * image.values[p * 3 + 1] +
                         0.0722 * image.values[p * 3 + 2];
    return luma;
}

std::vector<double> gaussian(double sigma, int radius) {
    std::vector<double> weights;
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x)
        sum += weights.emplace_back(std::exp(-0.5 * x * x / (sigma * sigma)));
    for (double& weight : weights) weight /= sum;
    return weights;
}

Plane filterRows(const Plane& plane, std::span<const double> kernel) {
    CHECK((kernel.size() % 2) == 1u);
    const size_t width = plane.width;
    const size_t radius = kernel.size() / 2;
    Plane filtered(plane.width, plane.height);
    std::vector<double> padded(width + 2 * radius);
    for (size_t y = 0; y < plane.height; ++y) {
        const double* row = plane.values.data() + y * width;
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
        std::fill_n(padded.rbegin(), radius, row[width - 1]);
        double* out = filtered.values.data() + y * width;
        for (size_t i = 0; i < kernel.size(); ++i)
            for (size_t x = 0; x < width; ++x) out[x] += kernel[i] * padded[x + i];
    }
    return filtered;
}

Plane filterColumns(const Plane& plane, std::span<const double> kernel) {
    CHECK((kernel.size() % 2) == 1u);
    const size_t width = plane.width;
    const auto radius = static_cast<int64_t>(kernel.size() / 2);
    const int64_t last = int64_t{plane.height} - 1;
    Plane filtered(plane.width, plane.height);
    for (int64_t y = 0; y <= last; ++y) {
        double* out = filtered.values.data() + static_cast<size_t>(y) * width;
        for (size_t i = 0; i < kernel.size(); ++i) {
            const int64_t from = std::clamp(y + static_cast<int64_t>(i) - radius, int64_t{0}, last);
            const double* row = plane.values.data() + static_cast<size_t>(from) * width;
            for (size_t x = 0; x < width; ++x) out[x] += kernel[i] * row[x];
        }
    }
    return filtered;
}

}  // namespace lampyris::evaluation
