#include <set>

#include "graph/episodes.h"
#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class Steps : public GraphTest {};

TEST_F(Steps, PoisonComesOnceBeforeTheFirstTouch) {
    const Buffer first = source("a");
    auto node = compute("b");
    node.read(0, first);
    const Image image = node.write(1, frame.image("x", kColour));
    frame.output(compute("c").update(0, image));
    const CompiledGraph graph = compiled({.poisonTransients = true});
    EXPECT_EQ(names(graph), (Texts{"poison", "a", "poison", "b", "c"}));
    EXPECT_EQ(graph.steps[0].poisons, (std::vector{first.resource}));
    EXPECT_EQ(graph.steps[2].poisons, (std::vector{image.resource}));
    EXPECT_TRUE(graph.resources[image.resource].accesses.has(Access::TransferWrite));
    EXPECT_EQ(texts(graph.steps[2].barriers),
              (Texts{"x: nothing -> transfer TransferWrite, Undefined -> TransferTarget, "
                     "discards"}));
    EXPECT_EQ(barriers(graph, "a"),
              (Texts{"a out: transfer TransferWrite -> compute StorageWrite, discards"}));
}

TEST_F(Steps, WhatHasContentsIsNotPoisoned) {
    const HistoryImage past = frame.history("past", kColour, true);
    auto node = compute("a");
    node.read(0, frame.importBuffer("scene", kBytes, {})).sample(1, past.previous);
    (void)node.write(2, past.current);
    EXPECT_EQ(names(compiled({.poisonTransients = true})), (Texts{"a"}));
}

TEST_F(Steps, CopiesOfOneNodeWaitForEachOtherOnlyWhereTheyMeet) {
    const Buffer a = frame.importBuffer("a", kBytes, {});
    const Buffer b = frame.importBuffer("b", kBytes, {});
    auto node = frame.transfer("copies");
    Buffer x = node.fill(frame.buffer("x", kBytes), 0);  // 0
    Buffer y = node.fill(frame.buffer("y", kBytes), 0);  // 1: apart
    x = node.copy(a, 0, x, 0, 512);                      // 2: after the fill
    x = node.copy(b, 0, x, 512, 512);                    // 3: the other half
    y = node.copy(a, 0, y, 0, 4);                        // 4: fill 1 is behind a barrier
    y = node.copy(x, 0, y, 4, 8);                        // 5: reads what 2 wrote
    x = node.copy(b, 0, x, 0, 4);                        // 6: writes what 5 read
    frame.output(x);
    frame.output(y);
    EXPECT_EQ(step(compiled(), "copies").copyBarriers, (std::vector<uint32_t>{2, 5, 6}));
}

TEST_F(Steps, LayersAreApart) {
    const Buffer texels = frame.importBuffer("texels", {8192}, {});
    Image array = frame.image("array", {kColour.format, kColour.extent, 3});
    auto node = frame.transfer("upload");
    for (uint32_t layer = 0; layer < 3; ++layer) {
        array = node.copyToImage(texels, uint64_t{1024} * layer, array, layer);
    }
    array = node.copyToImage(texels, 0, array, 1);
    frame.output(array);
    EXPECT_EQ(step(compiled(), "upload").copyBarriers, (std::vector<uint32_t>{3}));
}

}  // namespace
}  // namespace lampyris::graph
