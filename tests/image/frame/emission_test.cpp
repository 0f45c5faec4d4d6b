// Light straight from emissive surfaces against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/frame_test.h"

namespace lampyris {
namespace {

using test::addInstance;

constexpr float kRadiance = 50.0f;  // W/(m²·sr)
constexpr uint32_t kSide = 48;      // pixels

assets::Material glowing() {
    assets::Material material = test::lambertian(glm::vec3(0.0f));
    material.emissiveRadiance = glm::vec3(kRadiance);
    return material;
}

/// The rectangle from −half to half in a plane y = const, front side down; corners in the order of
/// texture coordinates (0, 0), (1, 0), (1, 1), (0, 1).
assets::Mesh facingDown(float half, float y) {
    assets::Mesh mesh =
        test::quad({-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half});
    mesh.texcoords0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return mesh;
}

scene::SceneSnapshot blackFloor(float y = 0.0f) {
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, test::quad({-9, y, 9}, {9, y, 9}, {9, y, -9}, {-9, y, -9}),
                test::lambertian(glm::vec3(0.0f)));
    return snapshot;
}

/// Irradiance of a polygon of that radiance at a place that sees all of it (Lambert's formula).
double polygonIrradiance(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& place,
                         const glm::dvec3& normal) {
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        const glm::dvec3 a = glm::normalize(corners[i] - place);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % 4] - place);
        sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), normal);
    }
    return 0.5 * static_cast<double>(kRadiance) * std::abs(sum);
}

std::array<glm::dvec3, 4> rectangle(double x0, double x1, double z0, double z1, double y) {
    return {glm::dvec3(x0, y, z0), {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
}

class Emission : public test::FrameTest {
 protected:
    static photon_gi::FrameRequest ask(const scene::SnapshotCamera& camera) {
        auto wanted = request(kSide, kSide, camera);
        wanted.settings.gatherDivisor = 1;
        wanted.settings.filterLevels = 0;
        wanted.settings.maxBounces = 1;
        return wanted;
    }
    /// A piece of floor of about 2 m, seen from under the emitter.
    static scene::SnapshotCamera fromUnderTheEmitter() {
        return test::lookFrom({0.0f, 1.5f, 0.001f}, {}, 60.0f, {0, 0, -1});
    }

    struct Compared {
        double bias = 0.0;      ///< of the mean over all pixels, relative
        double variance = 0.0;  ///< of one pixel, relative to the square of its irradiance
        double chance = 0.0;    ///< that a ray by the cosine meets the emitter, mean over pixels
    };
    /// Over a few frames.
    static Compared compare(const scene::SceneSnapshot& snapshot,
                            const photon_gi::FrameRequest& asked,
                            const std::array<glm::dvec3, 4>& emitter,
                            const glm::dvec3& normal = {0, 1, 0}) {
        constexpr int kFrames = 4;
        auto wanted = asked;
        const auto place = render(snapshot, wanted, "position").image;
        Compared result;
        double got = 0.0, expected = 0.0;
        for (wanted.settings.seed = 1; wanted.settings.seed <= kFrames; ++wanted.settings.seed) {
            const auto e = render(snapshot, wanted, "irradiance_indirect").image;
            for (uint32_t y = 0; y < kSide; ++y)
                for (uint32_t x = 0; x < kSide; ++x) {
                    const glm::dvec3 at(place.at(x, y, 0), place.at(x, y, 1), place.at(x, y, 2));
                    const double truth = polygonIrradiance(emitter, at, normal);
                    const double value = static_cast<double>(e.at(x, y, 0));
                    got += value;
                    expected += truth;
                    result.variance += std::pow(value / truth - 1.0, 2.0);
                    result.chance += truth / (M_PI * static_cast<double>(kRadiance));
                }
        }
        constexpr double kCount = kFrames * double{kSide} * kSide;
        result.bias = got / expected - 1.0;
        result.variance /= kCount;
        result.chance /= kCount;
        return result;
    }
};

TEST_F(Emission, OfASmallRectangleIsItsFormFactorWithoutSparks) {
    auto snapshot = blackFloor();
    // Twice as long by its transform: areas count in the world.
    addInstance(snapshot, facingDown(0.1f, 1.0f), glowing(),
                glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 2.0f, 2.0f)));
    const auto wanted = ask(fromUnderTheEmitter());
    const auto got = compare(snapshot, wanted, rectangle(-0.1, 0.1, -0.2, 0.2, 2.0));
    EXPECT_NEAR(got.bias, 0.0, 0.01);
    // Rays by the cosine alone meet it or not: relative variance (1 − p)/(n·p), here about 50.
    EXPECT_GT((1.0 - got.chance) / (wanted.settings.gatherRays * got.chance), 40.0);
    EXPECT_LT(got.variance, 0.05);
}

TEST_F(Emission, OfALargeRectangleNearByIsItsFormFactor) {
    auto snapshot = blackFloor();
    addInstance(snapshot, facingDown(3.0f, 2.0f), glowing());
    const auto got = compare(snapshot, ask(fromUnderTheEmitter()), rectangle(-3, 3, -3, 3, 2));
    EXPECT_NEAR(got.bias, 0.0, 0.01);
    EXPECT_LT(got.variance, 0.3);
}

