#include "thesis/constant_ambient.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/check.h"

namespace lampyris::sandbox::thesis {
namespace {

constexpr size_t kPixelsLookedAt = 100000;  // [chosen] the mean of a square over them is steady
constexpr int kRounds = 10;                 // [chosen] each narrows the search to a quarter
constexpr int kSteps = 8;
constexpr float kMostIrradiance = 1e4f;  // W/m²; [chosen] the first round's end

/// Every n-th pixel, as a picture of one row.
struct Sample {
    core::Image direct, albedo;
    std::vector<uint8_t> reference;
};

Sample sampleOf(const core::Image& direct, const core::Image& albedo,
                const core::DisplayImage& reference) {
    const size_t pixels = size_t{direct.width} * direct.height;
    const size_t step = std::max<size_t>(1, pixels / kPixelsLookedAt);
    const auto count = static_cast<uint32_t>((pixels + step - 1) / step);
    Sample sample{core::Image(count, 1, 3), core::Image(count, 1, 3), {}};
    for (size_t i = 0; i < count; ++i)
        for (size_t c = 0; c < 3; ++c) {
            sample.direct.values[i * 3 + c] = direct.values[i * step * direct.channels + c];
            sample.albedo.values[i * 3 + c] = albedo.values[i * step * albedo.channels + c];
            sample.reference.push_back(reference.values[i * step * 3 + c]);
        }
    return sample;
}

std::array<double, 3> squaredErrors(const Sample& sample, const AmbientIrradiance& ambient,
                                    const core::DisplayTransform& display) {
    const core::DisplayImage shown =
        core::toDisplay(withAmbient(sample.direct, sample.albedo, ambient), display);
    std::array<double, 3> sums{};
    for (size_t i = 0; i < shown.values.size(); ++i) {
        const double difference = double{1} * shown.values[i] - sample.reference[i];
        sums[i % 3] += difference * difference;
    }
    return sums;
}

}  // namespace

core::Image withAmbient(const core::Image& direct, const core::Image& albedo,
                        const AmbientIrradiance& irradiance) {
    CHECK(direct.channels >= 3u);
    CHECK(albedo.channels >= 3u);
    core::Image sum(direct.width, direct.height, 3);
    const size_t pixels = size_t{direct.width} * direct.height;
    for (size_t p = 0; p < pixels; ++p)
        for (size_t c = 0; c < 3; ++c)
            sum.values[p * 3 + c] = direct.values[p * direct.channels + c] +
                                    albedo.values[p * albedo.channels + c] * irradiance[c] *
                                        std::numbers::inv_pi_v<float>;
    return sum;
}

AmbientIrradiance bestAmbient(const core::Image& direct, const core::Image& albedo,
                              const core::DisplayImage& reference,
                              const core::DisplayTransform& display) {
    const Sample sample = sampleOf(direct, albedo, reference);
    AmbientIrradiance low{}, high{kMostIrradiance, kMostIrradiance, kMostIrradiance}, best{};
    // Channels do not touch each other, so all three are searched at once.
    for (int round = 0; round < kRounds; ++round) {
        std::array<double, 3> least{};
        least.fill(std::numeric_limits<double>::infinity());
        for (int step = 0; step <= kSteps; ++step) {
            AmbientIrradiance tried{};
            for (size_t c = 0; c < 3; ++c)
                tried[c] = std::lerp(low[c], high[c], static_cast<float>(step) / kSteps);
            const auto errors = squaredErrors(sample, tried, display);
            for (size_t c = 0; c < 3; ++c)
                if (errors[c] < least[c]) {
                    least[c] = errors[c];
                    best[c] = tried[c];
                }
        }
        for (size_t c = 0; c < 3; ++c) {
            const float width = (high[c] - low[c]) / kSteps;
            low[c] = std::max(best[c] - width, 0.0f);
            high[c] = best[c] + width;
        }
    }
    return best;
}

}  // namespace lampyris::sandbox::thesis
