#include "residency/texture_array.h"

#include <gtest/gtest.h>

#include "residency/image_lookup.h"
#include "support/snapshot_builder.h"

namespace lampyris::residency {
namespace {

assets::TextureImage plain(uint32_t width, uint32_t height, std::array<uint8_t, 4> texel) {
    assets::TextureImage image{"plain", width, height,
                               std::vector<uint8_t>(size_t{4} * width * height)};
    for (size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = texel[i % 4];
    return image;
}

TEST(TexturePlan, GivesLayersToUsedImagesByKind) {
    test::SnapshotBuilder scene;
    for (int i = 0; i < 4; ++i)
        scene.addImage(plain(20u * (static_cast<uint32_t>(i) + 1), 10, {1, 2, 3, 4}));
    assets::Material material = test::mattMaterial();
    material.baseColourTexture.image = 2;
    material.emissiveTexture.image = 0;
    material.normalTexture.image = 2;
    scene.addMaterial(material);
    const auto plan = planTextures(scene.snapshot, 2048);
    ASSERT_TRUE(plan.ok());
    EXPECT_EQ(plan->size, 64u) << "of the largest that is used";
    EXPECT_EQ(plan->layers.colour,
              (std::vector<uint32_t>{1, shared::SCENE_NONE, 2, shared::SCENE_NONE}));
    EXPECT_EQ(plan->layers.data[2], 1u);
    EXPECT_EQ(plan->data.size(), 1u);
    EXPECT_TRUE(plan->colour[0].srgb);
    EXPECT_FALSE(plan->data[0].srgb);
}

TEST(TexturePlan, IsOneTexelWithoutTextures) {
    test::SnapshotBuilder scene;
    scene.addMaterial(test::mattMaterial());
    EXPECT_EQ(planTextures(scene.snapshot, 2048)->size, 1u);
}

TEST(TexturePlan, NamesTheLimitOfLayers) {
    test::SnapshotBuilder scene;
    for (int i = 0; i < 8; ++i) {
        assets::Material material = test::mattMaterial();
        material.baseColourTexture.image = scene.addImage(plain(1, 1, {0, 0, 0, 0}));
        scene.addMaterial(material);
    }
    EXPECT_TRUE(planTextures(scene.snapshot, 9).ok());
    const auto plan = planTextures(scene.snapshot, 8);
    ASSERT_FALSE(plan.ok());
    EXPECT_NE(plan.error().message.find("maxImageArrayLayers"), std::string::npos);
}

TEST(Resampled, KeepsTheBytesOfAnImageOfTheRightSize) {
    assets::TextureImage image = plain(4, 4, {9, 8, 7, 6});
    image.rgba[17] = 200;
    EXPECT_EQ(resampled(image, {.srgb = true}, 4), image.rgba);
}

TEST(Resampled, AveragesColoursInLinearSpaceAndDataAsTheyAre) {
    assets::TextureImage image = plain(2, 2, {0, 0, 0, 255});
    for (size_t i : {0u, 1u, 2u, 12u, 13u, 14u}) image.rgba[i] = 255;  // a diagonal of white
    EXPECT_NEAR(resampled(image, {.srgb = true}, 1)[0], 188, 2);
    EXPECT_NEAR(resampled(image, {.srgb = false}, 1)[0], 128, 2);
}

TEST(Resampled, DoesNotMixAlphaIntoColour) {
    assets::TextureImage image = plain(2, 1, {100, 100, 100, 0});
    for (size_t i = 4; i < 8; ++i) image.rgba[i] = i == 7 ? 255 : 100;
    const auto pixels = resampled(image, {.srgb = true}, 8);
    for (size_t i = 0; i < pixels.size(); i += 4) EXPECT_NEAR(pixels[i], 100, 1);
}

TEST(ImageLookup, FiltersAndWraps) {
    assets::TextureImage image = plain(2, 1, {0, 0, 0, 255});
    image.rgba[4] = 255;  // the right texel is red
    assets::TextureUse use;
    EXPECT_NEAR(lookUpSrgb(image, use, {0.5f, 0.5f}).r, 0.5f, 1e-5f);
    EXPECT_NEAR(lookUpSrgb(image, use, {1.0f, 0.5f}).r, 0.5f, 1e-5f) << "repeats";
    EXPECT_NEAR(lookUpSrgb(image, use, {-0.25f, 9.5f}).r, 1.0f, 1e-5f);
    use.wrapU = assets::Wrap::Clamp;
    EXPECT_NEAR(lookUpSrgb(image, use, {5.0f, 0.5f}).r, 1.0f, 1e-5f);
    EXPECT_NEAR(lookUpSrgb(image, use, {-1e20f, 0.5f}).r, 0.0f, 1e-5f);
    use.wrapU = assets::Wrap::Mirror;
    EXPECT_NEAR(lookUpSrgb(image, use, {1.25f, 0.5f}).r, 1.0f, 1e-5f);
    use.filter = assets::Filter::Nearest;
    EXPECT_NEAR(lookUpSrgb(image, use, {1.9f, 0.5f}).r, 0.0f, 1e-5f);
}

}  // namespace
}  // namespace lampyris::residency
