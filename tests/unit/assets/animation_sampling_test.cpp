#include "assets/animation_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lampyris::assets {
namespace {

constexpr float kHuge = std::numeric_limits<float>::max();

AnimationSampler sampler(Interpolation interpolation, std::vector<float> times, uint32_t components,
                         std::vector<float> values) {
    return {interpolation, std::move(times), components, std::move(values)};
}

glm::quat turn(float radians) {
    return glm::angleAxis(radians, glm::vec3(0, 1, 0));
}

/// Keys about y, x y z w.
AnimationSampler turning(Interpolation interpolation, const std::vector<float>& radians) {
    AnimationSampler result = sampler(interpolation, {}, 4, {});
    for (const float r : radians) {
        const glm::quat q = turn(r);
        result.times.push_back(static_cast<float>(result.times.size()));
        result.values.insert(result.values.end(), {q.x, q.y, q.z, q.w});
    }
    return result;
}

TEST(AnimationSampling, LinearKeysMeetHalfway) {
    const auto s = sampler(Interpolation::Linear, {1, 3}, 3, {0, 1, 2, 4, 3, 0});
    EXPECT_EQ(sampleVector(s, 2.0), glm::vec3(2, 2, 1));
    EXPECT_EQ(sampleVector(s, 1.5), glm::vec3(1, 1.5f, 1.5f));
    EXPECT_EQ(sampleVector(s, 3.0), glm::vec3(4, 3, 0));
}

TEST(AnimationSampling, TheEndsHoldForAnyTime) {
    const auto s = sampler(Interpolation::Linear, {1, 3}, 3, {0, 1, 2, 4, 3, 0});
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double before : {-kInfinity, -1e300, -5.0, 0.0, 1.0, std::nan("")})
        EXPECT_EQ(sampleVector(s, before), glm::vec3(0, 1, 2)) << before;
    for (const double after : {3.0, 10.0, 1e300, kInfinity})
        EXPECT_EQ(sampleVector(s, after), glm::vec3(4, 3, 0)) << after;
    const auto one = sampler(Interpolation::CubicSpline, {2}, 1, {9, 5, 9});
    for (const double at : {0.0, 2.0, 4.0}) {
        float value = 0.0f;
        sampleNumbers(one, at, {&value, 1});
        EXPECT_EQ(value, 5.0f);
    }
}

TEST(AnimationSampling, StepsChangeAtTheirKeys) {
    const auto s = sampler(Interpolation::Step, {0, 1, 2}, 3, {1, 1, 1, 2, 2, 2, 3, 3, 3});
    EXPECT_EQ(sampleVector(s, 0.999), glm::vec3(1));
    EXPECT_EQ(sampleVector(s, 1.0), glm::vec3(2));
    EXPECT_EQ(sampleVector(s, 1.5), glm::vec3(2));
    EXPECT_EQ(sampleVector(s, 2.0), glm::vec3(3));
}

TEST(AnimationSampling, TangentsAreASecond) {
    // From 0 with slope 3 to 4 with slope −1, two seconds apart: Hermite's basis at a quarter is
    // 27/32, 9/64, 5/32 and −3/64.
    const auto s = sampler(Interpolation::CubicSpline, {1, 3}, 1, {7, 0, 3, -1, 4, 7});
    float value = 0.0f;
    sampleNumbers(s, 1.5, {&value, 1});
    EXPECT_FLOAT_EQ(value, 2.0f * 3.0f * 9.0f / 64.0f + 4.0f * 5.0f / 32.0f + 2.0f * 3.0f / 64.0f);
    sampleNumbers(s, 2.0, {&value, 1});
    EXPECT_FLOAT_EQ(value, 2.0f * 3.0f / 8.0f + 2.0f + 2.0f / 8.0f);
    // Through its keys.
    sampleNumbers(s, 1.0, {&value, 1});
    EXPECT_EQ(value, 0.0f);
    sampleNumbers(s, 3.0, {&value, 1});
    EXPECT_EQ(value, 4.0f);
}

TEST(AnimationSampling, RotationsTurnEvenlyTheShorterWay) {
    const auto s = turning(Interpolation::Linear, {0.0f, 0.5f * math::kPi});
    for (const float share : {0.25f, 1.0f / 3.0f, 0.5f, 0.9f}) {
        const glm::quat q = sampleRotation(s, static_cast<double>(share));
        EXPECT_NEAR(std::abs(glm::dot(q, turn(share * 0.5f * math::kPi))), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::length(q), 1.0f, 1e-6f);
    }
    // 300° forward is 60° back.
    const auto back = turning(Interpolation::Linear, {0.0f, 300.0f / 180.0f * math::kPi});
    EXPECT_NEAR(std::abs(glm::dot(sampleRotation(back, 0.5), turn(-math::kPi / 6.0f))), 1.0f,
                1e-6f);
    // The same rotation, and the very opposite quaternion of it.
    auto still = turning(Interpolation::Linear, {1.0f, 1.0f});
    for (size_t i = 4; i < 8; ++i) still.values[i] = -still.values[i];
    EXPECT_NEAR(std::abs(glm::dot(sampleRotation(still, 0.3), turn(1.0f))), 1.0f, 1e-6f);
}

TEST(AnimationSampling, CubicRotationsAreNormalised) {
    AnimationSampler s = sampler(Interpolation::CubicSpline, {0, 1}, 4, std::vector<float>(24));
    const glm::quat to = turn(2.0f);
    s.values[7] = 1.0f;
    for (int i = 0; i < 4; ++i) s.values[16 + static_cast<size_t>(i)] = to[i];
    const glm::quat q = sampleRotation(s, 0.5);
    EXPECT_NEAR(glm::length(q), 1.0f, 1e-6f);
    EXPECT_NEAR(std::abs(glm::dot(q, turn(1.0f))), 1.0f, 1e-6f);
}

TEST(AnimationSampling, NothingBecomesNaN) {
    const auto far =
        sampler(Interpolation::Linear, {0, 1}, 3, {-kHuge, kHuge, 0, kHuge, -kHuge, kHuge});
    const glm::vec3 middle = sampleVector(far, 0.5);
    EXPECT_EQ(middle, glm::vec3(0, 0, 0.5f * kHuge));
    const auto steep =
        sampler(Interpolation::CubicSpline, {0, kHuge}, 1, {kHuge, 1, kHuge, -kHuge, 2, kHuge});
    float value = 0.0f;
    sampleNumbers(steep, 1e38, {&value, 1});
    EXPECT_EQ(value, 1.0f);
    // No rotation has the quaternion 0, and none stands between two opposite ones of a spline.
    const auto none = sampler(Interpolation::Linear, {0, 1}, 4, {0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(sampleRotation(none, 0.5), glm::quat(1, 0, 0, 0));
    AnimationSampler opposite =
        sampler(Interpolation::CubicSpline, {0, 1}, 4, std::vector<float>(24));
    opposite.values[7] = 1.0f;
    opposite.values[19] = -1.0f;
    EXPECT_EQ(sampleRotation(opposite, 0.5), glm::quat(1, 0, 0, 0));
}

}  // namespace
}  // namespace lampyris::assets
