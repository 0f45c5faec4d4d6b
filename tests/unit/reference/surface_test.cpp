#include "reference/surface.h"

#include <gtest/gtest.h>

#include "support/snapshot_builder.h"

namespace lampyris::reference {
namespace {

const glm::vec3 kDown(0.0f, 0.0f, -1.0f), kUp(0.0f, 0.0f, 1.0f);

/// One square, seen in the middle of its first triangle.
class Square : public testing::Test {
 protected:
    Square() { material_.metallic = 0.0f; }
    int32_t image(std::vector<uint8_t> rgba) {
        return builder_.addImage({"texel", 1, 1, std::move(rgba)});
    }
    const MeshPoint& point(const glm::mat4& matrix = glm::mat4(1.0f)) {
        builder_.addInstance(builder_.addMesh(mesh_), builder_.addMaterial(material_), matrix);
        placed_ = place(builder_.snapshot, builder_.snapshot.instances.back());
        EXPECT_TRUE(placed_.has_value());
        point_.emplace(*placed_, 0, 0.25f, 0.25f);
        return *point_;
    }
    test::SnapshotBuilder builder_;
    assets::Material material_;
    assets::Mesh mesh_ = test::unitSquare();
    std::optional<PlacedMesh> placed_;
    std::optional<MeshPoint> point_;
};

TEST_F(Square, LiesWhereItsCornersDoAndFacesTheRay) {
    const auto matrix = glm::translate(glm::mat4(1.0f), {0, 0, 5});
    const Surface above = surfaceAt(point(matrix), kDown);
    EXPECT_LT(glm::length(above.position - glm::vec3(0.5f, 0.25f, 5.0f)), 1e-6f);
    EXPECT_EQ(above.geometric, kUp);
    EXPECT_EQ(above.shading, kUp);
    const Surface below = surfaceAt(point(matrix), kUp);
    EXPECT_EQ(below.geometric, kDown);
    EXPECT_EQ(below.shading, kDown);
}

TEST_F(Square, MirroredAndFlattenedKeepsItsFront) {
    const auto mirrored = glm::scale(glm::mat4(1.0f), {-2.0f, 1.0f, 1.0f});
    EXPECT_LT(glm::length(surfaceAt(point(mirrored), kDown).geometric - kUp), 1e-6f);
    EXPECT_LT(glm::length(surfaceAt(point(mirrored), kDown).shading - kUp), 1e-6f);
    const auto flat = glm::scale(glm::mat4(1.0f), {2.0f, 1.0f, 0.0f});
    EXPECT_LT(glm::length(surfaceAt(point(flat), kDown).shading - kUp), 1e-6f);
}

TEST_F(Square, AlbedoIsTheColourLessWhatMetalTakes) {
    material_.baseColour = {0.8f, 0.4f, 0.2f, 1.0f};
    material_.metallic = 0.25f;
    mesh_.colours.assign(4, {0.5f, 1.0f, 1.0f, 1.0f});
    const Surface surface = surfaceAt(point(), kDown);
    EXPECT_LT(glm::length(surface.albedo - 0.75f * glm::vec3(0.4f, 0.4f, 0.2f)), 1e-6f);
    const glm::vec3 f0 = 0.75f * glm::vec3(0.04f) + 0.25f * glm::vec3(0.4f, 0.4f, 0.2f);
    EXPECT_LT(glm::length(surface.f0 - f0), 1e-6f);
}

TEST_F(Square, SpecularFactorZeroIsLambertian) {
    EXPECT_TRUE(surfaceAt(point(), kDown).glossy());
    EXPECT_FALSE(mattSurfaceAt(point(), kDown).glossy());
    material_.specularFactor = 0.0f;
    EXPECT_FALSE(surfaceAt(point(), kDown).glossy());
}

TEST_F(Square, TexturesMultiplyTheirFactors) {
    material_.baseColour = {0.5f, 1.0f, 1.0f, 1.0f};
    material_.roughness = 0.5f;
    material_.metallic = 1.0f;
    material_.baseColourTexture.image = image({255, 188, 0, 255});
    material_.metallicRoughnessTexture.image = image({9, 102, 51, 255});
    const Surface surface = surfaceAt(point(), kDown);
    EXPECT_NEAR(surface.roughness, 0.5f * 0.4f, 1e-6f);
    EXPECT_NEAR(surface.albedo.x, 0.8f * 0.5f, 1e-6f);
    EXPECT_NEAR(surface.albedo.y, 0.8f * 0.503f, 1e-3f) << "188 in sRGB is a half";
    EXPECT_EQ(surface.albedo.z, 0.0f);
}

TEST_F(Square, NormalMapsTiltTheShadingNormalAlone) {
    mesh_.tangents.assign(4, {1, 0, 0, 1});
    material_.normalTexture.image = image({255, 128, 128, 255});  // along the tangent
    const Surface surface = surfaceAt(point(), kDown);
    EXPECT_GT(surface.shading.x, 0.99f);
    EXPECT_EQ(surface.geometric, kUp);
    material_.normalScale = 0.5f;
    material_.normalTexture.image = image({255, 128, 255, 255});
    const Surface scaled = surfaceAt(point(), kDown);
    EXPECT_NEAR(scaled.shading.x / scaled.shading.z, 0.5f, 0.01f);
    material_.normalTexture.image = image({128, 255, 128, 255});
    mesh_.tangents.assign(4, {1, 0, 0, -1});
    EXPECT_LT(surfaceAt(point(), kDown).shading.y, -0.9f) << "handedness";
    EXPECT_EQ(mattSurfaceAt(point(), kDown).shading, kUp) << "bounces do not see it";
}

TEST_F(Square, GlowsToItsFrontOrToBothSides) {
    material_.emissiveRadiance = {1, 2, 3};
    EXPECT_EQ(emittedRadiance(point(), true), glm::vec3(1, 2, 3));
    EXPECT_EQ(emittedRadiance(point(), false), glm::vec3(0));
    material_.doubleSided = true;
    EXPECT_EQ(emittedRadiance(point(), false), glm::vec3(1, 2, 3));
    material_.emissiveTexture.image = image({255, 0, 255, 255});
    EXPECT_EQ(surfaceAt(point(), kDown).emission, glm::vec3(1, 0, 3));
}

TEST_F(Square, AlphaMaskCutsOutBelowItsCutoff) {
    material_.baseColourTexture.image = image({255, 255, 255, 102});  // 0.4
    EXPECT_TRUE(opaque(point()));
    material_.alphaMode = assets::AlphaMode::Blend;
    EXPECT_TRUE(opaque(point())) << "drawn opaque";
    material_.alphaMode = assets::AlphaMode::Mask;
    EXPECT_FALSE(opaque(point()));
    material_.alphaCutoff = 0.4f;
    EXPECT_TRUE(opaque(point()));
}

TEST_F(Square, HasNoPlaceWithoutTrianglesOrNumbers) {
    builder_.addInstance(builder_.addMesh({}), builder_.addMaterial(material_));
    EXPECT_FALSE(place(builder_.snapshot, builder_.snapshot.instances.back()));
    glm::mat4 broken(1.0f);
    broken[3][1] = std::numeric_limits<float>::quiet_NaN();
    builder_.addInstance(builder_.addMesh(mesh_), builder_.addMaterial(material_), broken);
    EXPECT_FALSE(place(builder_.snapshot, builder_.snapshot.instances.back()));
}

}  // namespace
}  // namespace lampyris::reference
