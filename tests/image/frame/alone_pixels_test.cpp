// Pixels that no texel of the low resolution stands for: they trace few rays of their own, and
// share them.
#include <gtest/gtest.h>

#include <cmath>

#include "support/frame_test.h"
#include "support/small_scenes.h"

namespace lampyris {
namespace {

constexpr float kHalf = 0.07f;  // metres: half the width of what stands in the room

scene::SceneSnapshot litRoom() {
    scene::SceneSnapshot snapshot;
    test::addRoom(snapshot, 0.0f, 4.0f);
    test::addLight(snapshot, {0.8f, 2.6f, 1.0f}, 0.1f, 200.0f);
    return snapshot;
}

/// A narrow slat, upright on the camera's axis.
scene::SceneSnapshot slattedRoom() {
    auto snapshot = litRoom();
    test::addInstance(snapshot,
                      test::quad({2.3f, 0.6f, -kHalf}, {2.3f, 0.6f, kHalf}, {2.3f, 2.4f, kHalf},
                                 {2.3f, 2.4f, -kHalf}),
                      test::lambertian(glm::vec3(0.5f)));
    return snapshot;
}

/// A round pole in the slat's place, with light close to it on the side of positive z.
scene::SceneSnapshot poledRoom() {
    auto snapshot = litRoom();
    snapshot.lights.front().positionWorld = {2.3f, 1.5f, 1.6f};
    constexpr int kSides = 32;
    assets::Mesh pole;
    for (int i = 0; i <= kSides; ++i) {
        const float angle = 2.0f * math::kPi * static_cast<float>(i % kSides) / kSides;
        const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle));
        for (const float height : {0.6f, 2.4f}) {
            pole.positions.push_back(glm::vec3(2.3f, height, 0.0f) + kHalf * out);
            pole.normals.push_back(out);
        }
    }
    for (uint32_t i = 0; i < 2 * kSides; i += 2)
        pole.indices.insert(pole.indices.end(), {i, i + 1, i + 3, i, i + 3, i + 2});
    test::addInstance(snapshot, std::move(pole), test::lambertian(glm::vec3(0.5f)));
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
    /// The truth: many rays a pixel, into the same photons.
    static photon_gi::FrameRequest many() {
        auto wanted = ask();
        wanted.settings.gatherDivisor = 1;
        wanted.settings.filterLevels = 0;
        wanted.settings.gatherRays = 256;
        return wanted;
    }
    static void forSlat(const auto& visit) {
        for (uint32_t y = kTop; y < kBottom; ++y)
            for (uint32_t x = kLeft; x < kRight; ++x) visit(x, y);
    }
};

TEST_F(AlonePixels, AreListed) {
    const auto edges = render(slattedRoom(), ask(), "edges").image;
    forSlat([&](uint32_t x, uint32_t y) { ASSERT_EQ(edges.at(x, y, 0), 1.0f) << x << ", " << y; });
}

TEST_F(AlonePixels, ShareTheirRaysAndKeepTheLight) {
    const auto snapshot = slattedRoom();
    const auto shown = render(snapshot, ask(), "irradiance_indirect").image;
    const auto truth = render(snapshot, many(), "irradiance_indirect").image;
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

TEST_F(AlonePixels, KeepApartWhatALeaningSurfaceSees) {
    const auto snapshot = poledRoom();
    /// How much brighter the side of the light is.
    const auto contrast = [&](const photon_gi::FrameRequest& wanted) {
        const auto shown = render(snapshot, wanted, "irradiance_indirect").image;
        double dim = 0.0, bright = 0.0;
        for (uint32_t y = kTop; y < kBottom; ++y) {
            dim += static_cast<double>(shown.at(kLeft, y, 1));
            bright += static_cast<double>(shown.at(kRight - 1, y, 1));
        }
        return bright / dim;
    };
    const double should = contrast(many());
    const double is = contrast(ask());
    EXPECT_GT(should, 1.3);
    EXPECT_NEAR(is, should, 0.1 * should);
}

}  // namespace
}  // namespace lampyris
