// lib/bvh_walk.glsl against a loop over all triangles in double precision.
#include "gpu/accel/trace_fixture.h"

namespace lampyris::test {
namespace {

TEST_F(TraceTest, FindsTheNearestTriangleOfAMesh) {
    SnapshotBuilder scene;
    scene.addInstance(scene.addMesh(triangleSoup(500, 0.3f, 1)), scene.addMaterial(mattMaterial()));
    const auto rays = randomRays(4000, 1.5f, 2);
    EXPECT_GT(expectExact(scene.snapshot, rays, trace(scene.snapshot, rays)), 1000u);
}

TEST_F(TraceTest, FindsItAmongTransformedMirroredAndOverlappingInstances) {
    SnapshotBuilder scene;
    const uint32_t material = scene.addMaterial(mattMaterial());
    const uint32_t meshes[] = {scene.addMesh(triangleSoup(60, 0.5f, 3)),
                               scene.addMesh(triangleSoup(1, 0.9f, 4)),
                               scene.addMesh(unitSquare())};
    for (uint32_t i = 0; i < 12; ++i)
        scene.addInstance(meshes[i % 3], material, anyTransform(i, i % 2 == 1));
    const auto rays = randomRays(4000, 3.0f, 5);
    EXPECT_GT(expectExact(scene.snapshot, rays, trace(scene.snapshot, rays)), 500u);
}

TEST_F(TraceTest, TakesASingleTransformedInstance) {
    SnapshotBuilder scene;
    scene.addInstance(scene.addMesh(triangleSoup(100, 0.5f, 6)), scene.addMaterial(mattMaterial()),
                      anyTransform(7, true));
    const auto rays = randomRays(2000, 2.5f, 8);
    EXPECT_GT(expectExact(scene.snapshot, rays, trace(scene.snapshot, rays)), 200u);
}

TEST_F(TraceTest, FollowsAxes) {
    SnapshotBuilder scene;
    scene.addInstance(scene.addMesh(triangleSoup(300, 0.4f, 9)), scene.addMaterial(mattMaterial()));
    auto rays = randomRays(3000, 1.2f, 10);
    for (size_t i = 0; i < rays.size(); ++i) {
        glm::vec3 direction(0.0f);
        direction[static_cast<int>(i % 3)] = i % 2 == 0 ? 1.0f : -1.0f;
        if (i % 5 == 0) direction[static_cast<int>((i + 1) % 3)] = 0.5f;  // one zero component
        rays[i].directionTMax = glm::vec4(direction, 1e30f);
    }
    EXPECT_GT(expectExact(scene.snapshot, rays, trace(scene.snapshot, rays)), 1000u);
}

TEST_F(TraceTest, FollowsAxesInThePlanesOfABox) {
    SnapshotBuilder scene;
    scene.addInstance(scene.addMesh(unitSquare()), scene.addMaterial(mattMaterial()));
    // In the square's edge planes x = 0 and y = 0, and on the diagonal that its triangles share.
    const std::vector<GpuRay> rays = {
        ray({0.0f, 0.5f, 1.0f}, {0, 0, -1}), ray({0.5f, 0.0f, 1.0f}, {0, 0, -1}),
        ray({0.5f, 0.5f, 1.0f}, {0, 0, -1}), ray({0.0f, 0.0f, 1.0f}, {0, 0, -1}),
        ray({1.0f, 1.0f, -1.0f}, {0, 0, 1})};
    for (const GpuHit& hit : trace(scene.snapshot, rays)) {
        EXPECT_EQ(hit.instance, 0u);
        EXPECT_FLOAT_EQ(hit.tBary.x, 1.0f);
    }
}

TEST_F(TraceTest, KeepsWithinTMinAndTMax) {
    SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(unitSquare()),
                   material = scene.addMaterial(mattMaterial());
    for (int i = 1; i <= 3; ++i)
        scene.addInstance(square, material, glm::translate(glm::mat4(1), glm::vec3(0, 0, -i)));
    const glm::vec3 origin(0.3f, 0.6f, 0.0f), down(0.0f, 0.0f, -1.0f);
    const auto hits = trace(
        scene.snapshot, {ray(origin, down), ray(origin, down, 1.0f), ray(origin, down, 1.5f, 1.9f),
                         ray(origin, down, 0.0f, 1.0f), ray(origin, 4.0f * down, 0.3f)});
    EXPECT_EQ(hits[0].instance, 0u);
    EXPECT_EQ(hits[1].instance, 1u) << "tMin itself is no hit";
    EXPECT_EQ(hits[2].instance, shared::SCENE_NONE);
    EXPECT_EQ(hits[2].occluded, 0u);
    EXPECT_EQ(hits[3].instance, 0u) << "tMax itself is one";
    EXPECT_EQ(hits[3].occluded, 1u);
    EXPECT_EQ(hits[4].instance, 1u) << "t counts lengths of the direction";
    EXPECT_FLOAT_EQ(hits[4].tBary.x, 0.5f);
}

TEST_F(TraceTest, StartsOnSurfacesWithoutHittingThem) {
    SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(unitSquare()),
                   material = scene.addMaterial(mattMaterial());
    scene.addInstance(square, material);
    scene.addInstance(square, material, glm::translate(glm::mat4(1), glm::vec3(0, 0, 2)));
    std::vector<GpuRay> rays;
    for (const GpuRay& any : randomRays(500, 0.5f, 11)) {
        const glm::vec3 at(0.5f + 0.9f * any.originTMin.x, 0.5f + 0.9f * any.originTMin.y, 0.0f);
        rays.push_back(
            ray(at, glm::vec3(0.1f * any.directionTMax.x, 0.1f * any.directionTMax.y, 1.0f)));
    }
    for (const GpuHit& hit : trace(scene.snapshot, rays)) EXPECT_NE(hit.instance, 0u);
}

TEST_F(TraceTest, PrefersTheLowerPrimitiveAtEqualDistance) {
    SnapshotBuilder scene;
    assets::Mesh thrice = triangleSoup(200, 0.4f, 12);
    const auto once = thrice.indices;
    for (int copy = 0; copy < 2; ++copy)
        thrice.indices.insert(thrice.indices.end(), once.begin(), once.end());
    const uint32_t mesh = scene.addMesh(thrice), material = scene.addMaterial(mattMaterial());
    for (int copy = 0; copy < 3; ++copy) scene.addInstance(mesh, material, anyTransform(13));
    size_t found = 0;
    for (const GpuHit& hit : trace(scene.snapshot, randomRays(3000, 2.0f, 14))) {
        if (hit.instance == shared::SCENE_NONE) continue;
        ++found;
        EXPECT_EQ(hit.instance, 0u);
        EXPECT_LT(hit.primitive, 200u);
    }
    EXPECT_GT(found, 300u);
}

TEST_F(TraceTest, HitsNothingInAnEmptyScene) {
    SnapshotBuilder scene;
    for (const GpuHit& hit : trace(scene.snapshot, randomRays(70, 1.0f, 15))) {
        EXPECT_EQ(hit.instance, shared::SCENE_NONE);
        EXPECT_EQ(hit.occluded, 0u);
    }
}

TEST_F(TraceTest, LetsNothingOutOfAClosedMesh) {
    // A ball whose triangles share corners exactly; rays from inside aim at corners, edges and
    // anywhere.
    assets::Mesh ball;
    constexpr uint32_t kRings = 24, kSides = 32;
    for (uint32_t i = 0; i <= kRings; ++i)
        for (uint32_t j = 0; j < kSides; ++j) {
            const float a = math::kPi * static_cast<float>(i) / kRings,
                        b = 2.0f * math::kPi * static_cast<float>(j) / kSides;
            ball.positions.push_back(i == 0 ? glm::vec3(0, 5, 0)
                                     : i == kRings
                                         ? glm::vec3(0, -5, 0)
                                         : 5.0f * glm::vec3(std::sin(a) * std::cos(b), std::cos(a),
                                                            std::sin(a) * std::sin(b)));
        }
    for (uint32_t i = 0; i < kRings; ++i)
        for (uint32_t j = 0; j < kSides; ++j) {
            const uint32_t k = (j + 1) % kSides, a = i * kSides + j, b = i * kSides + k,
                           c = a + kSides, d = b + kSides;
            ball.indices.insert(ball.indices.end(), {a, b, c, b, d, c});
        }
    std::vector<GpuRay> rays = randomRays(40000, 2.0f, 16);
    for (size_t i = 0; i < rays.size(); ++i) {
        const auto corner = [&](size_t k) {
            return ball.positions[ball.indices[(3 * i + k) % ball.indices.size()]];
        };
        const glm::vec3 target = i % 3 == 0   ? corner(0)
                                 : i % 3 == 1 ? 0.5f * (corner(0) + corner(1))
                                              : glm::vec3(0);
        if (i % 3 != 2)
            rays[i].directionTMax = glm::vec4(target - glm::vec3(rays[i].originTMin), 1e30f);
    }
    SnapshotBuilder scene;
    scene.addInstance(scene.addMesh(ball), scene.addMaterial(mattMaterial()));
    size_t escaped = 0;
    for (const GpuHit& hit : trace(scene.snapshot, rays))
        escaped += hit.instance == shared::SCENE_NONE ? 1 : 0;
    EXPECT_EQ(escaped, 0u);
}

}  // namespace
}  // namespace lampyris::test
