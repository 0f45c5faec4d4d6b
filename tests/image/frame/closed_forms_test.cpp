// Whole frames against answers that stand in a formula.
#include <gtest/gtest.h>

#include "support/frame_test.h"

namespace lampyris {
namespace {

using test::addInstance;
using test::addLight;
using test::lambertian;
using test::lookFrom;

class ClosedForms : public test::FrameTest {};

TEST_F(ClosedForms, PlaneUnderASphereLightHasIrradianceByTheCosineAndTheSquare) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}),
                lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 3.0f, 0.0f}, 0.4f, 100.0f);
    const auto camera =
        lookFrom({0.0f, 6.0f, 0.001f}, {0.0f, 0.0f, 0.0f}, 80.0f, {0.0f, 0.0f, -1.0f});
    for (const auto pipeline : {photon_gi::Pipeline::Full, photon_gi::Pipeline::Thesis}) {
        auto wanted = request(64, 64, camera);
        wanted.settings.pipeline = pipeline;
        wanted.settings.maxBounces = 1;
        const auto e = render(snapshot, wanted, "irradiance_direct");
        const auto x = render(snapshot, wanted, "position");
        int compared = 0;
        for (uint32_t py = 0; py < 64; ++py)
            for (uint32_t px = 0; px < 64; ++px) {
                const glm::vec3 p(x.image.at(px, py, 0), x.image.at(px, py, 1),
                                  x.image.at(px, py, 2));
                const glm::vec3 to = glm::vec3(0.0f, 3.0f, 0.0f) - p;
                const float d2 = glm::dot(to, to);
                const float expected = 100.0f * (to.y / std::sqrt(d2)) / (4.0f * math::kPi * d2);
                ASSERT_NEAR(e.image.at(px, py, 0), expected, 0.01f * expected) << px << "," << py;
                ++compared;
            }
        EXPECT_EQ(compared, 64 * 64);
    }
}

// Where the horizon cuts the light, the irradiance counts what stands above it; a shadow ray must
// not take that away once more. Nothing blocks here, so both pipelines must agree.
TEST_F(ClosedForms, ALightThatTheHorizonCutsIsNotInShadow) {
    for (const float height : {0.5f, 0.0f, -0.5f, -0.8f}) {
        scene::SceneSnapshot snapshot;
        addInstance(snapshot, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}),
                    lambertian(glm::vec3(0.5f)));
        addLight(snapshot, {0.0f, height, 0.0f}, 1.0f, 100.0f);
        auto wanted = request(
            64, 64, lookFrom({0.0f, 6.0f, 0.001f}, glm::vec3(0.0f), 60.0f, {0.0f, 0.0f, -1.0f}));
        wanted.settings.pipeline = photon_gi::Pipeline::Thesis;
        const auto open = render(snapshot, wanted, "irradiance_direct");
        wanted.settings.pipeline = photon_gi::Pipeline::Direct;
        const auto shadowed = render(snapshot, wanted, "irradiance_direct");
        int compared = 0;
        for (uint32_t py = 0; py < 64; ++py)
            for (uint32_t px = 0; px < 64; ++px) {
                const float expected = open.image.at(px, py, 0);
                ASSERT_NEAR(shadowed.image.at(px, py, 0), expected, 1e-3f * expected)
                    << height << " at " << px << "," << py;
                if (expected > 0.0f) ++compared;
            }
        EXPECT_GT(compared, 3000);
    }
}

TEST_F(ClosedForms, GathersAtFullResolutionBeyondOneRowOfWorkgroups) {
    const scene::SceneSnapshot snapshot = test::builtinSnapshot("cornell");
    auto wanted = request(2904, 1448, snapshot.cameras.front());
    wanted.settings.gather = photon_gi::Gather::Tiles;
    wanted.settings.photonPaths = 100;
    wanted.settings.maxBounces = 1;
    wanted.settings.gatherDivisor = 1;
    const auto whole = render(snapshot, wanted, "irradiance_indirect");
    wanted.settings.gatherDivisor = 4;
    const auto coarse = render(snapshot, wanted, "irradiance_indirect");
    double sum = 0.0, difference = 0.0;
    for (size_t i = 0; i < whole.image.values.size(); ++i) {
        sum += static_cast<double>(whole.image.values[i]);
        difference += static_cast<double>(std::abs(whole.image.values[i] - coarse.image.values[i]));
    }
    EXPECT_LT(difference, 0.01 * sum);
}

