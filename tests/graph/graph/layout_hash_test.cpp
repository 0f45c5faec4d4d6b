#include "graph/layout_hash.h"

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

/// A frame of two images, one sampled by the other's node.
uint64_t hashOf(const std::string& name, const ImageDesc& desc, bool sampled, const void* external,
                bool oneMore = false) {
    Frame frame;
    tests::MatchingShaders shaders;
    if (oneMore) static_cast<void>(frame.importBuffer("one more", kBytes, {external}));
    const Buffer scene = frame.importBuffer("scene", kBytes, {external});
    const Image first = frame.compute("a", shaders.next()).write(0, frame.image(name, desc));
    auto node = frame.compute("b", shaders.next());
    node.read(0, scene);
    sampled ? node.sample(1, first) : node.read(1, first);
    frame.output(node.write(2, frame.image("second", kColour)));
    shaders.match(frame);
    const auto graph = compile(frame);
    EXPECT_TRUE(graph.ok());
    return graph->layoutHash;
}

TEST(LayoutHash, EqualFramesKeepTheirMemory) {
    EXPECT_EQ(hashOf("x", kColour, true, nullptr), hashOf("x", kColour, true, nullptr));
}

TEST(LayoutHash, WhatIsImportedDoesNotMatter) {
    const int other = 0;
    EXPECT_EQ(hashOf("x", kColour, true, nullptr), hashOf("x", kColour, true, &other));
    EXPECT_EQ(hashOf("x", kColour, true, nullptr), hashOf("x", kColour, true, nullptr, true));
}

TEST(LayoutHash, SizesFormatsAccessesAndNamesDo) {
    const uint64_t hash = hashOf("x", kColour, true, nullptr);
    EXPECT_NE(hash, hashOf("y", kColour, true, nullptr));
    EXPECT_NE(hash, hashOf("x", {kColour.format, {8, 16}}, true, nullptr));
    EXPECT_NE(hash, hashOf("x", {Format::RG32Float, kColour.extent}, true, nullptr));
    EXPECT_NE(hash, hashOf("x", kColour, false, nullptr));
}

}  // namespace
}  // namespace lampyris::graph
