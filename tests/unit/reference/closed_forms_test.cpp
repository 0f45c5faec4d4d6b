// Whole renders against answers that stand in a formula.
#include <cmath>

#include "reference/ggx.h"
#include "reference/sphere_lights.h"
#include "unit/reference/scenes.h"

namespace lampyris::reference {
namespace {

const scene::SnapshotCamera kFromAbove =
    lookFrom({0.0f, 6.0f, 0.001f}, {0.0f, 0.0f, 0.0f}, 80.0f, {0.0f, 0.0f, -1.0f});

TEST(ClosedForms, PlaneUnderASphereLightHasIrradianceByTheCosineAndTheSquare) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 3.0f, 0.0f}, 0.4f, 100.0f);
    const Rendered picture = rendered(snapshot, kFromAbove, settingsFor(32, 32, 512));
    double ratios = 0.0;
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 32; ++x) {
            const glm::vec3 to = glm::vec3(0, 3, 0) - pixelOf(picture.position, x, y);
            const float d2 = glm::dot(to, to);
            const float expected = 100.0f * to.y / std::sqrt(d2) / (4.0f * math::kPi * d2);
            ASSERT_NEAR(picture.irradianceDirect.at(x, y, 1), expected, 0.005f * expected);
            ASSERT_NEAR(picture.direct.at(x, y, 1), 0.5f / math::kPi * expected, 0.005f * expected);
            ratios += static_cast<double>(picture.irradianceDirect.at(x, y, 1) / expected);
        }
    EXPECT_NEAR(ratios / (32 * 32), 1.0, 2e-4);
    EXPECT_EQ(meanOf(picture.indirect), glm::dvec3(0.0)) << "a plane does not light itself";
}

TEST(ClosedForms, InsideALightIrradianceIsPiTimesItsRadiance) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 0.2f, 0.0f}, 20.0f, 1000.0f);
    const Rendered picture = rendered(snapshot, kFromAbove, settingsFor(8, 8, 512));
    EXPECT_NEAR(meanOf(picture.irradianceDirect).x, 1000.0 / (4.0 * M_PI * 400.0), 1e-3);
    EXPECT_GT(meanOf(picture.final).x, 0.0) << "its disc is not drawn from inside";
}

// A light in the middle of a closed sphere of albedo ρ: E_direct = Φ/(4πR²), and every bounce gives
// ρ times the irradiance of the one before.
class IntegratingSphere : public testing::TestWithParam<float> {
 protected:
    static Rendered lit(float albedo, uint32_t bounces, uint32_t samples) {
        scene::SceneSnapshot snapshot;
        addInstance(snapshot, test::uvSphere(2.0f, 192, 96), lambertian(glm::vec3(albedo)));
        addLight(snapshot, {0.0f, 0.0f, 0.0f}, 0.2f, 100.0f);
        Settings settings = settingsFor(24, 24, samples);
        settings.maxBounces = bounces;
        return rendered(snapshot, lookFrom({0.0f, 0.0f, 0.5f}, {0.1f, 0.05f, -1.0f}, 70.0f),
                        settings);
    }
    static constexpr double kDirect = 100.0 / (4.0 * M_PI * 4.0);
};

TEST_P(IntegratingSphere, AllBouncesGiveTheGeometricSeries) {
    const Rendered picture = lit(GetParam(), kAllBounces, 128);
    const double rho = GetParam(), expected = kDirect * rho / (1.0 - rho);
    EXPECT_NEAR(meanOf(picture.irradianceDirect).x, kDirect, 0.005 * kDirect);
    EXPECT_NEAR(meanOf(picture.irradianceIndirect).x, expected, 0.01 * expected);
}

TEST_P(IntegratingSphere, EachBounceIsOneTermOfTheSeries) {
    const double rho = GetParam();
    EXPECT_EQ(meanOf(lit(GetParam(), 0, 8).irradianceIndirect).x, 0.0);
    double expected = 0.0;
    for (uint32_t bounces = 1; bounces <= 5; ++bounces) {
        expected += kDirect * std::pow(rho, bounces);
        EXPECT_NEAR(meanOf(lit(GetParam(), bounces, 32).irradianceIndirect).x, expected,
                    0.01 * expected)
            << bounces << " bounces";
    }
}

INSTANTIATE_TEST_SUITE_P(Albedos, IntegratingSphere, testing::Values(0.2f, 0.5f, 0.8f));

TEST(ClosedForms, InAFurnaceAConvexBodyShowsItsAlbedo) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, boxFromInside(3.0f), glowing(glm::vec3(1.0f), glm::vec3(0.0f)));
    const glm::vec3 albedo(0.9f, 0.5f, 0.1f);
    addInstance(snapshot, test::uvSphere(1.0f, 64, 32), lambertian(albedo));
    const Rendered picture =
        rendered(snapshot, lookFrom({0, 0.5f, 2.8f}, {0, 0, 0}, 30.0f), settingsFor(24, 24, 256));
    int seen = 0;
    for (uint32_t y = 0; y < 24; ++y)
        for (uint32_t x = 0; x < 24; ++x) {
            if (picture.albedo.at(x, y, 0) == 0.0f) {
                EXPECT_EQ(pixelOf(picture.final, x, y), glm::vec3(1.0f)) << "the wall's own glow";
                continue;
            }
            ++seen;
            // At the rim the shading normal looks a little beyond the flat triangle.
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(pixelOf(picture.indirect, x, y)[c], albedo[c], 0.04f * albedo[c]);
        }
    EXPECT_GT(seen, 300);
    EXPECT_EQ(meanOf(picture.direct), glm::dvec3(0.0)) << "light of surfaces is indirect";
}

