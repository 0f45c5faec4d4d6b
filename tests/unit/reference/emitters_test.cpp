#include "reference/emitters.h"

#include "reference/surface.h"
#include "support/snapshot_builder.h"
#include "unit/reference/chi_squared.h"
#include "unit/reference/scenes.h"

namespace lampyris::reference {
namespace {

/// Squares of 1 and 4 m², the second brighter and mirrored, and one that does not glow.
RayScene threeSquares() {
    test::SnapshotBuilder builder;
    const uint32_t square = builder.addMesh(test::unitSquare());
    builder.addInstance(square, builder.addMaterial(glowing(glm::vec3(3.0f))));
    builder.addInstance(square, builder.addMaterial(test::mattMaterial()),
                        glm::translate(glm::mat4(1.0f), {0, 0, 3}));
    glm::mat4 mirrored = glm::translate(glm::mat4(1.0f), {5, 0, 0});
    mirrored = glm::scale(mirrored, {-2, 2, 1});
    assets::Material twoSided = glowing(glm::vec3(9.0f, 0.0f, 0.0f));
    twoSided.doubleSided = true;
    builder.addInstance(square, builder.addMaterial(twoSided), mirrored);
    return built(builder.snapshot);
}

TEST(Emitters, TrianglesAreChosenByPower) {
    const RayScene scene = threeSquares();
    const Emitters emitters(scene);
    ASSERT_EQ(emitters.count(), 4u);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    std::vector<double> counted(4, 0.0), left(4, 0.0);
    constexpr uint32_t kCount = 40000;
    for (uint32_t i = 0; i < kCount; ++i) {
        float xi = std::min(uniform(random), 0x1.fffffep-1f);
        const size_t k = emitters.choose(xi);
        ASSERT_LT(k, 4u);
        ++counted[k];
        left[k] += static_cast<double>(xi);
    }
    // 3 · ½ m² each, and 3 · 2 m² · two sides each.
    expectFollows(counted, {kCount * 1.5 / 27.0, kCount * 1.5 / 27.0, kCount * 12.0 / 27.0,
                            kCount * 12.0 / 27.0});
    for (size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(left[k] / counted[k], 0.5, 0.02) << "what is left of the number is even";
}

TEST(Emitters, DensitiesIntegrateToOne) {
    const RayScene scene = threeSquares();
    const Emitters emitters(scene);
    const float sum = 0.5f * (emitters.density(0, 0) + emitters.density(0, 1)) +
                      2.0f * (emitters.density(2, 0) + emitters.density(2, 1));
    EXPECT_NEAR(sum, 1.0f, 1e-5f);
    EXPECT_EQ(emitters.density(1, 0), 0.0f);
}

TEST(Emitters, PointsAreEvenOverTheirTriangle) {
    test::SnapshotBuilder builder;
    builder.addInstance(builder.addMesh(test::unitSquare()),
                        builder.addMaterial(glowing(glm::vec3(1.0f))));
    const RayScene scene = built(builder.snapshot);
    const Emitters emitters(scene);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    constexpr uint32_t kCount = 40000;
    std::vector<double> counted(64, 0.0);
    for (uint32_t i = 0; i < kCount; ++i) {
        const EmitterSample s = emitters.sample(
            {0.3f, 0.3f, 1.0f}, {uniform(random), uniform(random), uniform(random)});
        EXPECT_EQ(s.density, 1.0f);
        ++counted[std::min<size_t>(static_cast<size_t>(s.position.x * 8.0f), 7) * 8 +
                  std::min<size_t>(static_cast<size_t>(s.position.y * 8.0f), 7)];
    }
    expectFollows(counted, std::vector<double>(64, kCount / 64.0));
}

TEST(Emitters, OneSidedOnesGlowToTheirFront) {
    const RayScene scene = threeSquares();
    const Emitters emitters(scene);
    int front = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 xi((i + 0.5f) / 100.0f, 0.3f, 0.3f);
        const EmitterSample above = emitters.sample({2, 0, 4}, xi);
        const EmitterSample below = emitters.sample({2, 0, -4}, xi);
        EXPECT_GT(above.normal.z, 0.99f) << "mirrored instances keep their front";
        EXPECT_GT(above.radiance.x, 0.0f);
        const bool twoSided = above.position.x > 2.0f;
        EXPECT_EQ(below.radiance.x > 0.0f, twoSided);
        front += twoSided ? 0 : 1;
    }
    EXPECT_GT(front, 5);
}

TEST(Emitters, TexturesSteerTheChoiceAndColourThePoint) {
    test::SnapshotBuilder builder;
    // Left half black, right half white.
    assets::TextureImage image{"half", 2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
    assets::Material material = glowing(glm::vec3(4.0f));
    material.emissiveTexture.image = builder.addImage(image);
    material.emissiveTexture.filter = assets::Filter::Nearest;
    builder.addInstance(builder.addMesh(test::unitSquare()), builder.addMaterial(material));
    const RayScene scene = built(builder.snapshot);
    const Emitters emitters(scene);
    // Of the lower triangle three quarters lie in the right half, of the upper one quarter.
    EXPECT_NEAR(emitters.density(0, 0) / emitters.density(0, 1), 3.0f, 0.3f);
    for (int i = 0; i < 64; ++i) {
        const EmitterSample s =
            emitters.sample({0.5f, 0.5f, 2.0f}, {(i + 0.5f) / 64.0f, 0.37f, 0.61f});
        EXPECT_EQ(s.radiance.x, s.position.x > 0.5f ? 4.0f : 0.0f);
    }
}

}  // namespace
}  // namespace lampyris::reference
