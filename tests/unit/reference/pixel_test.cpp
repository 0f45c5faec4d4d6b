#include "reference/pixel.h"

#include <gtest/gtest.h>

#include "support/small_scenes.h"

namespace lampyris::reference {
namespace {

/// Looks into a scene through the one pixel of a camera.
class Looker {
 public:
    explicit Looker(const scene::SceneSnapshot& snapshot)
        : scene_(RayScene::build(snapshot).value()), lights_(snapshot), emitters_(scene_) {}
    [[nodiscard]] Pixel seenFrom(const glm::vec3& eye, const glm::vec3& target) const {
        const Stage stage{&scene_, &lights_, &emitters_};
        return lookThrough(stage, PixelRays(test::lookFrom(eye, target), 1, 1).through(0, 0));
    }
    [[nodiscard]] const SphereLights& lights() const { return lights_; }

 private:
    RayScene scene_;
    SphereLights lights_;
    Emitters emitters_;
};

TEST(PixelRays, GoThroughPixelCentres) {
    const auto camera = test::lookFrom({1, 2, 3}, {1, 2, 0}, 90.0f);
    const PixelRays rays(camera, 4, 2);
    const Ray ray = rays.through(0, 0);
    EXPECT_EQ(ray.origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(ray.near, camera.nearMetres);
    // At one metre the picture is 2 m high and 4 m wide: the centre of its first pixel.
    EXPECT_LT(glm::length(ray.direction - glm::vec3(-1.5f, 0.5f, -1.0f)), 1e-6f);
    EXPECT_LT(glm::length(rays.through(3, 1).direction - glm::vec3(1.5f, -0.5f, -1.0f)), 1e-6f);
    EXPECT_NEAR(rays.footprint(), 1.0f, 1e-6f);
}

TEST(LookThrough, FindsTheSurfaceItsDepthAndTheNearestDiscBeforeIt) {
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}),
                      test::lambertian(glm::vec3(0.5f)));
    test::addLight(snapshot, {0, 0, 4}, 0.5f, 10.0f);
    test::addLight(snapshot, {0, 0, 2}, 0.5f, 20.0f);
    test::addLight(snapshot, {0, 0, -2}, 0.5f, 40.0f);
    const Looker looker(snapshot);
    const auto seenFrom = [&](const glm::vec3& eye, const glm::vec3& target) {
        return looker.seenFrom(eye, target);
    };
    const Pixel front = seenFrom({0, 0, 8}, {0, 0, 0});
    ASSERT_TRUE(front.surface.has_value());
    EXPECT_NEAR(front.depthMetres, 8.0f, 1e-5f);
    EXPECT_LT(glm::length(front.toEye - glm::vec3(0, 0, 1)), 1e-6f);
    EXPECT_EQ(front.disc, looker.lights().radiance(0, {0, 0, -1}));
    EXPECT_EQ(seenFrom({0, 0, 3}, {0, 0, 0}).disc, looker.lights().radiance(1, {0, 0, -1}));
    EXPECT_FALSE(seenFrom({0, 0, 1}, {0, 0, 0}).disc) << "only behind the wall";
    EXPECT_FALSE(seenFrom({0, 0.1f, 4}, {0, 0.1f, 0}).disc ==
                 looker.lights().radiance(0, {0, 0, -1}))
        << "from inside a light its disc is not drawn";
    const Pixel away = seenFrom({0, 0, 8}, {0, 0, 9});
    EXPECT_FALSE(away.surface.has_value());
    EXPECT_FALSE(away.disc.has_value());
}

TEST(LookThrough, SeesNoBackThroughAnOutline) {
    // Two sides of a post that meet in an upright edge: one to the camera, one away from it.
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::quad({0, -9, 0}, {-1, -9, -1}, {-1, 9, -1}, {0, 9, 0}),
                      test::lambertian({0, 0, 0.5f}));
    test::addInstance(snapshot, test::quad({-1, -9, 0}, {0, -9, 0}, {0, 9, 0}, {-1, 9, 0}),
                      test::lambertian({0.5f, 0, 0}));
    const Looker looker(snapshot);
    const auto seenFrom = [&](const glm::vec3& eye, const glm::vec3& target) {
        return looker.seenFrom(eye, target).surface;
    };
    int met = 0;
    for (int i = 0; i < 1000; ++i) {
        const float height = 0.0137f * static_cast<float>(i) - 6.85f;
        const auto seen = seenFrom({0.0031f * static_cast<float>(i), 1, 5}, {0, height, 0});
        if (!seen) continue;  // past the edge
        ++met;
        EXPECT_EQ(seen->albedo.b, 0.0f) << "ray " << i;
    }
    EXPECT_GT(met, 100);
    const auto other = seenFrom({-0.5f, 0, -5}, {-0.5f, 0, 0});
    ASSERT_TRUE(other.has_value());
    EXPECT_GT(other->albedo.b, 0.0f) << "its front is seen from there";
    const auto open = seenFrom({-0.5f, 0, -0.2f}, {-0.5f, 0, 0});
    ASSERT_TRUE(open.has_value());
    EXPECT_GT(open->albedo.r, 0.0f) << "backs that lie open are seen";
}

}  // namespace
}  // namespace lampyris::reference
