#include "reference/ray_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "support/snapshot_builder.h"
#include "unit/reference/scenes.h"

namespace lampyris::reference {
namespace {

/// Where a ray meets a triangle, in double; infinity where it does not.
double meet(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a,
            const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 p = glm::cross(direction, c - a), o = origin - a, q = glm::cross(o, b - a);
    const double det = glm::dot(b - a, p);
    const double u = glm::dot(o, p) / det, v = glm::dot(direction, q) / det;
    const double t = glm::dot(c - a, q) / det;
    const bool hit = std::abs(det) > 1e-12 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0;
    return hit ? t : std::numeric_limits<double>::infinity();
}

TEST(RayScene, FindsWhatALoopOverAllTrianglesFinds) {
    test::SnapshotBuilder builder;
    const uint32_t matt = builder.addMaterial(test::mattMaterial());
    for (uint32_t i = 0; i < 4; ++i)
        builder.addInstance(builder.addMesh(test::triangleSoup(60, 0.6f, i)), matt,
                            test::anyTransform(i, i == 2));
    const RayScene scene = built(builder.snapshot);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray{4.0f * point(), point()};
        double nearest = std::numeric_limits<double>::infinity();
        for (uint32_t instance = 0; instance < 4; ++instance) {
            const PlacedMesh& placed = *scene.placed(instance);
            const auto corner = [&](size_t k) {
                return glm::dvec3(placed.positionsWorld[placed.mesh->indices[k]]);
            };
            for (size_t k = 0; k < placed.mesh->indices.size(); k += 3)
                nearest = std::min(nearest, meet(ray.origin, ray.direction, corner(k),
                                                 corner(k + 1), corner(k + 2)));
        }
        const auto hit = scene.closest(ray);
        ASSERT_EQ(hit.has_value(), std::isfinite(nearest)) << i;
        EXPECT_EQ(scene.blocked(ray), hit.has_value());
        if (!hit) continue;
        ++hits;
        ASSERT_NEAR(hit->t, nearest, 1e-4 * nearest);
        const glm::vec3 at = scene.pointAt(*hit).positionWorld();
        EXPECT_LT(glm::length(at - (ray.origin + hit->t * ray.direction)), 1e-4f);
        EXPECT_FALSE(scene.blocked({ray.origin, ray.direction, 0.0f, 0.999f * hit->t}));
        EXPECT_TRUE(scene.blocked({ray.origin, ray.direction, 0.0f, 1.001f * hit->t}));
    }
    EXPECT_GT(hits, 300);
}

TEST(RayScene, CutsOutWhatTheMaskLeavesOut) {
    test::SnapshotBuilder builder;
    // Left half cut out, right half there.
    assets::Material leaf = test::mattMaterial();
    leaf.alphaMode = assets::AlphaMode::Mask;
    leaf.baseColourTexture.image =
        builder.addImage({"half", 2, 1, {255, 255, 255, 0, 255, 255, 255, 255}});
    leaf.baseColourTexture.filter = assets::Filter::Nearest;
    const uint32_t square = builder.addMesh(test::unitSquare());
    builder.addInstance(square, builder.addMaterial(leaf));
    builder.addInstance(square, builder.addMaterial(test::mattMaterial()),
                        glm::translate(glm::mat4(1.0f), {0, 0, -1}));
    const RayScene scene = built(builder.snapshot);
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 down(0, 0, -side);
        const auto left = scene.closest({{0.25f, 0.3f, 0.5f * side}, down});
        const auto right = scene.closest({{0.75f, 0.3f, 0.5f * side}, down});
        EXPECT_EQ(left.has_value(), side > 0.0f) << "the square behind";
        ASSERT_TRUE(right.has_value());
        EXPECT_EQ(right->instance, 0u) << "from either side";
        EXPECT_FALSE(scene.blocked({{0.25f, 0.3f, 0.5f * side}, down, 0.0f, 1.0f}));
        EXPECT_TRUE(scene.blocked({{0.75f, 0.3f, 0.5f * side}, down, 0.0f, 1.0f}));
    }
}

TEST(RayScene, LeavesOutWhatHasNoPlace) {
    test::SnapshotBuilder builder;
    const uint32_t matt = builder.addMaterial(test::mattMaterial());
    builder.addInstance(builder.addMesh({}), matt);
    builder.addInstance(builder.addMesh(test::unitSquare()), matt);
    const RayScene scene = built(builder.snapshot);
    EXPECT_EQ(scene.placed(0), nullptr);
    const auto hit = scene.closest({{0.5f, 0.4f, 1.0f}, {0, 0, -1}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->instance, 1u);
    EXPECT_FALSE(built({}).closest({{0, 0, 1}, {0, 0, -1}}).has_value()) << "an empty scene";
}

TEST(RayScene, NoRaySlipsThroughAnEdge) {
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::uvSphere(1.0f, 48, 24), test::lambertian(glm::vec3(0.5f)));
    const RayScene scene = built(snapshot);
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    const PlacedMesh& placed = *scene.placed(0);
    for (size_t k = 0; k < placed.mesh->indices.size(); ++k) {
        // From the middle and from near the wall.
        const glm::vec3 a = placed.positionsWorld[placed.mesh->indices[k]];
        const glm::vec3 b = placed.positionsWorld[placed.mesh->indices[k - k % 3 + (k + 1) % 3]];
        const glm::vec3 from = 0.3f * glm::vec3(normal(random), normal(random), normal(random));
        if (glm::length(from) > 0.9f) continue;
        ASSERT_TRUE(scene.blocked({from, glm::mix(a, b, 0.37f) - from}));
    }
}

TEST(RayScene, ClearanceGrowsWithTheScene) {
    scene::SceneSnapshot small, large;
    test::addInstance(small, test::uvSphere(1.0f, 8, 4), test::lambertian(glm::vec3(0.5f)));
    test::addInstance(large, test::uvSphere(1000.0f, 8, 4), test::lambertian(glm::vec3(0.5f)));
    EXPECT_GT(built(small).clearance(), 0.0f);
    EXPECT_NEAR(built(large).clearance() / built(small).clearance(), 1000.0f, 1.0f);
}

}  // namespace
}  // namespace lampyris::reference