// A light in the middle of a closed sphere of albedo ρ: E_direct = Φ/(4πR²), and every bounce gives
// ρ times the irradiance of the one before, since light spreads evenly over an integrating sphere.
class IntegratingSphere : public test::FrameTest, public ::testing::WithParamInterface<float> {
 protected:
    static double meanIndirect(float albedo, uint32_t bounces) {
        scene::SceneSnapshot snapshot;
        addInstance(snapshot, test::uvSphere(2.0f, 96, 48), lambertian(glm::vec3(albedo)));
        addLight(snapshot, {0.0f, 0.0f, 0.0f}, 0.2f, 100.0f);
        auto wanted = request(64, 64, lookFrom({0.0f, 0.0f, 0.5f}, {0.1f, 0.05f, -1.0f}, 70.0f));
        wanted.settings.photonPaths = 60000;
        wanted.settings.radiusMetres = 0.2f;
        wanted.settings.gatherDivisor = 1;
        wanted.settings.gatherRays = 16;
        wanted.settings.maxBounces = bounces;
        const auto e = render(snapshot, wanted, "irradiance_indirect");
        EXPECT_LT(e.report.energy.relativeError(), 1e-4);
        EXPECT_LT(e.report.energy.escaped.x, 1e-6 * 100.0);
        double sum = 0.0;
        for (size_t i = 0; i < e.image.values.size(); i += e.image.channels)
            sum += e.image.values[i];
        return sum / (64.0 * 64.0);
    }
};

TEST_P(IntegratingSphere, OneBounceGivesAlbedoTimesDirect) {
    const double direct = 100.0 / (4.0 * M_PI * 4.0);
    EXPECT_NEAR(meanIndirect(GetParam(), 1), direct * GetParam(), 0.02 * direct * GetParam());
}

TEST_P(IntegratingSphere, ManyBouncesGiveTheGeometricSeries) {
    const double direct = 100.0 / (4.0 * M_PI * 4.0);
    const double expected = direct * GetParam() / (1.0 - GetParam());
    EXPECT_NEAR(meanIndirect(GetParam(), 60), expected, 0.02 * expected);
}

INSTANTIATE_TEST_SUITE_P(Albedos, IntegratingSphere, ::testing::Values(0.2f, 0.5f, 0.8f));

TEST_F(ClosedForms, BehindAWallDirectLightIsZeroInFullAndNotInThesis) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}),
                lambertian(glm::vec3(0.5f)));
    addInstance(snapshot, test::quad({-4, 2, 4}, {4, 2, 4}, {4, 2, -4}, {-4, 2, -4}),
                lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 3.0f, 0.0f}, 0.3f, 100.0f);
    auto wanted =
        request(48, 48, lookFrom({0.0f, 1.0f, 0.001f}, {0.0f, 0.0f, 0.0f}, 60.0f, {0, 0, -1}));
    const auto full = render(snapshot, wanted, "irradiance_direct");
    wanted.settings.pipeline = photon_gi::Pipeline::Thesis;
    wanted.settings.maxBounces = 1;
    const auto thesis = render(snapshot, wanted, "irradiance_direct");
    for (uint32_t i = 0; i < 48; ++i) {
        EXPECT_EQ(full.image.at(i, i, 0), 0.0f);
        EXPECT_GT(thesis.image.at(i, i, 0), 0.1f);
    }
}

TEST_F(ClosedForms, SeveralLightsAddUp) {
    const auto camera = lookFrom({0.0f, 5.0f, 0.001f}, {0.0f, 0.0f, 0.0f}, 70.0f, {0, 0, -1});
    scene::SceneSnapshot floor;
    addInstance(floor, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}),
                lambertian(glm::vec3(0.5f)));
    scene::SceneSnapshot first = floor;
    scene::SceneSnapshot second = floor;
    scene::SceneSnapshot both = floor;
    addLight(first, {-2.0f, 2.0f, 0.0f}, 0.3f, 50.0f);
    addLight(second, {2.0f, 1.0f, 1.0f}, 0.3f, 20.0f);
    addLight(both, {-2.0f, 2.0f, 0.0f}, 0.3f, 50.0f);
    addLight(both, {2.0f, 1.0f, 1.0f}, 0.3f, 20.0f);
    const auto wanted = request(40, 40, camera);
    const auto a = render(first, wanted, "direct");
    const auto b = render(second, wanted, "direct");
    const auto ab = render(both, wanted, "direct");
    for (size_t i = 0; i < ab.image.values.size(); ++i) {
        if (i % ab.image.channels == 3) continue;
        ASSERT_NEAR(ab.image.values[i], a.image.values[i] + b.image.values[i],
                    2e-3f * ab.image.values[i] + 1e-4f);
    }
}

TEST_F(ClosedForms, BackgroundIsExactlyBlack) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, test::quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}),
                lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 1.0f, 0.0f}, 0.1f, 10.0f);
    const auto wanted =
        request(64, 48, lookFrom({0.0f, 4.0f, 0.001f}, {0, 0, 0}, 60.0f, {0, 0, -1}));
    const auto depth = render(snapshot, wanted, "depth");
    const auto final = render(snapshot, wanted, "final");
    size_t background = 0;
    for (uint32_t y = 0; y < 48; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            if (depth.image.at(x, y, 0) == 0.0f) {
                ++background;
                for (uint32_t c = 0; c < 3; ++c) ASSERT_EQ(final.image.at(x, y, c), 0.0f);
            }
    EXPECT_GT(background, 1000u);
    EXPECT_LT(background, 64u * 48u);
}

}  // namespace
}  // namespace lampyris