TEST_F(Emission, OfATextureIsThatOfItsBrightTexels) {
    auto snapshot = blackFloor();
    auto material = glowing();
    // The left quarter is white, the rest is black.
    std::vector<uint8_t> rgba(size_t{4} * 16 * 16, 0);
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i / 4 % 16 < 4) rgba[i] = 255;
    snapshot.images.push_back(
        {std::make_shared<assets::TextureImage>(assets::TextureImage{"quarter", 16, 16, rgba}), 1});
    material.emissiveTexture.image = 0;
    material.emissiveTexture.filter = assets::Filter::Nearest;
    addInstance(snapshot, facingDown(0.4f, 2.0f), material);
    const auto got =
        compare(snapshot, ask(fromUnderTheEmitter()), rectangle(-0.4, -0.2, -0.4, 0.4, 2.0));
    EXPECT_NEAR(got.bias, 0.0, 0.03);
}

TEST_F(Emission, GoesBothWaysWhereTheMaterialIsDoubleSided) {
    for (const bool doubleSided : {false, true}) {
        auto snapshot = blackFloor(4.0f);  // seen from above
        auto material = glowing();
        material.doubleSided = doubleSided;
        addInstance(snapshot, facingDown(0.3f, 5.0f), material);
        addInstance(snapshot, test::quad({-9, 6, -9}, {9, 6, -9}, {9, 6, 9}, {-9, 6, 9}),
                    test::lambertian(glm::vec3(0.0f)));
        const auto wanted =
            ask(test::lookFrom({0.5f, 5.5f, 0.001f}, {0.5f, 6.0f, 0.0f}, 60.0f, {0, 0, -1}));
        if (doubleSided) {
            const auto got =
                compare(snapshot, wanted, rectangle(-0.3, 0.3, -0.3, 0.3, 5.0), {0, -1, 0});
            EXPECT_NEAR(got.bias, 0.0, 0.02);
            continue;
        }
        for (const float value : render(snapshot, wanted, "irradiance_indirect").image.values)
            ASSERT_TRUE(value == 0.0f || value == 1.0f);  // 1: the alpha channel
    }
}

TEST_F(Emission, OfTwoEmittersAddsUp) {
    auto snapshot = blackFloor();
    addInstance(snapshot, facingDown(0.2f, 2.0f), glowing(),
                glm::translate(glm::mat4(1.0f), glm::vec3(-0.2f, 0.0f, 0.0f)));
    addInstance(snapshot, facingDown(0.2f, 2.0f), glowing(),
                glm::translate(glm::mat4(1.0f), glm::vec3(0.2f, 0.0f, 0.0f)));
    const auto got =
        compare(snapshot, ask(fromUnderTheEmitter()), rectangle(-0.4, 0.4, -0.2, 0.2, 2.0));
    EXPECT_NEAR(got.bias, 0.0, 0.01);
    EXPECT_LT(got.variance, 0.1);
}

TEST_F(Emission, OfAClosedSphereIsPiTimesItsRadiance) {
    scene::SceneSnapshot snapshot;
    auto material = glowing();
    material.doubleSided = true;
    addInstance(snapshot, test::uvSphere(2.0f, 96, 48), material);
    const auto wanted = ask(test::lookFrom({0.0f, 0.0f, 0.5f}, {0.1f, 0.05f, -1.0f}, 70.0f));
    const auto e = render(snapshot, wanted, "irradiance_indirect").image;
    double sum = 0.0;
    for (size_t i = 0; i < e.values.size(); i += e.channels)
        sum += static_cast<double>(e.values[i]);
    const double expected = M_PI * static_cast<double>(kRadiance);
    EXPECT_NEAR(sum / (kSide * kSide), expected, 0.01 * expected);
}

TEST_F(Emission, DoesNotComeThroughWalls) {
    scene::SceneSnapshot snapshot;
    const auto black = test::lambertian(glm::vec3(0.0f));
    const auto wall = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                          const glm::vec3& d) {
        addInstance(snapshot, test::quad(a, b, c, d), black);
    };
    wall({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
    wall({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1});
    wall({-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1});
    wall({1, 0, 1}, {-1, 0, 1}, {-1, 2, 1}, {1, 2, 1});
    wall({-1, 0, 1}, {-1, 0, -1}, {-1, 2, -1}, {-1, 2, 1});
    wall({1, 0, -1}, {1, 0, 1}, {1, 2, 1}, {1, 2, -1});
    addInstance(snapshot, facingDown(1.5f, 2.05f), glowing());
    auto wanted = ask(test::lookFrom({0.0f, 1.0f, 0.9f}, {0.0f, 0.7f, 0.0f}, 90.0f));
    for (wanted.settings.seed = 1; wanted.settings.seed <= 4; ++wanted.settings.seed)
        for (const float value : render(snapshot, wanted, "irradiance_indirect").image.values)
            ASSERT_TRUE(value == 0.0f || value == 1.0f);  // 1: the alpha channel
}

}  // namespace
}  // namespace lampyris
