#include "residency/pack_scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/snapshot_builder.h"

namespace lampyris::residency {
namespace {

glm::vec3 through(const glm::mat4& m, const glm::vec3& p) {
    return glm::vec3(m * glm::vec4(p, 1.0f));
}

TEST(Placement, TakesPointsThereAndBack) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const bool mirror = seed % 2 == 1;
        const auto placement = placementOf(test::anyTransform(seed, mirror));
        ASSERT_TRUE(placement.has_value());
        EXPECT_EQ(placement->mirrored, mirror);
        EXPECT_FALSE(placement->identity);
        const glm::vec3 point(0.3f, -2.0f, 1.5f);
        const glm::vec3 back =
            through(placement->worldToObject, through(placement->objectToWorld, point));
        EXPECT_NEAR(glm::length(back - point), 0.0f, 1e-5f);
    }
    EXPECT_TRUE(placementOf(glm::mat4(1.0f))->identity);
}

TEST(Placement, GivesFlatTransformsAThousandthOfThickness) {
    const auto placement = placementOf(glm::scale(glm::mat4(1.0f), glm::vec3(2.0f, 0.0f, 2.0f)));
    ASSERT_TRUE(placement.has_value());
    const glm::vec3 up = through(placement->objectToWorld, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_NEAR(glm::length(up), 2e-3f, 1e-4f);
    const glm::vec3 back = through(placement->worldToObject, glm::vec3(1.0f, 0.0f, -1.0f));
    EXPECT_NEAR(glm::length(back - glm::vec3(0.5f, 0.0f, -0.5f)), 0.0f, 1e-5f);
}

TEST(Placement, RefusesWhatLeavesNoAreaOrIsNotFinite) {
    EXPECT_FALSE(placementOf(glm::mat4(0.0f)).has_value());
    EXPECT_FALSE(placementOf(glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 0.0f, 0.0f))).has_value());
    glm::mat4 bad(1.0f);
    bad[3].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(placementOf(bad).has_value());
}

TEST(PackInstance, HasRowsFlagsAndRanges) {
    assets::Material material = test::mattMaterial();
    material.alphaMode = assets::AlphaMode::Mask;
    material.doubleSided = true;
    scene::SnapshotInstance instance;
    instance.entity = ecs::Entity{42};
    instance.material = 7;
    instance.objectToWorld = glm::translate(glm::mat4(1.0f), glm::vec3(1.0f, 2.0f, 3.0f));
    const MeshRange range{30, 12, 5, shared::SCENE_NONE, 8, 9};
    const auto packed = packInstance(instance, material, range);
    EXPECT_EQ(packed.objectToWorld1, glm::vec4(0.0f, 1.0f, 0.0f, 2.0f));
    EXPECT_EQ(packed.worldToObject2, glm::vec4(0.0f, 0.0f, 1.0f, -3.0f));
    EXPECT_EQ(packed.flags, shared::INSTANCE_MASKED | shared::INSTANCE_DOUBLE_SIDED);
    EXPECT_EQ(packed.material, 7u);
    EXPECT_EQ(packed.entity, 42u);
    EXPECT_EQ(packed.firstIndex, 30u);
    EXPECT_EQ(packed.firstVertex, 5u);
    EXPECT_EQ(packed.firstTexcoord, 8u);
    EXPECT_EQ(packed.firstColour, 9u);
    EXPECT_EQ(packed.firstTangent, shared::SCENE_NONE);
}

TEST(PackMaterial, PutsWrapFilterAndSetBesideTheLayer) {
    assets::Material material = test::mattMaterial();
    material.emissiveRadiance = glm::vec3(0.0f, 2.0f, 0.0f);
    material.baseColourTexture = {1, 1, assets::Wrap::Clamp, assets::Wrap::Mirror,
                                  assets::Filter::Nearest};
    material.normalTexture = {0, 0, assets::Wrap::Repeat, assets::Wrap::Repeat,
                              assets::Filter::Linear};
    const TextureLayers layers{{shared::SCENE_NONE, 3}, {4, shared::SCENE_NONE}};
    const auto packed = packMaterial(material, layers);
    EXPECT_EQ(packed.baseColourTexture, 3u | shared::TEXTURE_CLAMP_U | shared::TEXTURE_MIRROR_V |
                                            shared::TEXTURE_NEAREST | shared::TEXTURE_SECOND_SET);
    EXPECT_EQ(packed.normalTexture, 4u);
    EXPECT_EQ(packed.emissiveTexture, shared::SCENE_NONE);
    EXPECT_EQ(packed.flags, shared::MATERIAL_EMISSIVE);
}

}  // namespace
}  // namespace lampyris::residency
