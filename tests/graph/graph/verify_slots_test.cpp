#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

/// Slots as reflection would give them, against nodes that say otherwise.
class VerifySlots : public testing::Test {
 protected:
    void expect(const std::string& message) {
        const auto result = compile(frame);
        EXPECT_EQ(result.ok() ? "" : result.error().message, message);
    }
    void shaderHas(std::vector<ShaderSlot> found) {
        slots = std::move(found);
        shader.slots = slots;
    }
    static ShaderSlot reading(uint32_t slot) { return {.name = "photons", .slot = slot}; }
    static ShaderSlot writing(uint32_t slot) {
        return {.name = "ranges", .slot = slot, .writes = true};
    }

    Frame frame;
    Shader shader{.name = "bin.comp"};
    std::vector<ShaderSlot> slots;
    Buffer input = frame.importBuffer("input", kBytes, {});
    Buffer target = frame.buffer("target", kBytes);
};

TEST_F(VerifySlots, Agreement) {
    shaderHas({reading(0), writing(1)});
    auto node = frame.compute("bin", shader);
    node.read(0, input);
    (void)node.write(1, target);
    expect("");
}

TEST_F(VerifySlots, AWriteDeclaredAsRead) {
    shaderHas({writing(0)});
    frame.compute("bin", shader).read(0, input);
    expect(
        "render graph: node 'bin' declares 'input' in slot 0 as read, but shader bin.comp writes "
        "it (ranges): a write nobody declared");
}

TEST_F(VerifySlots, AWriteNotDeclaredAtAll) {
    shaderHas({reading(0), writing(1)});
    frame.compute("bin", shader).read(0, input);
    expect(
        "render graph: node 'bin' never declares slot 1 (ranges) of shader bin.comp: a write "
        "nobody declared");
}

TEST_F(VerifySlots, AReadNotDeclared) {
    shaderHas({reading(0), writing(1)});
    (void)frame.compute("bin", shader).write(1, target);
    expect("render graph: node 'bin' never declares slot 0 (photons) of shader bin.comp");
}

TEST_F(VerifySlots, AWriteThatTheShaderNeverMakes) {
    shaderHas({reading(0)});
    (void)frame.compute("bin", shader).write(0, target);
    expect(
        "render graph: node 'bin' declares 'target' in slot 0 as written, but shader bin.comp only "
        "reads it (photons)");
}

TEST_F(VerifySlots, ASlotThatTheShaderLacks) {
    frame.compute("bin", shader).read(3, input);
    expect("render graph: node 'bin' declares 'input' in slot 3, which no shader of it has");
}

TEST_F(VerifySlots, AnotherKind) {
    shaderHas({reading(0)});
    frame.compute("bin", shader).texels(0, input, Format::RGBA32Float);
    expect(
        "render graph: node 'bin' declares 'input' in slot 0 as a uniform texel buffer, but shader "
        "bin.comp has a storage buffer there (photons)");
}

TEST_F(VerifySlots, EveryKindIsToldApart) {
    const Image image = frame.importImage("image", kColour, {}, Access::Sampled);
    shaderHas({{.slot = 0, .kind = SlotKind::UniformBuffer},
               {.slot = 1, .kind = SlotKind::UniformTexelBuffer},
               {.slot = 2, .kind = SlotKind::StorageTexelBuffer, .writes = true},
               {.slot = 3, .kind = SlotKind::SampledImage},
               {.slot = 4, .kind = SlotKind::StorageImage, .writes = true},
               {.slot = 5, .kind = SlotKind::UniformBuffer}});
    auto node = frame.compute("all", shader);
    node.uniform(0, input).texels(1, input, Format::RGBA32Float);
    (void)node.writeTexels(2, target, Format::R32Uint);
    node.sample(3, image);
    (void)node.write(4, frame.image("out", kColour));
    node.uniformData(5, 1.0f);
    expect("");
}

TEST_F(VerifySlots, ASlotTwice) {
    shaderHas({reading(0)});
    frame.compute("bin", shader).read(0, input).read(0, input);
    expect("render graph: node 'bin' declares slot 0 twice, the second time for 'input'");
}

TEST_F(VerifySlots, ASlotOnceAsResourceAndOnceAsData) {
    shaderHas({{.slot = 0, .kind = SlotKind::UniformBuffer}});
    frame.compute("bin", shader).uniform(0, input).uniformData(0, 1.0f);
    expect("render graph: node 'bin' declares slot 0 twice, the second time for 'uniform data'");
}

TEST_F(VerifySlots, AnAttachmentTwice) {
    auto node = frame.raster("draw", kColour.extent);
    (void)node.clearedColour(0, frame.image("a", kColour));
    (void)node.clearedColour(0, frame.image("b", kColour));
    expect("render graph: node 'draw' declares slot 0 twice, the second time for 'b'");
}

TEST_F(VerifySlots, TwoDepthAttachments) {
    auto node = frame.raster("draw", kColour.extent);
    (void)node.clearedDepth(frame.image("a", kDepth));
    (void)node.clearedDepth(frame.image("b", kDepth));
    expect("render graph: node 'draw' has a second depth attachment, 'b'");
}

TEST_F(VerifySlots, ARasterShaderMayNotWriteABuffer) {
    shaderHas({writing(0)});
    auto node = frame.raster("draw", kColour.extent);
    node.read(0, input).record({&shader}, {});
    expect(
        "render graph: node 'draw' declares 'input' in slot 0 as read, but shader bin.comp writes "
        "it (ranges): a write nobody declared");
}

TEST_F(VerifySlots, BothRasterShadersCount) {
    shaderHas({reading(0)});
    const std::array more{ShaderSlot{.name = "albedo", .slot = 1, .kind = SlotKind::SampledImage}};
    const Shader fragment{.name = "draw.frag", .slots = more};
    auto node = frame.raster("draw", kColour.extent);
    node.read(0, input).record({&shader, &fragment}, {});
    expect("render graph: node 'draw' never declares slot 1 (albedo) of shader draw.frag");
}

TEST_F(VerifySlots, RasterShadersThatDisagree) {
    shaderHas({reading(0)});
    const std::array more{ShaderSlot{.name = "albedo", .kind = SlotKind::SampledImage}};
    const Shader fragment{.name = "draw.frag", .slots = more};
    auto node = frame.raster("draw", kColour.extent);
    node.read(0, input).record({&shader, &fragment}, {});
    expect(
        "render graph: node 'draw': slot 0 is a storage buffer in shader bin.comp and a sampled "
        "image in draw.frag");
}

TEST_F(VerifySlots, PushConstants) {
    shader.pushConstantBytes = 8;
    frame.compute("bin", shader).push(1.0f);
    expect("render graph: node 'bin' pushes 4 bytes, but shader bin.comp takes 8");
}

TEST_F(VerifySlots, CulledNodesAreCheckedToo) {
    shaderHas({reading(0)});
    frame.compute("never runs", shader);
    expect("render graph: node 'never runs' never declares slot 0 (photons) of shader bin.comp");
}

}  // namespace
}  // namespace lampyris::graph
