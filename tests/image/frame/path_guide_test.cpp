// Photons guided to what the camera sees: less noise, the same light.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/frame_test.h"
#include "support/small_scenes.h"

namespace lampyris {
namespace {

class GuidedPhotons : public test::FrameTest {
 protected:
    struct Spread {
        double mean = 0.0;      ///< of the picture
        double error = 0.0;     ///< standard error of that
        double variance = 0.0;  ///< of a pixel between frames
    };

    /// Frames of one renderer, the first ones left out: it must learn.
    static Spread spreadOf(const scene::SceneSnapshot& snapshot, photon_gi::FrameRequest wanted,
                           bool guiding) {
        constexpr uint64_t kFirst = 6, kFrames = 60;
        wanted.settings.guiding = guiding;
        wanted.settings.gatherRays = 32;  // photons are what is noisy
        wanted.settings.photonPaths = 1000;
        test::SceneRenderer renderer(device(), snapshot);
        std::vector<double> sums, squares, means;
        for (; wanted.frameNumber < kFirst + kFrames; ++wanted.frameNumber) {
            const auto drawn = render(renderer, wanted, "irradiance_indirect");
            EXPECT_LT(drawn.report.energy.relativeError(), 1e-4);
            const auto& values = drawn.image.values;
            sums.resize(values.size());
            squares.resize(values.size());
            if (wanted.frameNumber < kFirst) continue;
            means.push_back(0.0);
            for (size_t i = 1; i < values.size(); i += 4) {  // green
                const auto value = static_cast<double>(values[i]);
                sums[i] += value;
                squares[i] += value * value;
                means.back() += value * 4.0 / static_cast<double>(values.size());
            }
        }
        Spread spread;
        for (const double mean : means) spread.mean += mean / kFrames;
        for (const double mean : means) spread.error += std::pow(mean - spread.mean, 2.0);
        spread.error = std::sqrt(spread.error) / kFrames;
        for (size_t i = 1; i < sums.size(); i += 4)
            spread.variance += squares[i] / kFrames - std::pow(sums[i] / kFrames, 2.0);
        return spread;
    }

    static void expectSameLight(const Spread& a, const Spread& b) {
        const double error = std::sqrt(a.error * a.error + b.error * b.error);
        EXPECT_NEAR(a.mean, b.mean, 4.0 * error);
        EXPECT_LT(error, 0.015 * a.mean);
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
    expectSameLight(guided, plain);
}

TEST_F(GuidedPhotons, TurnToTheEndOfACorridorThatTheCameraSees) {
    scene::SceneSnapshot snapshot;
    test::addRoom(snapshot, 0.0f, 30.0f);
    test::addLight(snapshot, {9.0f, 1.5f, 0.0f}, 0.1f, 600.0f);
    const auto wanted =
        request(80, 48, test::lookFrom({4.0f, 1.5f, 0.0f}, {0.0f, 1.4f, 0.0f}, 80.0f));
    const Spread plain = spreadOf(snapshot, wanted, false);
    const Spread guided = spreadOf(snapshot, wanted, true);
    EXPECT_LT(guided.variance, 0.8 * plain.variance);
    expectSameLight(guided, plain);
}

}  // namespace
}  // namespace lampyris
