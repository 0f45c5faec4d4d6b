#include "graph/frame.h"

#include <bit>

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class FrameTest : public GraphTest {};

TEST_F(FrameTest, AWriteGivesASuccessorAndAReadDoesNot) {
    const Buffer buffer = frame.buffer("x", kBytes);
    auto node = compute("a");
    const Buffer next = node.write(0, buffer);
    EXPECT_EQ(next.resource, buffer.resource);
    EXPECT_EQ(next.version, buffer.version + 1);
    EXPECT_EQ(compute("b").update(0, next).version, 2u);
    EXPECT_EQ(frame.resources()[buffer.resource].versions, 3u);
    EXPECT_EQ(frame.desc(next), kBytes);
}

TEST_F(FrameTest, ANodeRemembersWhatWasDeclared) {
    Shader& shader = shaders.next();
    shader.workgroupSize = {8, 4, 1};
    auto node = frame.compute("a", shader);
    struct Push {
        uint32_t a, b;
    };
    node.push(Push{1, 2}).specialise(3, 4).uniformData(5, uint64_t{6});
    node.dispatchOver({17, 8});
    const Node& declared = frame.nodes().at(0);
    EXPECT_EQ(declared.push, (std::vector<uint8_t>{1, 0, 0, 0, 2, 0, 0, 0}));
    EXPECT_EQ(declared.specialisations.at(0).id, 3u);
    EXPECT_EQ(declared.specialisations.at(0).value, 4u);
    EXPECT_EQ(declared.uniforms.at(0).slot, 5u);
    EXPECT_EQ(declared.uniforms.at(0).bytes.size(), 8u);
    EXPECT_EQ(declared.groups, (std::array<uint32_t, 3>{3, 2, 1}));
}

TEST_F(FrameTest, ANodeMayBeDeclaredWhileOthersAreAdded) {
    auto first = compute("first");
    for (int i = 0; i < 100; ++i) (void)compute("other");
    first.keep();
    EXPECT_TRUE(frame.nodes().front().keep);
}

TEST_F(FrameTest, ClearsOfUintImagesKeepTheirBits) {
    auto node = frame.raster("ids", kColour.extent);
    (void)node.clearedColourUint(2, frame.image("id", {Format::R32Uint, kColour.extent}),
                                 0xffffffffu);
    const Use& use = frame.nodes().at(0).uses.at(0);
    EXPECT_TRUE(use.clears && use.clearsAsUint);
    EXPECT_EQ(use.slot, 2u);
    EXPECT_EQ(std::bit_cast<uint32_t>(use.clearColour[0]), 0xffffffffu);
}

TEST_F(FrameTest, PublishedImagesAreFoundByName) {
    const Image a = frame.image("a", kColour);
    const Image b = frame.image("b", kColour);
    frame.publish("normal", a);
    frame.publish("depth", b);
    EXPECT_EQ(frame.published("normal"), a);
    EXPECT_FALSE(frame.published("albedo").valid());
    frame.publish("normal", b);
    EXPECT_EQ(frame.published("normal"), b);
    EXPECT_EQ(frame.publishedNames(), (Texts{"depth", "normal"}));
}

TEST_F(FrameTest, ACopyIsPartialUnlessItCoversItsTarget) {
    const Buffer source = frame.importBuffer("source", {2048}, {});
    const Buffer target = frame.buffer("target", kBytes);
    auto node = frame.transfer("copies");
    (void)node.copy(source, 0, target, 0, 1024);
    (void)node.copy(source, 0, target, 0, 1023);
    (void)node.copy(source, 0, target, 1, 1023);
    const auto& uses = frame.nodes().at(0).uses;
    EXPECT_FALSE(uses.at(1).partial);
    EXPECT_TRUE(uses.at(3).partial);
    EXPECT_TRUE(uses.at(5).partial);
}

}  // namespace
}  // namespace lampyris::graph
