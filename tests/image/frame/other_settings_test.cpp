// Settings that change from frame to frame, as a budget changes them: what goes on and what begins
// anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/frame_test.h"

namespace lampyris {
namespace {

using photon_gi::Settings;

/// How far two pictures lie apart, as a share of the light in the first.
double apart(const core::Image& a, const core::Image& b) {
    double difference = 0.0;
    double sum = 0.0;
    for (size_t i = 0; i < a.values.size(); ++i) {
        difference += std::abs(static_cast<double>(a.values[i] - b.values[i]));
        sum += static_cast<double>(a.values[i]);
    }
    return difference / sum;
}

class OtherSettings : public test::FrameTest {
 protected:
    /// The last of 24 still frames, each with settings of its own.
    static core::Image last(uint32_t seed, void (*change)(Settings&, uint32_t)) {
        const auto snapshot = test::builtinSnapshot("cornell");
        auto asked = request(96, 54, snapshot.cameras.front());
        asked.settings.history = 32;
        asked.settings.gatherDivisor = 4;
        asked.settings.photonPaths = 1000;
        asked.settings.seed = seed;
        const Settings settings = asked.settings;
        test::SceneRenderer renderer(device(), snapshot);
        core::Image image;
        for (uint32_t i = 0; i < 24; ++i) {
            asked.settings = settings;
            change(asked.settings, i);
            asked.frameNumber = i;
            image = render(renderer, asked, "irradiance_indirect").image;
        }
        return image;
    }
    /// How far two seeds lie apart, as a share of the light.
    static double noise(void (*change)(Settings&, uint32_t)) {
        return apart(last(1, change), last(2, change));
    }
};

TEST_F(OtherSettings, TheMeanGoesOnWithOtherPathsRaysAndRadius) {
    const double steady = noise([](Settings&, uint32_t) {});
    const double alone = noise([](Settings& s, uint32_t) { s.history = 0; });
    EXPECT_GT(alone, 2.0 * steady);
    EXPECT_LT(noise([](Settings& s, uint32_t i) { s.photonPaths += 16 * (i % 2); }), 1.3 * steady);
    // Rays of the frames are a net together only where each draws as many.
    EXPECT_LT(noise([](Settings& s, uint32_t i) { s.gatherRays += i % 2; }), 1.5 * steady);
    EXPECT_LT(noise([](Settings& s, uint32_t i) { s.radiusMetres += i % 2 == 0 ? 0.0f : 0.1f; }),
              1.3 * steady);
    // The last frame's grid of texels is another than that of the mean.
    EXPECT_GT(noise([](Settings& s, uint32_t i) { s.gatherDivisor += i == 23 ? 1 : 0; }),
              1.5 * steady);
}

TEST_F(OtherSettings, StillFramesKeepTheirPictureOnlyWhereNothingIsChanged) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto asked = request(64, 36, snapshot.cameras.front());
    asked.settings.history = 4;
    asked.finalAlone = true;
    test::SceneRenderer renderer(device(), snapshot);
    const auto draw = [&] {
        auto drawn = render(renderer, asked, "final");
        ++asked.frameNumber;
        return drawn;
    };
    for (uint32_t i = 0; i < 8; ++i) (void)draw();
    const auto kept = draw();
    EXPECT_EQ(kept.report.retraced, 0u);
    asked.settings.photonPaths += 100;
    EXPECT_EQ(draw().report.retraced, asked.settings.photonPaths);
    for (uint32_t i = 0; i < 2; ++i) (void)draw();
    EXPECT_EQ(draw().report.retraced, 0u);  // the mean was full, and still is
    asked.settings.gatherDivisor += 1;
    for (uint32_t i = 0; i < 4; ++i) EXPECT_GT(draw().report.retraced, 0u) << i;
    for (uint32_t i = 0; i < 4; ++i) (void)draw();
    EXPECT_EQ(draw().report.retraced, 0u);
    renderer.forget();
    EXPECT_GT(draw().report.retraced, 0u);
}

TEST_F(OtherSettings, DirectLightStaysAsItIsWithoutShadows) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto asked = request(64, 36, snapshot.cameras.front());
    asked.settings.history = 4;
    test::SceneRenderer renderer(device(), snapshot);
    const auto draw = [&] {
        ++asked.frameNumber;
        return render(renderer, asked, "irradiance_direct").image;
    };
    for (uint32_t i = 0; i < 3; ++i) (void)draw();
    asked.settings.shadows = false;
    const core::Image first = draw();
    asked.settings.shadows = true;
    EXPECT_GT(apart(draw(), first), 0.02) << "shadows are seen at all";
    asked.settings.shadows = false;
    for (uint32_t i = 0; i < 3; ++i) EXPECT_EQ(draw().values, first.values) << "frame " << i;
    asked.camera.cameraToWorld[3].x += 0.3f;
    const core::Image elsewhere = draw();
    EXPECT_EQ(draw().values, elsewhere.values) << "the surface of the camera of now";
}

