#include "reference/ggx.h"

#include "unit/reference/chi_squared.h"

namespace lampyris::reference {
namespace {

const glm::vec3 kNormal = glm::normalize(glm::vec3(0.2f, 0.9f, -0.4f));
const glm::vec3 kF0(0.9f, 0.5f, 0.04f);

glm::vec3 atAngle(float degrees) {
    const Frame frame(kNormal);
    const float angle = glm::radians(degrees);
    return frame.toWorld({std::sin(angle) * 0.6f, std::sin(angle) * 0.8f, std::cos(angle)});
}

/// The model as it stands in print (Thesis 4.4 to 4.8), term by term, in double.
glm::dvec3 model(const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l, double roughness,
                 const glm::dvec3& f0) {
    const glm::dvec3 h = glm::normalize(v + l);
    const double alpha = roughness * roughness;
    const double nh = glm::dot(n, h), nl = glm::dot(n, l), nv = glm::dot(n, v);
    const double d = alpha * alpha / (M_PI * std::pow(nh * nh * (alpha * alpha - 1.0) + 1.0, 2.0));
    const double k = std::pow(roughness + 1.0, 2.0) / 8.0;
    const auto g1 = [&](double x) { return x / (x * (1.0 - k) + k); };
    const glm::dvec3 f = f0 + (1.0 - f0) * std::pow(1.0 - glm::dot(v, h), 5.0);
    return f * (d * g1(nl) * g1(nv) / (4.0 * nl * nv)) * nl;
}

TEST(Ggx, IsTheModelInPrint) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (int i = 0; i < 2000; ++i) {
        const float roughness = 0.1f + 0.9f * uniform(random);
        const glm::vec3 v = atAngle(80.0f * uniform(random));
        const glm::vec3 l = warpToCosine({uniform(random), uniform(random)}, kNormal);
        const glm::vec3 got = Ggx(kNormal, v, roughness, kF0).timesCosine(l);
        const glm::dvec3 wanted =
            model(glm::dvec3(kNormal), glm::dvec3(v), glm::dvec3(l), roughness, glm::dvec3(kF0));
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[c], wanted[c], 2e-3 * wanted[c] + 1e-6);
    }
}

TEST(Ggx, NothingComesFromBelow) {
    const Ggx ggx(kNormal, atAngle(30.0f), 0.5f, kF0);
    EXPECT_EQ(ggx.timesCosine(-kNormal), glm::vec3(0.0f));
    EXPECT_EQ(ggx.timesCosine(atAngle(91.0f)), glm::vec3(0.0f));
}

TEST(Ggx, MirrorsHaveALeastRoughness) {
    const Ggx zero(kNormal, atAngle(30.0f), 0.0f, kF0);
    const glm::vec3 peak = zero.timesCosine(atAngle(-30.0f));
    EXPECT_TRUE(std::isfinite(peak.x));
    EXPECT_GT(peak.x, 1000.0f);
}

class GgxSampling : public testing::TestWithParam<std::pair<float, float>> {};

TEST_P(GgxSampling, FollowsItsDensity) {
    const auto [roughness, degrees] = GetParam();
    const Ggx ggx(kNormal, atAngle(degrees), roughness, kF0);
    // Rings about the mirror direction, narrow where the lobe is.
    expectDirectionsFollow(
        atAngle(-degrees), [&](glm::vec2 xi) { return ggx.sample(xi); },
        [&](const glm::vec3& w) { return ggx.density(w); }, roughness < 0.4f ? 3.0 : 1.5);
}

INSTANTIATE_TEST_SUITE_P(RoughnessAndAngle, GgxSampling,
                         testing::Values(std::pair(0.2f, 10.0f), std::pair(0.3f, 60.0f),
                                         std::pair(0.5f, 0.0f), std::pair(0.5f, 80.0f),
                                         std::pair(1.0f, 45.0f), std::pair(1.0f, 85.0f)));

TEST(Ggx, TheEstimatorConvergesToTheIntegral) {
    // f·cos / density averaged over samples against a sum over the hemisphere.
    for (const float roughness : {0.2f, 0.6f}) {
        const Ggx ggx(kNormal, atAngle(50.0f), roughness, kF0);
        double sampled = 0.0, summed = 0.0;
        std::mt19937 random(2);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        constexpr int kSamples = 100000, kSteps = 800;
        for (int i = 0; i < kSamples; ++i) {
            const glm::vec3 w = ggx.sample({uniform(random), uniform(random)});
            const float density = ggx.density(w);
            if (density > 0.0f) sampled += ggx.timesCosine(w).x / density / kSamples;
        }
        const Frame frame(kNormal);
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j)
                summed += ggx.timesCosine(frame.toWorld(warpToCone(
                                              {(i + 0.5f) / kSteps, (j + 0.5f) / kSteps}, 1.0f)))
                              .x *
                          2.0 * M_PI / (kSteps * kSteps);
        EXPECT_NEAR(sampled, summed, 5e-3 * summed) << roughness;
    }
}

}  // namespace
}  // namespace lampyris::reference
