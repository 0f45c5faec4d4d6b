#include "reference/smooth_indirect.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace lampyris::reference {
namespace {

constexpr uint32_t kSide = 64;
constexpr float kNoise = 0.2f;

/// A picture of a wall, a pixel a metre, and what stands in its pixels.
struct Wall {
    core::Image image{kSide, kSide, 3};
    std::vector<SmoothGuide> guides{kSide * kSide};

    using Light = std::function<float(float x, float y)>;
    /// Irradiance by the place, with normal noise of kNoise that differs by seed.
    Wall(const Light& light, uint32_t seed) {
        std::mt19937 random(seed);
        std::normal_distribution<float> noise(0.0f, kNoise);
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 0; x < kSide; ++x) {
                const auto u = static_cast<float>(x), v = static_cast<float>(y);
                const float value = light(u, v) + noise(random);
                for (uint32_t c = 0; c < 3; ++c) image.at(x, y, c) = value;
                guides[y * kSide + x] = {{u, v, 0.0f}, {0, 0, 1}, 1.0f, kNoise * kNoise, 0, true};
            }
    }
    [[nodiscard]] core::Image smoothed() const { return smoothIndirect(image, guides, 2); }
};

/// Root of the mean square over pixels at least 8 from the border.
double distance(const core::Image& image, const Wall::Light& light) {
    double sum = 0.0;
    for (uint32_t y = 8; y < kSide - 8; ++y)
        for (uint32_t x = 8; x < kSide - 8; ++x) {
            const float off =
                image.at(x, y, 0) - light(static_cast<float>(x), static_cast<float>(y));
            sum += static_cast<double>(off * off) / ((kSide - 16) * (kSide - 16));
        }
    return std::sqrt(sum);
}

TEST(SmoothIndirect, TakesNearlyAllNoiseFromLightThatVariesLittle) {
    const Wall::Light even = [](float, float) { return 3.0f; };
    const Wall::Light slope = [](float x, float y) { return 1.0f + 0.02f * x + 0.01f * y; };
    for (const auto& light : {even, slope})
        for (const uint32_t seed : {1u, 2u})
            EXPECT_LT(distance(Wall(light, seed).smoothed(), light), 0.1 * kNoise);
}

TEST(SmoothIndirect, LeavesAnEdgeOfLightWhereItIs) {
    const Wall::Light edge = [](float x, float) { return x < 32.0f ? 1.0f : 3.0f; };
    const core::Image smoothed = Wall(edge, 1).smoothed();
    for (uint32_t y = 8; y < kSide - 8; ++y) {
        EXPECT_LT(smoothed.at(29, y, 0), 1.4f);
        EXPECT_GT(smoothed.at(34, y, 0), 2.6f);
    }
    EXPECT_LT(distance(smoothed, edge), kNoise);
}

TEST(SmoothIndirect, ItsBiasIsSmallerThanItsNoiseWas) {
    // A bump as a contact shadow is: the mean over seeds is the truth, up to the smoothing's bias.
    const Wall::Light bump = [](float x, float y) {
        return 2.0f - 1.5f * std::exp(-((x - 32) * (x - 32) + (y - 32) * (y - 32)) / 50.0f);
    };
    core::Image mean(kSide, kSide, 3);
    for (uint32_t seed = 0; seed < 4; ++seed) {
        const core::Image one = Wall(bump, seed).smoothed();
        EXPECT_LT(distance(one, bump), 0.25 * kNoise);
        for (size_t i = 0; i < mean.values.size(); ++i) mean.values[i] += one.values[i] / 4.0f;
    }
    EXPECT_LT(distance(mean, bump), 0.2 * kNoise);
}

TEST(SmoothIndirect, KeepsToTheSurface) {
    const Wall::Light even = [](float, float) { return 1.0f; };
    const auto bend = [&](const std::function<void(SmoothGuide&)>& change) {
        Wall wall(even, 1);
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 32; x < kSide; ++x) {
                change(wall.guides[y * kSide + x]);
                for (uint32_t c = 0; c < 3; ++c) wall.image.at(x, y, c) += 0.3f;
            }
        const core::Image smoothed = wall.smoothed();
        EXPECT_NEAR(smoothed.at(31, 32, 0), 1.0f, 0.08f);
        EXPECT_NEAR(smoothed.at(32, 32, 0), 1.3f, 0.08f);
    };
    bend([](SmoothGuide& guide) { guide.instance = 1; });
    bend([](SmoothGuide& guide) { guide.normal = {0.2f, 0.0f, 0.98f}; });
    bend([](SmoothGuide& guide) { guide.position.z += 2.0f; });
}

TEST(SmoothIndirect, LeavesTheBackgroundBlackAndOut) {
    Wall wall([](float, float) { return 1.0f; }, 1);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 32; x < kSide; ++x) {
            wall.guides[y * kSide + x].surface = false;
            for (uint32_t c = 0; c < 3; ++c) wall.image.at(x, y, c) = 0.0f;
        }
    const core::Image smoothed = wall.smoothed();
    EXPECT_NEAR(smoothed.at(31, 32, 0), 1.0f, 0.08f);
    EXPECT_EQ(smoothed.at(32, 32, 0), 0.0f);
}

TEST(SmoothIndirect, LeavesExactValuesAlone) {
    Wall wall([](float x, float y) { return std::fmod(x + 3.0f * y, 5.0f); }, 1);
    for (SmoothGuide& guide : wall.guides) guide.variance = 0.0f;
    const core::Image smoothed = wall.smoothed();
    for (size_t i = 0; i < smoothed.values.size(); ++i)
        ASSERT_NEAR(smoothed.values[i], std::max(wall.image.values[i], 0.0f), 1e-6f);
}

TEST(SmoothIndirect, IsTheSameOnAnyNumberOfThreads) {
    const Wall wall([](float x, float) { return x; }, 1);
    EXPECT_EQ(smoothIndirect(wall.image, wall.guides, 1).values,
              smoothIndirect(wall.image, wall.guides, 5).values);
}

}  // namespace
}  // namespace lampyris::reference
