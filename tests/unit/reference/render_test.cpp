// What every render must keep: determinism, splits that add up, errors that tell the truth.
#include "reference/reference.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin.h"
#include "scene/extract.h"
#include "unit/reference/scenes.h"

namespace lampyris::reference {
namespace {

scene::SceneSnapshot cornell() {
    auto world = scene::builtinScene("cornell");
    EXPECT_TRUE(world.ok());
    return scene::extract(world.value(), {}, 0);
}

/// A floor, a light above it, and something glossy and something glowing.
scene::SceneSnapshot mixed() {
    scene::SceneSnapshot snapshot;
    assets::Material plastic = lambertian(glm::vec3(0.6f, 0.5f, 0.4f));
    plastic.specularFactor = 1.0f;
    plastic.roughness = 0.3f;
    addInstance(snapshot, floorMesh(), plastic);
    addInstance(snapshot, test::uvSphere(0.7f, 32, 16), metal(glm::vec3(0.9f, 0.8f, 0.7f), 0.3f),
                glm::translate(glm::mat4(1.0f), {-1, 0.8f, 0}));
    addInstance(snapshot, test::uvSphere(0.3f, 32, 16),
                glowing(glm::vec3(2.0f, 3.0f, 4.0f), glm::vec3(0.3f)),
                glm::translate(glm::mat4(1.0f), {1, 0.4f, 0.5f}));
    addLight(snapshot, {0.5f, 3.0f, 1.0f}, 0.2f, 60.0f);
    addLight(snapshot, {-2.0f, 2.0f, 1.0f}, 0.1f, 20.0f);
    return snapshot;
}
const scene::SnapshotCamera kMixedCamera = lookFrom({0, 2.5f, 5}, {0, 0.4f, 0}, 50.0f);

TEST(Render, GivesTheSameBytesWhateverTheThreads) {
    Settings settings = settingsFor(48, 27, 20);
    settings.transport = Transport::Full;
    settings.smoothIndirect = true;
    settings.threads = 1;
    const Rendered one = rendered(mixed(), kMixedCamera, settings);
    for (const uint32_t threads : {2u, 5u, 0u}) {
        settings.threads = threads;
        const Rendered many = rendered(mixed(), kMixedCamera, settings);
        for (const std::string_view name : kImageNames)
            EXPECT_EQ(one.image(name)->values, many.image(name)->values) << name;
        EXPECT_EQ(one.rays, many.rays);
        EXPECT_EQ(one.relativeError, many.relativeError);
    }
}

TEST(Render, GivesTheSameBytesOfASceneThatIsBuiltOnce) {
    auto built = BuiltScene::build(mixed());
    ASSERT_TRUE(built.ok());
    const BuiltScene scene = std::move(built).value();  // may be moved
    const scene::SnapshotCamera other = lookFrom({1, 1.5f, 4}, {0, 0.4f, 0}, 50.0f);
    const Settings settings = settingsFor(24, 14, 8);
    for (const scene::SnapshotCamera& camera : {kMixedCamera, other}) {
        const auto again = scene.render(camera, settings);
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(again.value().final.values, rendered(mixed(), camera, settings).final.values);
    }
}

TEST(Render, SeedsDrawOtherSamplesOfTheSameLight) {
    Settings settings = settingsFor(32, 18, 32);
    const auto camera = cornell().cameras.front();
    const Rendered a = rendered(cornell(), camera, settings);
    settings.seed = 2;
    const Rendered b = rendered(cornell(), camera, settings);
    EXPECT_NE(a.final.values, b.final.values);
    EXPECT_NEAR(meanOf(a.final).x, meanOf(b.final).x, 0.03 * meanOf(a.final).x);
}

TEST(Render, PartsAddUpToTheWhole) {
    for (const auto transport : {Transport::Diffuse, Transport::Full}) {
        Settings settings = settingsFor(48, 27, 8);
        settings.transport = transport;
        const Rendered r = rendered(mixed(), kMixedCamera, settings);
        int glows = 0;
        for (uint32_t y = 0; y < 27; ++y)
            for (uint32_t x = 0; x < 48; ++x) {
                const glm::vec3 sum = pixelOf(r.direct, x, y) + pixelOf(r.indirect, x, y);
                const glm::vec3 rest = pixelOf(r.final, x, y) - sum;
                if (rest.z > 3.9f) {
                    ++glows;
                } else {
                    EXPECT_LT(glm::length(rest), 1e-4f * (1.0f + glm::length(sum)));
                }
                const glm::vec3 matt = pixelOf(r.albedo, x, y) / math::kPi;
                const glm::vec3 diffuse = matt * pixelOf(r.irradianceIndirect, x, y);
                if (transport == Transport::Diffuse) {
                    EXPECT_LT(glm::length(diffuse - pixelOf(r.indirect, x, y)), 1e-5f);
                }
            }
        EXPECT_GT(glows, 5);
    }
}

TEST(Render, OfALambertianSceneIsTheSameInFullTransport) {
    Settings settings = settingsFor(32, 18, 8);
    const auto camera = cornell().cameras.front();
    const Rendered diffuse = rendered(cornell(), camera, settings);
    settings.transport = Transport::Full;
    EXPECT_EQ(diffuse.final.values, rendered(cornell(), camera, settings).final.values);
}

TEST(Render, LightsShowTheirDiscsInFinalAlone) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 2.0f, 0.0f}, 0.5f, 10.0f);
    addLight(snapshot, {0.0f, -2.0f, 0.0f}, 3.0f, 1e-3f);  // from below, hidden up to y = 0
    const Rendered r =
        rendered(snapshot, lookFrom({0.0f, 6.0f, 0.001f}, {0, 0, 0}, 60.0f, {0, 0, -1}),
                 settingsFor(17, 17, 4));
    EXPECT_NEAR(r.final.at(8, 8, 0), 10.0f / (4.0f * math::kPi * math::kPi * 0.25f), 1e-3f);
    EXPECT_LT(r.direct.at(8, 8, 0), 0.5f) << "what lies behind";
    EXPECT_GT(r.direct.at(8, 8, 0), 0.0f);
    EXPECT_NEAR(r.depth.at(8, 8, 0), 6.0f, 1e-3f);
}

