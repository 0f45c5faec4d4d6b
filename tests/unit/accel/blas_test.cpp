#include "accel/blas.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/snapshot_builder.h"

namespace lampyris::accel {
namespace {

Blas built(const assets::Mesh& mesh) {
    TreeBuilder builder;
    auto blas = buildBlas(builder, mesh);
    if (!blas.ok()) ADD_FAILURE() << blas.error().message;
    return std::move(blas).value();
}

TEST(Blas, KeepsEveryTriangleExactly) {
    const assets::Mesh mesh = test::triangleSoup(1000, 0.2f, 1);
    const Blas blas = built(mesh);
    ASSERT_EQ(blas.triangles.size(), 1000u);
    std::vector<bool> seen(1000, false);
    for (const LeafTriangle& triangle : blas.triangles) {
        seen[triangle.primitive] = true;
        EXPECT_EQ(triangle.v0, mesh.positions[3 * triangle.primitive]);
        EXPECT_EQ(triangle.v1, mesh.positions[3 * triangle.primitive + 1]);
        EXPECT_EQ(triangle.v2, mesh.positions[3 * triangle.primitive + 2]);
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 1000);
}

TEST(Blas, DropsTrianglesWithoutAreaOrWithBadCorners) {
    assets::Mesh mesh = test::triangleSoup(5, 0.2f, 2);
    mesh.positions[4] = mesh.positions[3];  // triangle 1: two corners in one
    mesh.positions[8].y = std::numeric_limits<float>::quiet_NaN();
    mesh.positions[9].x = std::numeric_limits<float>::infinity();
    const Blas blas = built(mesh);
    ASSERT_EQ(blas.triangles.size(), 2u);
    EXPECT_EQ(std::min(blas.triangles[0].primitive, blas.triangles[1].primitive), 0u);
    EXPECT_EQ(std::max(blas.triangles[0].primitive, blas.triangles[1].primitive), 4u);
    EXPECT_TRUE(std::isfinite(blas.tree.bounds.upper.x));
}

TEST(Blas, IsEmptyWhereNothingIsLeft) {
    assets::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    mesh.indices = {0, 1, 2};
    const Blas blas = built(mesh);
    EXPECT_TRUE(blas.triangles.empty());
    EXPECT_EQ(blas.tree.rootLink, shared::BVH_NOTHING);
}

}  // namespace
}  // namespace lampyris::accel
