// As photons grow and the radius shrinks, the indirect image of `cornell` tends to a limit.
#include <gtest/gtest.h>

#include <cmath>

#include "support/frame_test.h"

namespace lampyris {
namespace {

class Convergence : public test::FrameTest {
 protected:
    /// Mean indirect irradiance over the floor, more than a metre from walls and boxes, in W/m².
    static double floorMean(uint32_t paths, float radius) {
        const auto snapshot = test::builtinSnapshot("cornell");
        auto wanted =
            request(64, 36, test::lookFrom({-2.3f, 7.0f, 2.8f}, {-2.3f, 0.0f, 2.7f}, 40.0f));
        wanted.settings.photonPaths = paths;
        wanted.settings.radiusMetres = radius;
        wanted.settings.gatherDivisor = 1;
        auto executor = test::need(execute::Executor::create(device()));
        photon_gi::Renderer renderer(executor);
        test::need(renderer.update(snapshot));
        const auto e = render(renderer, wanted, "irradiance_indirect");
        const auto x = render(renderer, wanted, "position");
        EXPECT_LT(e.report.energy.relativeError(), 1e-4);
        double sum = 0.0;
        int count = 0;
        for (uint32_t py = 0; py < 36; ++py)
            for (uint32_t px = 0; px < 64; ++px) {
                const glm::vec3 p(x.image.at(px, py, 0), x.image.at(px, py, 1),
                                  x.image.at(px, py, 2));
                const bool floor = std::abs(p.y) < 1e-2f;
                if (!floor || p.x < -3.8f || p.x > -0.9f || p.z < 1.7f || p.z > 3.8f) continue;
                sum += static_cast<double>(e.image.at(px, py, 1));
                ++count;
            }
        EXPECT_GT(count, 300);
        return sum / count;
    }
};

TEST_F(Convergence, FloorMeanMovesLessThanOnePercentFromOneToFourMillionPaths) {
    const double one = floorMean(1'000'000, 0.2f);
    const double four = floorMean(4'000'000, 0.1f);
    EXPECT_GT(four, 0.0);
    EXPECT_NEAR(one, four, 0.01 * four);
}

}  // namespace
}  // namespace lampyris
