// statue and hairball: counts, soundness, and the bytes, which no run or machine may change.
#include <gtest/gtest.h>

#include "scene/builtin/hairball.h"
#include "scene/builtin/statue.h"
#include "unit/scene/mesh_facts.h"

namespace lampyris::scene::builtin {
namespace {

TEST(Statue, StandsSoundOnTheGround) {
    const assets::Mesh statue = makeStatue();
    EXPECT_EQ(statue.triangleCount(), 1002252u);
    EXPECT_EQ(test::flaws(statue), 0u);
    EXPECT_NEAR(statue.bounds.lower.y, 0.0f, 1e-6f);
    EXPECT_NEAR(statue.bounds.upper.y, 5.0f, 1e-5f);
    EXPECT_GT(test::volume(statue), 20.0);
    EXPECT_EQ(test::hashOf(statue), 10200922225257836177u);
    // Looks along +z: the nose is the foremost point, near the middle.
    glm::vec3 foremost(0.0f);
    for (const glm::vec3& p : statue.positions) foremost = p.z > foremost.z ? p : foremost;
    EXPECT_NEAR(foremost.x, 0.0f, 0.2f);
}

TEST(Hairball, FillsItsBallWithTubes) {
    const assets::Mesh hairball = makeHairball(3.0f);
    EXPECT_EQ(hairball.triangleCount(), 2880000u);
    EXPECT_EQ(hairball.positions.size(), 1448000u);
    EXPECT_EQ(test::flaws(hairball), 0u);
    EXPECT_EQ(test::hashOf(hairball), 2789136288021002726u);
    size_t inner = 0;
    float outermost = 0.0f;
    for (const glm::vec3& p : hairball.positions) {
        outermost = glm::max(outermost, glm::length(p));
        inner += glm::length(p) < 1.5f ? 1 : 0;
    }
    EXPECT_LE(outermost, 3.0f);
    EXPECT_GT(outermost, 2.85f);
    // Denser in the middle, where all tubes begin, but not there alone: an eighth would be even.
    EXPECT_GT(inner, hairball.positions.size() / 8);
    EXPECT_LT(inner, hairball.positions.size() * 2 / 3);
}

}  // namespace
}  // namespace lampyris::scene::builtin
