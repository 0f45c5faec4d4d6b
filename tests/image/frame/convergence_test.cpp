// As photons grow and the radius shrinks, the indirect image of `cornell` tends to a limit.
#include <gtest/gtest.h>

#include <cmath>

#include "support/frame_test.h"

namespace lampyris {
namespace {

class Convergence : public test::FrameTest {
 protected:
    /// Mean indirect irradiance over the floor, more than half a metre from walls and boxes, in
    /// W/m².
    static double floorMean(uint32_t paths, float radius) {
        const auto snapshot = test::builtinSnapshot("cornell");
        auto wanted =
            request(48, 48, test::lookFrom({0.0f, 9.8f, 0.5f}, {0.0f, 0.0f, 0.501f}, 48.0f));
        wanted.settings.photonPaths = paths;
        wanted.settings.radiusMetres = radius;
        wanted.settings.gather = photon_gi::Gather::Tiles;
        wanted.settings.gatherDivisor = 1;
        test::SceneRenderer renderer(device(), snapshot);
        const auto e = render(renderer, wanted, "irradiance_indirect");
        wanted.settings.pipeline = photon_gi::Pipeline::Direct;
        const auto x = render(renderer, wanted, "position");
        EXPECT_LT(e.report.energy.relativeError(), 1e-4);
        double sum = 0.0;
        int count = 0;
        for (uint32_t py = 0; py < 48; ++py)
            for (uint32_t px = 0; px < 48; ++px) {
                const glm::vec3 p(x.image.at(px, py, 0), x.image.at(px, py, 1),
                                  x.image.at(px, py, 2));
                if (!openFloor(p)) continue;
                sum += static_cast<double>(e.image.at(px, py, 1));
                ++count;
            }
        EXPECT_GT(count, 200);
        return sum / count;
    }

 private:
    static bool openFloor(const glm::vec3& p) {
        const bool inside = std::abs(p.y) < 1e-2f && std::abs(p.x) < 4.2f && std::abs(p.z) < 4.2f;
        // Half a box's diagonal and more than half a metre.
        const bool nearTall = glm::length(glm::vec2(p.x + 1.7f, p.z + 1.4f)) < 2.7f;
        const bool nearShort = glm::length(glm::vec2(p.x - 1.7f, p.z - 1.5f)) < 2.7f;
        return inside && !nearTall && !nearShort;
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
