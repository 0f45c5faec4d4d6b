// Pixels that no texel of the low resolution stands for: they trace few rays of their own, and
// share them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/frame_test.h"
#include "support/small_scenes.h"

namespace lampyris {
namespace {

/// A room that is seen past a narrow slat, upright on the camera's axis.
scene::SceneSnapshot slattedRoom() {
    scene::SceneSnapshot snapshot;
    test::addRoom(snapshot, 0.0f, 4.0f);
    test::addLight(snapshot, {0.8f, 2.6f, 1.0f}, 0.1f, 200.0f);
    constexpr float kHalf = 0.07f;
    test::addInstance(snapshot,
                      test::quad({2.3f, 0.6f, -kHalf}, {2.3f, 0.6f, kHalf}, {2.3f, 2.4f, kHalf},
                                 {2.3f, 2.4f, -kHalf}),
                      test::lambertian(glm::vec3(0.5f)));
    return snapshot;
}

class AlonePixels : public test::FrameTest {
 protected:
    static constexpr uint32_t kWidth = 160, kHeight = 96;
    // Inside the slat, which reaches no texel's pixel (76, 84).
    static constexpr uint32_t kLeft = 78, kRight = 82, kTop = 20, kBottom = 76;

    static photon_gi::FrameRequest ask() {
        return request(kWidth, kHeight, test::lookFrom({0.3f, 1.5f, 0.0f}, {4.0f, 1.5f, 0.0f}));
    }
    static void forSlat(const auto& visit) {
        for (uint32_t y = kTop; y < kBottom; ++y)
            for (uint32_t x = kLeft; x < kRight; ++x) visit(x, y);
    }
};

TEST_F(AlonePixels, AreWhatNoTexelStandsFor) {
    const auto edges = render(slattedRoom(), ask(), "edges").image;
    forSlat([&](uint32_t x, uint32_t y) { ASSERT_EQ(edges.at(x, y, 0), 1.0f) << x << ", " << y; });
}

TEST_F(AlonePixels, ShareTheirRaysAndKeepTheLight) {
    const auto snapshot = slattedRoom();
    const auto shown = render(snapshot, ask(), "irradiance_indirect").image;
    auto many = ask();  // into the same photons
    many.settings.gatherDivisor = 1;
    many.settings.filterLevels = 0;
    many.settings.gatherRays = 256;
    const auto truth = render(snapshot, many, "irradiance_indirect").image;
    double squares = 0.0, sum = 0.0, sumOfTruth = 0.0, steps = 0.0;
    size_t pixels = 0;
    forSlat([&](uint32_t x, uint32_t y) {
        const double is = shown.at(x, y, 1), should = truth.at(x, y, 1);
        squares += (is / should - 1.0) * (is / should - 1.0);
        steps += std::abs(static_cast<double>(shown.at(x, y + 1, 1)) / is - 1.0);
        sum += is;
        sumOfTruth += should;
        ++pixels;
    });
    EXPECT_LT(std::sqrt(squares / static_cast<double>(pixels)), 0.08);
    EXPECT_LT(steps / static_cast<double>(pixels), 0.03) << "speckles";
    EXPECT_NEAR(sum / sumOfTruth, 1.0, 0.03);
}

}  // namespace
}  // namespace lampyris
