// lib/scene_material.glsl at hits: albedo, vertex colours, textures and alpha masks.
#include "gpu/accel/trace_fixture.h"

namespace lampyris::test {
namespace {

/// 2 × 1 texels: opaque red, clear blue.
assets::TextureImage redAndClear() {
    return {"red and clear", 2, 1, {255, 0, 0, 255, 0, 0, 255, 0}};
}

assets::Material textured(int32_t image, assets::Wrap wrap = assets::Wrap::Clamp) {
    assets::Material material = mattMaterial();
    material.baseColour = glm::vec4(1.0f);
    material.baseColourTexture = {.image = image,
                                  .texcoordSet = 0,
                                  .wrapU = wrap,
                                  .wrapV = wrap,
                                  .filter = assets::Filter::Nearest};
    return material;
}

/// Straight down on (x, y) of the square.
GpuRay downAt(float x, float y) {
    return ray({x, y, 1.0f}, {0.0f, 0.0f, -1.0f});
}

void expectColour(const GpuHit& hit, const glm::vec3& colour) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(hit.albedo[i], colour[i], 2e-3f);
}

TEST_F(TraceTest, TakesAlbedoFromBaseColourVertexColourAndMetallic) {
    SnapshotBuilder scene;
    assets::Mesh square = unitSquare();
    square.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    assets::Material material = mattMaterial();
    material.baseColour = glm::vec4(0.5f, 1.0f, 1.0f, 1.0f);
    material.metallic = 0.25f;
    scene.addInstance(scene.addMesh(square), scene.addMaterial(material));
    const auto hits = trace(scene.snapshot, {downAt(0.75f, 0.25f), downAt(0.001f, 0.001f)});
    expectColour(hits[0], 0.75f * glm::vec3(0.5f * 0.25f, 0.5f, 0.25f));
    EXPECT_NEAR(hits[1].albedo.r, 0.75f * 0.5f, 2e-3f);
}

TEST_F(TraceTest, TakesMetallicFromBlueOfItsTexture) {
    SnapshotBuilder scene;
    assets::Material material = mattMaterial();
    material.baseColour = glm::vec4(1.0f);
    material.metallic = 1.0f;
    material.metallicRoughnessTexture.image = scene.addImage({"metal", 1, 1, {0, 255, 51, 255}});
    scene.addInstance(scene.addMesh(unitSquare()), scene.addMaterial(material));
    expectColour(trace(scene.snapshot, {downAt(0.5f, 0.3f)})[0], glm::vec3(0.8f));
}

TEST_F(TraceTest, WrapsTextureCoordinates) {
    const auto colourAt = [this](assets::Wrap wrap, float u) {
        SnapshotBuilder scene;
        assets::Mesh square = unitSquare();
        for (glm::vec2& uv : square.texcoords0) uv.x = u;
        const int32_t image =
            scene.addImage({"red and green", 2, 1, {255, 0, 0, 255, 0, 255, 0, 255}});
        scene.addInstance(scene.addMesh(square), scene.addMaterial(textured(image, wrap)));
        return trace(scene.snapshot, {downAt(0.5f, 0.3f)})[0];
    };
    const glm::vec3 red(1, 0, 0), green(0, 1, 0);
    expectColour(colourAt(assets::Wrap::Repeat, 1.25f), red);
    expectColour(colourAt(assets::Wrap::Repeat, -0.25f), green);
    expectColour(colourAt(assets::Wrap::Clamp, 7.25f), green);
    expectColour(colourAt(assets::Wrap::Clamp, -7.25f), red);
    expectColour(colourAt(assets::Wrap::Mirror, 1.25f), green);
    expectColour(colourAt(assets::Wrap::Mirror, -0.25f), red);
    expectColour(colourAt(assets::Wrap::Mirror, 1.75f), red);
}

TEST_F(TraceTest, FiltersInLinearSpaceAndUsesTheSecondSet) {
    SnapshotBuilder scene;
    assets::Mesh square = unitSquare();
    square.texcoords1 = square.texcoords0;
    for (glm::vec2& uv : square.texcoords0) uv = glm::vec2(0.0f);
    const int32_t image =
        scene.addImage({"black and white", 2, 1, {0, 0, 0, 255, 255, 255, 255, 255}});
    assets::Material material = textured(image);
    material.baseColourTexture.filter = assets::Filter::Linear;
    material.baseColourTexture.texcoordSet = 1;
    scene.addInstance(scene.addMesh(square), scene.addMaterial(material));
    expectColour(trace(scene.snapshot, {downAt(0.5f, 0.3f)})[0], glm::vec3(0.5f));
}

TEST_F(TraceTest, PassesThroughWhatAnAlphaMaskCutsOut) {
    SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(unitSquare());
    assets::Material masked = textured(scene.addImage(redAndClear()));
    masked.alphaMode = assets::AlphaMode::Mask;
    scene.addInstance(square, scene.addMaterial(masked));
    const auto alone = trace(scene.snapshot, {downAt(0.2f, 0.5f), downAt(0.8f, 0.5f)});
    EXPECT_EQ(alone[0].instance, 0u);
    EXPECT_EQ(alone[0].occluded, 1u);
    EXPECT_EQ(alone[1].instance, shared::SCENE_NONE);
    EXPECT_EQ(alone[1].occluded, 0u);
    scene.addInstance(square, scene.addMaterial(mattMaterial()),
                      glm::translate(glm::mat4(1), glm::vec3(0, 0, -1)));
    const auto above = trace(scene.snapshot, {downAt(0.2f, 0.5f), downAt(0.8f, 0.5f)});
    EXPECT_EQ(above[0].instance, 0u);
    EXPECT_EQ(above[1].instance, 1u);
    EXPECT_FLOAT_EQ(above[1].tBary.x, 2.0f);
}

TEST_F(TraceTest, FollowsAMaterialThatBecomesMasked) {
    SnapshotBuilder scene;
    assets::Material material = textured(scene.addImage(redAndClear()));
    const uint32_t index = scene.addMaterial(material);
    scene.addInstance(scene.addMesh(unitSquare()), index);
    residency::SceneOnGpu onGpu(device());
    accel::AccelOnGpu accel(onGpu);
    EXPECT_EQ(traceIn(onGpu, accel, scene.snapshot, {downAt(0.8f, 0.5f)})[0].instance, 0u);
    material.alphaMode = assets::AlphaMode::Mask;
    scene.replaceMaterial(index, material);
    EXPECT_EQ(traceIn(onGpu, accel, scene.snapshot, {downAt(0.8f, 0.5f)})[0].instance,
              shared::SCENE_NONE);
}

}  // namespace
}  // namespace lampyris::test
