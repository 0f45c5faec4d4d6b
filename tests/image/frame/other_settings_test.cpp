// Settings that change from frame to frame, as a budget changes them: what goes on and what begins
// anew.
#include <gtest/gtest.h>

#include <cmath>

#include "support/frame_test.h"

namespace lampyris {
namespace {

using photon_gi::Settings;

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
        const core::Image a = last(1, change);
        const core::Image b = last(2, change);
        double apart = 0.0;
        double sum = 0.0;
        for (size_t i = 0; i < a.values.size(); ++i) {
            apart += std::abs(static_cast<double>(a.values[i] - b.values[i]));
            sum += static_cast<double>(a.values[i]);
        }
        return apart / sum;
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
        const auto drawn = render(renderer, asked, "final");
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
