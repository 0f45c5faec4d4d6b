#include "thesis/constant_ambient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lampyris::sandbox::thesis {
namespace {

/// Two surfaces, lit so that no channel is near white.
struct Scene {
    core::Image direct{20, 10, 3}, albedo{20, 10, 3};

    Scene() {
        for (size_t i = 0; i < direct.values.size(); ++i) {
            direct.values[i] = 0.02f + 0.001f * static_cast<float>(i % 50);
            albedo.values[i] = i % 2 == 0 ? 0.7f : 0.3f;
        }
    }
};

double squaredError(const core::DisplayImage& a, const core::DisplayImage& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.values.size(); ++i)
        sum += std::pow(static_cast<double>(a.values[i]) - b.values[i], 2.0);
    return sum;
}

TEST(ConstantAmbient, AddsAlbedoTimesIrradianceOverPi) {
    const Scene scene;
    const core::Image sum = withAmbient(scene.direct, scene.albedo, {1.0f, 2.0f, 0.0f});
    EXPECT_FLOAT_EQ(sum.values[0], scene.direct.values[0] + 0.7f / std::numbers::pi_v<float>);
    EXPECT_FLOAT_EQ(sum.values[1],
                    scene.direct.values[1] + 2.0f * 0.3f / std::numbers::pi_v<float>);
    EXPECT_FLOAT_EQ(sum.values[2], scene.direct.values[2]);
}

TEST(ConstantAmbient, FindsTheConstantThatIsInTheReference) {
    const Scene scene;
    const core::DisplayTransform display{0.5f, core::Tonemap::Clip};
    const AmbientIrradiance truth{1.2f, 0.4f, 0.0f};
    const auto reference = core::toDisplay(withAmbient(scene.direct, scene.albedo, truth), display);
    const auto found = bestAmbient(scene.direct, scene.albedo, reference, display);
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], truth[c], 0.01f) << c;
}

TEST(ConstantAmbient, NoOtherConstantIsCloserWhereNoneFits) {
    const Scene scene;
    const core::DisplayTransform display{0.0f, core::Tonemap::Filmic};
    core::Image varied = scene.direct;
    for (size_t i = 0; i < varied.values.size(); ++i)
        varied.values[i] += 0.001f * static_cast<float>(i % 200);
    const auto reference = core::toDisplay(varied, display);
    const auto found = bestAmbient(scene.direct, scene.albedo, reference, display);
    const auto errorOf = [&](const AmbientIrradiance& ambient) {
        return squaredError(
            core::toDisplay(withAmbient(scene.direct, scene.albedo, ambient), display), reference);
    };
    for (size_t c = 0; c < 3; ++c)
        for (const float factor : {0.8f, 0.9f, 1.1f, 1.3f}) {
            AmbientIrradiance other = found;
            other[c] *= factor;
            EXPECT_GT(errorOf(other), errorOf(found)) << c << " · " << factor;
        }
}

TEST(ConstantAmbient, ABrightReferenceIsReached) {
    const Scene scene;
    const core::DisplayTransform display{-6.0f, core::Tonemap::Clip};
    const AmbientIrradiance truth{40.0f, 60.0f, 25.0f};
    const auto reference = core::toDisplay(withAmbient(scene.direct, scene.albedo, truth), display);
    const auto found = bestAmbient(scene.direct, scene.albedo, reference, display);
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / truth[c], 1.0f, 0.02f) << c;
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