// Walls of radiance 1 that reflect half: after B bounces Σ ½^k for k up to B arrives, as a path
// from a surface may hit B + 1 surfaces; without bounces there is direct light alone, hence
// nothing.
TEST(ClosedForms, AGlowingRoomIsAGeometricSeries) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, boxFromInside(3.0f), glowing(glm::vec3(1.0f), glm::vec3(0.5f)));
    const auto camera = lookFrom({0, 0, 0}, {1, 0.3f, 0.2f});
    for (const uint32_t bounces : {0u, 1u, 2u, 5u, kAllBounces}) {
        Settings settings = settingsFor(16, 16, 64);
        settings.maxBounces = bounces;
        const double expected = bounces == 0 ? 0.0 : 2.0 - std::pow(0.5, std::min(bounces, 60u));
        const Rendered picture = rendered(snapshot, camera, settings);
        EXPECT_NEAR(meanOf(picture.irradianceIndirect).y, M_PI * expected, 0.01 * M_PI * expected);
        EXPECT_NEAR(meanOf(picture.final).y, 1.0 + 0.5 * expected, 0.01 * (1.0 + 0.5 * expected));
    }
}

/// ∫ GGX · cosine · L over a sphere's solid angle, by sums.
double mirrored(const glm::vec3& position, const glm::vec3& eye, float roughness,
                const glm::vec3& centre, float radius, double radiance) {
    const glm::vec3 up(0, 1, 0);
    const Ggx ggx(up, glm::normalize(eye - position), roughness, glm::vec3(0.9f));
    const glm::dvec3 to(centre - position);
    const double height = 1.0 - std::sqrt(1.0 - radius * radius / glm::dot(to, to));
    const Frame frame(glm::vec3(glm::normalize(to)));
    constexpr int kSteps = 500;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double z = 1.0 - height * (i + 0.5) / kSteps;
            const double phi = 2.0 * M_PI * (j + 0.5) / kSteps, s = std::sqrt(1.0 - z * z);
            const glm::vec3 w =
                frame.toWorld(glm::vec3(glm::dvec3(s * std::cos(phi), s * std::sin(phi), z)));
            sum += ggx.timesCosine(w).x;
        }
    return sum * radiance * 2.0 * M_PI * height / (kSteps * kSteps);
}

class RoughMirror : public testing::TestWithParam<float> {};

TEST_P(RoughMirror, ShowsALightAsTheIntegralSays) {
    const glm::vec3 centre(0.2f, 2.0f, -2.5f), eye(0.0f, 1.5f, 3.0f);
    const float radius = 0.5f;
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, floorMesh(), metal(glm::vec3(0.9f), GetParam()));
    addLight(snapshot, centre, radius, 100.0f);
    const Rendered picture =
        rendered(snapshot, lookFrom(eye, {0.0f, 0.0f, 0.2f}, 20.0f), settingsFor(7, 7, 4096));
    const double radiance = 100.0 / (4.0 * M_PI * M_PI * radius * radius);
    double brightest = 0.0;
    for (uint32_t y = 0; y < 7; ++y)
        for (uint32_t x = 0; x < 7; ++x) {
            const double expected = mirrored(pixelOf(picture.position, x, y), eye, GetParam(),
                                             centre, radius, radiance);
            brightest = std::max(brightest, expected);
            ASSERT_NEAR(picture.direct.at(x, y, 0), expected, 0.02 * expected + 2e-3 * brightest)
                << x << "," << y;
        }
    EXPECT_GT(brightest, 0.1);
    EXPECT_EQ(meanOf(picture.irradianceDirect).x > 0.0, true);
    EXPECT_EQ(meanOf(picture.albedo), glm::dvec3(0.0)) << "metal";
}

INSTANTIATE_TEST_SUITE_P(Roughness, RoughMirror, testing::Values(0.08f, 0.25f, 0.5f, 1.0f));

// In a black room of radiance 1 metal shows its directional albedo, with glossy paths alone.
TEST(ClosedForms, FullTransportReflectsTheRoomInMetal) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, boxFromInside(9.5f), glowing(glm::vec3(1.0f), glm::vec3(0.0f)));
    addInstance(snapshot, floorMesh(), metal(glm::vec3(0.9f), 0.4f));
    const glm::vec3 eye(0.0f, 3.0f, 3.0f);
    const auto camera = lookFrom(eye, {0, 0, 0}, 10.0f);
    Settings settings = settingsFor(4, 4, 512);
    EXPECT_EQ(meanOf(rendered(snapshot, camera, settings).indirect).x, 0.0);
    settings.transport = Transport::Full;
    const Rendered picture = rendered(snapshot, camera, settings);
    // A light that fills the half-space above: the whole hemisphere.
    const Ggx ggx({0, 1, 0}, glm::normalize(eye), 0.4f, glm::vec3(0.9f));
    constexpr int kSteps = 400;
    double expected = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j)
            expected += ggx.timesCosine(Frame({0, 1, 0}).toWorld(warpToCone(
                                            {(i + 0.5f) / kSteps, (j + 0.5f) / kSteps}, 1.0f)))
                            .x *
                        2.0 * M_PI / (kSteps * kSteps);
    EXPECT_NEAR(meanOf(picture.indirect).x, expected, 0.01 * expected);
}

}  // namespace
}  // namespace lampyris::reference