TEST(Render, BackgroundIsExactlyBlack) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, test::quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}),
                lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0, 1, 0}, 0.1f, 10.0f);
    const Rendered r =
        rendered(snapshot, lookFrom({0.0f, 4.0f, 0.001f}, {0, 0, 0}, 60.0f, {0, 0, -1}),
                 settingsFor(24, 24, 2));
    for (const std::string_view name : kImageNames) EXPECT_EQ(r.image(name)->values[0], 0.0f);
    EXPECT_GT(r.final.at(12, 9, 0), 0.0f);
}

TEST(Render, AWallShadowsBothWays) {
    for (const bool turned : {false, true}) {
        scene::SceneSnapshot snapshot;
        addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
        addInstance(snapshot,
                    turned ? test::quad({-4, 2, -4}, {4, 2, -4}, {4, 2, 4}, {-4, 2, 4})
                           : test::quad({-4, 2, 4}, {4, 2, 4}, {4, 2, -4}, {-4, 2, -4}),
                    lambertian(glm::vec3(0.5f)));
        addLight(snapshot, {0.0f, 3.0f, 0.0f}, 0.3f, 100.0f);
        const Rendered r =
            rendered(snapshot, lookFrom({0.0f, 1.0f, 0.001f}, {0, 0, 0}, 60.0f, {0, 0, -1}),
                     settingsFor(16, 16, 8));
        EXPECT_EQ(meanOf(r.irradianceDirect).x, 0.0);
    }
}

TEST(Render, PixelsInCornersAreNotBlack) {
    // Rays through pixel centres that meet a room's edges and corners, up to rounding.
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, boxFromInside(5.0f), lambertian(glm::vec3(0.5f)));
    addLight(snapshot, {0.0f, 0.0f, 0.0f}, 0.5f, 1000.0f);
    constexpr uint32_t kSide = 49;
    const float slope = kSide / (kSide - 1.0f);
    for (int turn = 0; turn < 6; ++turn) {
        const float angle = 0.5f * math::kPi * static_cast<float>(turn);
        const auto camera = lookFrom({0, 0, 0}, {std::sin(angle), 0, std::cos(angle)},
                                     glm::degrees(2.0f * std::atan(slope)));
        const Rendered r = rendered(snapshot, camera, settingsFor(kSide, kSide, 8));
        for (uint32_t i = 0; i < kSide; ++i)
            for (const uint32_t j : {0u, kSide - 1}) {
                ASSERT_GT(r.irradianceDirect.at(i, j, 0), 0.1f) << i << "," << j;
                ASSERT_GT(r.irradianceDirect.at(j, i, 0), 0.1f) << j << "," << i;
            }
    }
}

TEST(Render, WhatIsCutOutCastsNoShadow) {
    // A lid between the light and the floor.
    const auto lit = [](float alpha) {
        scene::SceneSnapshot snapshot;
        addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
        assets::Material lid = lambertian(glm::vec3(0.5f));
        lid.baseColour.a = alpha;
        lid.alphaMode = assets::AlphaMode::Mask;
        addInstance(snapshot, test::quad({-4, 2, 4}, {4, 2, 4}, {4, 2, -4}, {-4, 2, -4}), lid);
        addLight(snapshot, {0.0f, 3.0f, 0.0f}, 0.3f, 100.0f);
        return rendered(snapshot, lookFrom({0.0f, 6.0f, 0.001f}, {0, 0, 0}, 20.0f, {0, 0, -1}),
                        settingsFor(8, 8, 32));
    };
    const Rendered there = lit(0.6f), gone = lit(0.4f);
    EXPECT_NEAR(there.depth.at(4, 4, 0), 4.0f, 1e-3f);
    EXPECT_NEAR(gone.depth.at(4, 4, 0), 6.0f, 1e-3f);
    EXPECT_NEAR(gone.irradianceDirect.at(4, 4, 0), 100.0f / (4.0f * math::kPi * 9.0f), 0.02f);
    EXPECT_EQ(meanOf(gone.indirect), glm::dvec3(0.0));
    EXPECT_GT(there.irradianceDirect.at(4, 4, 0), 5.0f);
}