TEST_F(OtherSettings, ASettledPictureIsOneThatWasKept) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto asked = request(64, 36, snapshot.cameras.front());
    asked.settings.history = 4;
    test::SceneRenderer renderer(device(), snapshot);
    core::Image last;
    for (uint32_t i = 0; i < 8; ++i, ++asked.frameNumber)  // others are looked at meanwhile
        last = render(renderer, asked, "final").image;
    asked.finalAlone = true;
    for (uint32_t i = 0; i < 3; ++i, ++asked.frameNumber)
        EXPECT_LT(apart(render(renderer, asked, "final").image, last), 0.2) << "frame " << i;
}

TEST_F(OtherSettings, BatchesGrowAgainWhereThereIsRoom) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto asked = request(96, 54, snapshot.cameras.front());
    asked.settings.gather = photon_gi::Gather::Tiles;
    asked.settings.photonPaths = 30'000;
    asked.settings.maxBounces = 4;
    test::SceneRenderer renderer(device(), snapshot);
    const auto batches = [&] {
        graph::Frame frame;
        const auto drawn = test::need(renderer.declare(frame, asked));
        test::need(renderer.run(frame, drawn, {}));
        ++asked.frameNumber;
        return std::count_if(frame.nodes().begin(), frame.nodes().end(), [](const auto& node) {
            return node.name.starts_with("photon_trace");
        });
    };
    const auto usual = batches();
    asked.settings.radiusMetres = 20.0f;
    int64_t most = 0;
    for (uint32_t i = 0; i < 4; ++i) most = std::max<int64_t>(most, batches());
    EXPECT_GT(most, usual);
    asked.settings.radiusMetres = 0.1f;
    for (uint32_t i = 0; i < 12; ++i) (void)batches();
    EXPECT_EQ(batches(), usual);
}

TEST(SettingsThatGoOn, AreThoseThatMeanTheSameLight) {
    const Settings asked;
    const auto with = [&](auto change) {
        Settings s = asked;
        change(s);
        return s;
    };
    EXPECT_TRUE(photon_gi::meanGoesOn(asked, with([](Settings& s) { s.photonPaths = 9; })));
    EXPECT_FALSE(photon_gi::meanGoesOn(asked, with([](Settings& s) { s.maxBounces = 1; })));
    EXPECT_FALSE(photon_gi::meanGoesOn(asked, with([](Settings& s) { s.gatherDivisor = 9; })));
    EXPECT_FALSE(photon_gi::meanGoesOn(asked, with([](Settings& s) { s.seed = 9; })));
    EXPECT_TRUE(photon_gi::pathsGoOn(asked, with([](Settings& s) { s.gatherDivisor = 9; })));
    EXPECT_TRUE(photon_gi::pathsGoOn(asked, with([](Settings& s) { s.radiusMetres = 2.0f; })));
    EXPECT_FALSE(photon_gi::pathsGoOn(asked, with([](Settings& s) { s.photonPaths = 9; })));
    EXPECT_FALSE(photon_gi::pathsGoOn(asked, with([](Settings& s) { s.maxBounces = 1; })));
    EXPECT_TRUE(photon_gi::sameDirectLight(asked, with([](Settings& s) { s.photonPaths = 9; })));
    EXPECT_FALSE(photon_gi::sameDirectLight(asked, with([](Settings& s) { s.shadowRays = 1; })));
}

}  // namespace
}  // namespace lampyris
