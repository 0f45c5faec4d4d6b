// Refitting on the CPU: boxes hold what moved, and links stay.
#include <gtest/gtest.h>

#include <cstring>

#include "accel/refit_slots.h"
#include "support/deformations.h"

namespace lampyris::test {
namespace {

using accel::Blas;
using accel::LeafTriangle;

bool same(const Blas& a, const Blas& b) {
    return std::memcmp(a.tree.nodes.data(), b.tree.nodes.data(),
                       a.tree.nodes.size() * sizeof(accel::Node)) == 0 &&
           std::memcmp(a.triangles.data(), b.triangles.data(),
                       a.triangles.size() * sizeof(LeafTriangle)) == 0;
}

bool isZero(const LeafTriangle& triangle) {
    return triangle.v0 == glm::vec3(0) && triangle.v1 == glm::vec3(0) &&
           triangle.v2 == glm::vec3(0);
}

/// Every corner below a link lies within the box that the link's parent has for it, and that box
/// within its own parent's.
void expectInside(const Blas& blas, uint32_t link, const math::Bounds& box) {
    const auto inside = [&](const math::Bounds& inner) {
        return glm::all(glm::lessThanEqual(box.lower, inner.lower)) &&
               glm::all(glm::greaterThanEqual(box.upper, inner.upper));
    };
    if (accel::isLeaf(link)) {
        for (uint32_t i = 0; i < accel::leafCount(link); ++i) {
            const LeafTriangle& t = blas.triangles[accel::linkIndex(link) + i];
            if (isZero(t)) continue;
            math::Bounds corners;
            for (const glm::vec3& corner : {t.v0, t.v1, t.v2}) corners.grow(corner);
            EXPECT_TRUE(inside(corners)) << "primitive " << t.primitive;
        }
        return;
    }
    const accel::Node& node = blas.tree.nodes[accel::linkIndex(link)];
    for (const auto& [child, childLink] :
         {std::pair(node.leftBox, node.leftLink), std::pair(node.rightBox, node.rightLink)}) {
        const math::Bounds inner = accel::fromCells(blas.tree.grid, child);
        if (child.x == accel::kNoBox.x) {
            expectInside(blas, childLink, {});  // holds nothing that can be hit
            continue;
        }
        EXPECT_TRUE(inside(inner));
        expectInside(blas, childLink, inner);
    }
}

TEST(Refit, HoldsWhateverMoves) {
    const assets::Mesh mesh = triangleSoup(3000, 0.1f, 1);
    Blas blas = posedBlasOf(mesh);
    uint32_t seed = 2;
    for (const Deformation how : kDeformations) {
        const auto positions = deformed(mesh, how, ++seed);
        const uint32_t dropped = refitTo(blas, mesh, positions);
        EXPECT_EQ(dropped > 0, how == Deformation::Flatten || how == Deformation::Break);
        EXPECT_EQ(std::count_if(blas.triangles.begin(), blas.triangles.end(), isZero), dropped);
        expectInside(blas, blas.tree.rootLink,
                     {glm::vec3(-std::numeric_limits<float>::max()),
                      glm::vec3(std::numeric_limits<float>::max())});
    }
}

TEST(Refit, ChangesNothingWhereNothingMoved) {
    const assets::Mesh mesh = triangleSoup(50000, 0.1f, 4);
    const Blas built = posedBlasOf(mesh);
    Blas refitted = built;
    EXPECT_EQ(refitTo(refitted, mesh, mesh.positions), 0u);
    EXPECT_TRUE(same(built, refitted));
    refitTo(refitted, mesh, deformed(mesh, Deformation::Scatter, 5));
    EXPECT_FALSE(same(built, refitted));
    refitTo(refitted, mesh, mesh.positions);
    EXPECT_TRUE(same(built, refitted)) << "there and back again";
}

TEST(Refit, KeepsTrianglesThatAPoseMayMakeWhole) {
    assets::Mesh mesh = triangleSoup(20, 0.5f, 6);
    const auto whole = mesh.positions;
    for (int i = 0; i < 30; ++i) mesh.positions[i] = glm::vec3(0.5f);
    Blas blas = posedBlasOf(mesh);
    EXPECT_EQ(blas.dropped, 10u);
    EXPECT_EQ(refitTo(blas, mesh, whole), 0u);
    EXPECT_EQ(std::count_if(blas.triangles.begin(), blas.triangles.end(), isZero), 0);
}

TEST(Refit, TakesTheSmallestMeshes) {
    for (const uint32_t count : {1u, 2u, 3u, 4u, 5u}) {
        const assets::Mesh mesh = triangleSoup(count, 0.5f, count);
        Blas blas = posedBlasOf(mesh);
        ASSERT_FALSE(accel::isLeaf(blas.tree.rootLink));
        refitTo(blas, mesh, deformed(mesh, Deformation::Teleport, 1));
        expectInside(blas, blas.tree.rootLink, {glm::vec3(-1e30f), glm::vec3(1e30f)});
    }
    assets::Mesh none;
    EXPECT_EQ(posedBlasOf(none).tree.rootLink, shared::BVH_NOTHING);
}

TEST(Refit, CostsMoreWhereTrianglesScatterAndAsMuchWhereTheyMoveTogether) {
    const assets::Mesh mesh = triangleSoup(5000, 0.05f, 8);
    Blas blas = posedBlasOf(mesh);
    const double built = accel::costOf(blas.tree);
    EXPECT_GT(built, 10.0);
    refitTo(blas, mesh, deformed(mesh, Deformation::Teleport, 9));
    EXPECT_NEAR(accel::costOf(blas.tree), built, 0.01 * built);
    refitTo(blas, mesh, deformed(mesh, Deformation::Scatter, 9));
    EXPECT_GT(accel::costOf(blas.tree), 5.0 * built);
}

TEST(RefitSlots, ListEveryChildOnceBehindItsOwnChildren) {
    const Blas blas = posedBlasOf(triangleSoup(3000, 0.1f, 10));
    const accel::RefitSlots slots = accel::listSlots(blas.tree);
    ASSERT_EQ(slots.texels.size(), 2 * blas.tree.nodes.size());
    ASSERT_EQ(slots.levels.back(), slots.texels.size());
    EXPECT_EQ(slots.levels.size() - 1, blas.tree.depth) << "a level for each node of the deepest";
    std::vector<uint32_t> levelOf(slots.texels.size(), ~0u);
    for (uint32_t level = 0; level + 1 < slots.levels.size(); ++level)
        for (uint32_t i = slots.levels[level]; i < slots.levels[level + 1]; ++i)
            levelOf[slots.texels[i]] = level;
    for (uint32_t texel = 0; texel < levelOf.size(); ++texel) {
        const accel::Node& node = blas.tree.nodes[texel / 2];
        const uint32_t link = texel % 2 == 0 ? node.leftLink : node.rightLink;
        EXPECT_EQ(levelOf[texel] == 0, accel::isLeaf(link));
        if (accel::isLeaf(link)) continue;
        EXPECT_GT(levelOf[texel], levelOf[2 * accel::linkIndex(link)]);
        EXPECT_GT(levelOf[texel], levelOf[2 * accel::linkIndex(link) + 1]);
    }
}

}  // namespace
}  // namespace lampyris::test