TEST(Render, StopsOnceTheErrorIsSmallEnough) {
    const auto camera = cornell().cameras.front();
    Settings settings = settingsFor(48, 27, 4096);
    settings.maxError = 0.2f;
    const Rendered r = rendered(cornell(), camera, settings);
    EXPECT_LT(r.samplesPerPixel, 1024u);
    EXPECT_LE(r.relativeError, 0.2);
    EXPECT_GT(r.relativeError, 0.05);
}

TEST(Render, TheErrorIsTheDeviationOverSeeds) {
    constexpr uint32_t kSeeds = 12;
    const auto camera = cornell().cameras.front();
    Settings settings = settingsFor(32, 18, 32);
    std::vector<Rendered> renders;
    for (settings.seed = 1; settings.seed <= kSeeds; ++settings.seed)
        renders.push_back(rendered(cornell(), camera, settings));
    double deviation = 0.0, estimate = 0.0;
    for (size_t i = 0; i < renders[0].error.values.size(); ++i) {
        double mean = 0.0;
        const auto radiance = [&](const Rendered& r) {
            return static_cast<double>(r.direct.values[i] + r.indirect.values[i]);
        };
        for (const Rendered& r : renders) mean += radiance(r) / kSeeds;
        for (const Rendered& r : renders) {
            deviation += (radiance(r) - mean) * (radiance(r) - mean) / (kSeeds - 1);
            estimate += static_cast<double>(r.error.values[i] * r.error.values[i]) / kSeeds;
        }
    }
    EXPECT_NEAR(std::sqrt(estimate / deviation), 1.0, 0.05);
    settings.samplesPerPixel = 128;
    EXPECT_NEAR(rendered(cornell(), camera, settings).relativeError, 0.5 * renders[0].relativeError,
                0.1 * renders[0].relativeError);
}

TEST(Render, CountsItsRaysAndTellsHowFarItIs) {
    uint64_t last = 0, total = 0, calls = 0;
    const auto result = render(cornell(), cornell().cameras.front(), settingsFor(64, 36, 18),
                               [&](uint64_t done, uint64_t all) {
                                   EXPECT_GE(done, last);
                                   last = done;
                                   total = all;
                                   ++calls;
                                   return true;
                               });
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(last, 64u * 36u * 18u);
    EXPECT_EQ(total, last);
    EXPECT_GT(calls, 4u);
    EXPECT_GT(result.value().rays, 64u * 36u * 18u);
    EXPECT_GT(result.value().seconds, 0.0);
}

TEST(Render, StopsSoonWhereItIsTold) {
    uint64_t calls = 0;
    Settings settings = settingsFor(512, 512, 64);
    settings.threads = 1;
    const auto result = render(cornell(), cornell().cameras.front(), settings,
                               [&](uint64_t, uint64_t) { return ++calls < 3; });
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().message, "the reference was stopped");
    EXPECT_EQ(calls, 3u);
}

TEST(Render, WithoutSamplesHasWhatNeedsNone) {
    Settings settings = settingsFor(16, 9, 0);
    settings.smoothIndirect = true;
    const auto result =
        render(cornell(), cornell().cameras.front(), settings, [](uint64_t, uint64_t) {
            ADD_FAILURE() << "nothing is to be done";
            return true;
        });
    ASSERT_TRUE(result.ok());
    EXPECT_GT(meanOf(result.value().albedo).x, 0.1);
    EXPECT_EQ(meanOf(result.value().direct), glm::dvec3(0.0));
    EXPECT_EQ(result.value().relativeError, 0.0);
}

TEST(Render, WithoutLightIsBlackAndHasNoError) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
    const Rendered r = rendered(snapshot, lookFrom({0, 4, 4}, {0, 0, 0}), settingsFor(8, 8, 4));
    EXPECT_EQ(meanOf(r.final), glm::dvec3(0.0));
    EXPECT_EQ(r.relativeError, 0.0);
    EXPECT_GT(meanOf(r.albedo).x, 0.1);
}

TEST(Render, RefusesPicturesThatMemoryDoesNotHold) {
    const auto result = render(cornell(), cornell().cameras.front(), settingsFor(65535, 65535, 1));
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().message.find("65535x65535"), std::string::npos);
}

TEST(Render, KnowsItsImagesByName) {
    const Rendered r;
    for (const std::string_view name : kImageNames) EXPECT_NE(r.image(name), nullptr) << name;
    EXPECT_EQ(r.image("edges"), nullptr);
    EXPECT_TRUE(showsLight("error"));
    EXPECT_FALSE(showsLight("depth"));
}

}  // namespace
}  // namespace lampyris::reference
