// Photons guided to what the camera sees: less noise, the same light.
#include <gtest/gtest.h>

#include "support/frame_test.h"
#include "support/small_scenes.h"

namespace lampyris {
namespace {

class GuidedPhotons : public test::FrameTest {
 protected:
    struct Spread {
        double mean = 0.0;
        double variance = 0.0;  ///< of a pixel between frames
    };

    /// Frames of one renderer, the first ones left out: it must learn.
    static Spread spreadOf(const scene::SceneSnapshot& snapshot, photon_gi::FrameRequest wanted,
                           bool guiding) {
        constexpr uint64_t kFirst = 6, kFrames = 30;
        wanted.settings.guiding = guiding;
        wanted.settings.gatherRays = 32;  // photons are what is noisy
        wanted.settings.photonPaths = 1000;
        auto executor = test::need(execute::Executor::create(device()));
        photon_gi::Renderer renderer(executor);
        test::need(renderer.update(snapshot));
        std::vector<double> sums, squares;
        for (; wanted.frameNumber < kFirst + kFrames; ++wanted.frameNumber) {
            const auto drawn = render(renderer, wanted, "irradiance_indirect");
            EXPECT_LT(drawn.report.energy.relativeError(), 1e-4);
            sums.resize(drawn.image.values.size());
            squares.resize(drawn.image.values.size());
            if (wanted.frameNumber < kFirst) continue;
            for (size_t i = 0; i < sums.size(); ++i) {
                const auto value = static_cast<double>(drawn.image.values[i]);
                sums[i] += value;
                squares[i] += value * value;
            }
        }
        Spread spread;
        for (size_t i = 1; i < sums.size(); i += 4) {  // green
            const double mean = sums[i] / kFrames;
            spread.mean += mean;
            spread.variance += squares[i] / kFrames - mean * mean;
        }
        return spread;
    }
};

TEST_F(GuidedPhotons, LeaveALightAloneThatTheCameraCannotSee) {
    auto snapshot = test::twoClosedRooms();
    test::addLight(snapshot, {1.5f, 2.0f, 0.0f}, 0.1f, 600.0f);
    auto wanted = request(80, 48, test::lookFrom({-3.5f, 1.5f, 0.0f}, {0.0f, 1.0f, 0.0f}, 80.0f));
    const Spread plain = spreadOf(snapshot, wanted, false);
    const Spread guided = spreadOf(snapshot, wanted, true);
    // A quarter of the paths lit what is seen; now most do.
    EXPECT_LT(guided.variance, 0.5 * plain.variance);
    EXPECT_NEAR(guided.mean, plain.mean, 0.015 * plain.mean);
}

TEST_F(GuidedPhotons, GoThroughTheDoorThatLightComesBy) {
    const auto snapshot = test::builtinSnapshot("two_rooms");
    const auto wanted = request(96, 54, snapshot.cameras.front());
    const Spread plain = spreadOf(snapshot, wanted, false);
    const Spread guided = spreadOf(snapshot, wanted, true);
    EXPECT_LT(guided.variance, 0.85 * plain.variance);
    EXPECT_NEAR(guided.mean, plain.mean, 0.03 * plain.mean);
}

}  // namespace
}  // namespace lampyris
