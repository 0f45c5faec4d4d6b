#include "reference/sphere_lights.h"

#include "support/small_scenes.h"
#include "unit/reference/chi_squared.h"

namespace lampyris::reference {
namespace {

scene::SnapshotLight light(const glm::vec3& position, float radius, float watts) {
    scene::SnapshotLight made;
    made.positionWorld = position;
    made.radiusMetres = radius;
    made.powerWatts = glm::vec3(watts);
    return made;
}

scene::SnapshotLight spot(const glm::vec3& position, const glm::vec3& direction, float degrees) {
    scene::SnapshotLight made = light(position, 0.1f, 10.0f);
    made.directionWorld = glm::normalize(direction);
    made.cosOuterCone = std::cos(glm::radians(degrees));
    made.cosInnerCone = std::cos(glm::radians(0.5f * degrees));
    return made;
}

SphereLights lightsOf(std::vector<scene::SnapshotLight> lights) {
    scene::SceneSnapshot snapshot;
    snapshot.lights = std::move(lights);
    return SphereLights(snapshot);
}

constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);

TEST(SphereLights, DirectionsFillTheSolidAngleEvenly) {
    const SphereLights lights = lightsOf({light({1, 2, -1}, 1.5f, 10.0f)});
    for (const glm::vec3 from : {glm::vec3(0.0f), glm::vec3(1.0f, 0.3f, -1.0f)})
        expectDirectionsFollow(
            glm::normalize(glm::vec3(1, 2, -1) - from),
            [&](glm::vec2 xi) { return lights.sample(0, from, xi).direction; },
            [&](const glm::vec3& w) {
                return lights.meet(0, from, w) ? lights.density(0, from) : 0.0f;
            },
            1.5);
}

TEST(SphereLights, FromInsideTheyAreAllAround) {
    const SphereLights lights = lightsOf({light({0, 0, 0}, 2.0f, 10.0f)});
    const glm::vec3 from(0.5f, 0.2f, 1.0f);
    expectDirectionsFollow(
        kUp, [&](glm::vec2 xi) { return lights.sample(0, from, xi).direction; },
        [&](const glm::vec3&) { return 1.0f / (4.0f * math::kPi); });
    const LightSample sample = lights.sample(0, from, {0.3f, 0.8f});
    EXPECT_NEAR(glm::length(from + sample.distance * sample.direction), 2.0f, 1e-5f);
    EXPECT_TRUE(lights.contains(0, from));
}

TEST(SphereLights, SamplesEndOnTheNearSideOfTheSphere) {
    const SphereLights lights = lightsOf({light({0, 5, 0}, 1.0f, 10.0f)});
    for (const float u : {0.0f, 0.2f, 0.9f, 0.999999f}) {
        const LightSample sample = lights.sample(0, {0, 0, 0}, {u, 0.4f});
        const glm::vec3 end = sample.distance * sample.direction;
        EXPECT_NEAR(glm::length(end - glm::vec3(0, 5, 0)), 1.0f, 1e-3f);
        EXPECT_LT(sample.distance, std::sqrt(24.0f) + 1e-3f);
    }
}

TEST(SphereLights, IrradianceIsThatOfThePowerAtEveryDistanceAndSize) {
    // At right angles to the way to the centre, E = Φ/(4πd²) exactly.
    for (const float distance : {1.0f, 3.0f, 1000.0f, 1e5f})
        for (const float radius : {0.0f, 1e-3f, 0.05f, 0.9f}) {
            const SphereLights lights = lightsOf({light({0, distance, 0}, radius, 100.0f)});
            double sum = 0.0;
            for (int i = 0; i < 64; ++i) {
                const LightSample s = lights.sample(0, {0, 0, 0}, {(i + 0.5f) / 64.0f, 0.1f});
                sum += s.radianceOverDensity.x * s.direction.y / 64.0;
            }
            const double wanted = 100.0 / (4.0 * M_PI * distance * distance);
            EXPECT_NEAR(sum, wanted, 1e-3 * wanted) << distance << " " << radius;
        }
}

TEST(SphereLights, AreChosenByTheirImportance) {
    const SphereLights lights =
        lightsOf({light({0, 2, 0}, 0.1f, 10.0f), light({3, 1, 0}, 0.1f, 80.0f),
                  light({0, -4, 0}, 0.1f, 500.0f)});
    std::vector<double> counted(3, 0.0), expected(3, 0.0);
    constexpr int kCount = 30000;
    for (int i = 0; i < kCount; ++i) {
        const auto choice = lights.choose({0, 0, 0}, kUp, (i + 0.5f) / kCount);
        ++counted[choice.light];
        expected[choice.light] = choice.chance * kCount;
        EXPECT_NEAR(choice.chance, lights.importance(choice.light, {0, 0, 0}, kUp) / choice.total,
                    1e-6f);
    }
    EXPECT_EQ(counted[2], 0.0) << "below the horizon";
    EXPECT_NEAR(expected[0] + expected[1], kCount, 1.0);
    for (size_t i = 0; i < 2; ++i) EXPECT_NEAR(counted[i], expected[i], 2.0);
}

TEST(SphereLights, ImportanceIsZeroOnlyWhereNothingArrives) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
    int dark = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 from = 3.0f * point(), normal = glm::normalize(point());
        auto made = spot(point(), point(), 5.0f + 80.0f * std::abs(uniform(random)));
        made.radiusMetres = 0.5f * std::abs(uniform(random));
        const SphereLights lights = lightsOf({made});
        bool arrives = false;
        for (int k = 0; k < 400 && !arrives; ++k) {
            const glm::vec2 xi(0.5f + 0.5f * uniform(random), 0.5f + 0.5f * uniform(random));
            const LightSample s = lights.sample(0, from, xi);
            arrives = glm::dot(s.direction, normal) > 0.0f && s.radianceOverDensity.x > 0.0f;
        }
        if (arrives) {
            EXPECT_GT(lights.importance(0, from, normal), 0.0f);
        }
        dark += lights.importance(0, from, normal) == 0.0f ? 1 : 0;
    }
    EXPECT_GT(dark, 50);
}

TEST(SphereLights, SpotsFallOffBetweenTheirCones) {
    const SphereLights lights = lightsOf({spot({0, 0, 0}, {0, -1, 0}, 40.0f)});
    const auto at = [&](float degrees) {
        const float angle = glm::radians(degrees);
        // Against the light's way: from a point below, up to it.
        return lights.radiance(0, {std::sin(angle), std::cos(angle), 0.0f}).x;
    };
    const float full = 10.0f / (4.0f * math::kPi * math::kPi * 0.01f);
    EXPECT_NEAR(at(0.0f), full, 1e-4f * full);
    EXPECT_NEAR(at(19.0f), full, 1e-4f * full);
    EXPECT_EQ(at(41.0f), 0.0f);
    const float t = (std::cos(glm::radians(30.0f)) - std::cos(glm::radians(40.0f))) /
                    (std::cos(glm::radians(20.0f)) - std::cos(glm::radians(40.0f)));
    EXPECT_NEAR(at(30.0f), full * t * t, 1e-3f * full);
}

TEST(SphereLights, ThoseWithoutPowerAreLeftOut) {
    EXPECT_EQ(lightsOf({light({0, 1, 0}, 0.1f, 0.0f), light({0, 1, 0}, 0.1f, 1.0f)}).count(), 1u);
}

}  // namespace
}  // namespace lampyris::reference
