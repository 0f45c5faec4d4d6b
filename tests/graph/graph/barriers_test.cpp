#include "graph/barriers.h"

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class Barriers : public GraphTest {};

TEST_F(Barriers, AFirstWriteOfABufferNeedsNone) {
    frame.output(source("a"));
    EXPECT_EQ(barriers(compiled(), "a"), Texts{});
}

TEST_F(Barriers, WriteThenRead) {
    const Buffer buffer = source("a");
    compute("b").read(0, buffer).keep();
    EXPECT_EQ(barriers(compiled(), "b"),
              (Texts{"a out: compute StorageWrite -> compute StorageRead"}));
}

// Synchronization validation on the test machine misses this one and the next: they are proved
// here.
TEST_F(Barriers, UpdateAfterUpdateOfABuffer) {
    const Buffer first = source("a");
    const Buffer second = compute("b").update(0, first);
    frame.output(compute("c").update(0, second));
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "b"),
              (Texts{"a out: compute StorageWrite -> compute StorageUpdate"}));
    EXPECT_EQ(barriers(graph, "c"),
              (Texts{"a out: compute StorageUpdate -> compute StorageUpdate"}));
}

TEST_F(Barriers, WriteAfterWriteOfAStorageImage) {
    const Image first = compute("a").write(0, frame.image("x", kColour));
    frame.output(compute("b").update(0, first));
    EXPECT_EQ(barriers(compiled(), "b"),
              (Texts{"x: compute StorageWrite -> compute StorageUpdate, General -> General"}));
}

TEST_F(Barriers, ReadThenWrite) {
    const Buffer buffer = source("a");
    compute("b").read(0, buffer).keep();
    frame.output(compute("c").write(0, buffer));
    EXPECT_EQ(barriers(compiled(), "c"),
              (Texts{"a out: compute StorageRead -> compute StorageWrite, discards"}));
}

TEST_F(Barriers, ManyReadsShareOne) {
    const Buffer buffer = source("a");
    compute("b").read(0, buffer).keep();
    auto draw = frame.raster("c", kColour.extent);
    draw.vertices(buffer);
    draw.keep();
    finish(draw);
    auto indirect = compute("d");
    indirect.dispatchIndirect(buffer);
    indirect.keep();
    auto rewrite = compute("e");
    frame.output(rewrite.update(0, buffer));
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "b"),
              (Texts{"a out: compute StorageWrite -> compute StorageRead + compute IndirectRead + "
                     "raster VertexRead"}));
    EXPECT_EQ(barriers(graph, "c"), Texts{});
    EXPECT_EQ(barriers(graph, "d"), Texts{});
    EXPECT_EQ(barriers(graph, "e"),
              (Texts{"a out: compute StorageRead + compute IndirectRead + raster VertexRead -> "
                     "compute StorageUpdate"}));
}

TEST_F(Barriers, LayoutsFollowTheReads) {
    const Image image = compute("write").write(0, frame.image("x", kColour));
    compute("sample").sample(0, image).keep();
    auto draw = frame.raster("draw", kColour.extent);
    draw.sample(0, image).keep();
    finish(draw);
    compute("load").read(0, image).keep();
    compute("sample again").sample(0, image).keep();
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "write"),
              (Texts{"x: nothing -> compute StorageWrite, Undefined -> General, discards"}));
    EXPECT_EQ(barriers(graph, "sample"),
              (Texts{"x: compute StorageWrite -> compute Sampled + raster Sampled, General -> "
                     "ReadOnly"}));
    EXPECT_EQ(barriers(graph, "draw"), Texts{});
    EXPECT_EQ(barriers(graph, "load"),
              (Texts{"x: compute Sampled + raster Sampled -> compute StorageRead, ReadOnly -> "
                     "General"}));
    EXPECT_EQ(barriers(graph, "sample again"),
              (Texts{"x: compute StorageRead -> compute Sampled, General -> ReadOnly"}));
}

TEST_F(Barriers, TestedAndSampledDepthSharesALayout) {
    auto prepass = frame.raster("prepass", kDepth.extent);
    const Image depth = prepass.clearedDepth(frame.image("depth", kDepth));
    finish(prepass);
    auto draw = frame.raster("draw", kDepth.extent);
    draw.testDepth(depth).keep();
    finish(draw);
    compute("bounds").sample(0, depth).keep();
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "draw"),
              (Texts{"depth: raster DepthWrite -> compute Sampled + raster DepthRead, "
                     "DepthAttachment -> DepthReadOnly"}));
    EXPECT_EQ(barriers(graph, "bounds"), Texts{});
}

TEST_F(Barriers, AClearedAttachmentDiscardsAndALoadedOneDoesNot) {
    auto first = frame.raster("first", kColour.extent);
    const Image drawn = first.clearedColour(0, frame.image("x", kColour));
    finish(first);
    auto over = frame.raster("over", kColour.extent);
    const Image more = over.colour(0, drawn);
    finish(over);
    compute("read").sample(0, more).keep();
    auto again = frame.raster("again", kColour.extent);
    frame.output(again.clearedColour(0, more));
    finish(again);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "over"),
              (Texts{"x: raster ColorWrite -> raster ColorWrite, ColorAttachment -> "
                     "ColorAttachment"}));
    EXPECT_EQ(barriers(graph, "again"),
              (Texts{"x: compute Sampled -> raster ColorWrite, Undefined -> ColorAttachment, "
                     "discards"}));
}

TEST_F(Barriers, OneNodeThatReadsAndRewritesWaitsOnceForAll) {
    const Buffer nodes = source("build");
    auto refit = compute("refit");
    const Buffer refitted = refit.update(0, nodes);
    refit.texels(1, nodes, Format::RGBA32Float);
    frame.output(refitted);
    EXPECT_EQ(barriers(compiled(), "refit"),
              (Texts{"build out: compute StorageWrite -> compute TexelRead + compute "
                     "StorageUpdate"}));
}

TEST_F(Barriers, OutputsAreLeftReadyToBeCopied) {
    const Image image = compute("a").write(0, frame.image("x", kColour));
    frame.output(image);
    frame.output(source("b"));
    const CompiledGraph graph = compiled();
    EXPECT_EQ(texts(graph.finalBarriers),
              (Texts{"x: compute StorageWrite -> transfer TransferRead, General -> TransferSource",
                     "b out: compute StorageWrite -> transfer TransferRead"}));
    EXPECT_EQ(graph.resources[image.resource].endLayout, Layout::TransferSource);
    EXPECT_EQ(graph.resources[image.resource].lastStep, graph.steps.size());
}

TEST_F(Barriers, AReadThatComesAfterTheFrameIsMergedToo) {
    const Buffer buffer = source("a");
    compute("b").read(0, buffer).keep();
    frame.output(buffer);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "b"),
              (Texts{"a out: compute StorageWrite -> compute StorageRead + transfer "
                     "TransferRead"}));
    EXPECT_EQ(texts(graph.finalBarriers), Texts{});
}

TEST_F(Barriers, ImportedImagesStartAndEndAsTheyWereImported) {
    const Image screen = frame.importImage("screen", kColour, {}, Access::Present);
    const Image final = compute("draw").write(0, frame.image("final", kColour));
    (void)frame.transfer("show").blit(final, screen);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "show"),
              (Texts{"screen: nothing -> transfer TransferWrite, Undefined -> TransferTarget, "
                     "discards",
                     "final: compute StorageWrite -> transfer TransferRead, General -> "
                     "TransferSource"}));
    EXPECT_EQ(texts(graph.finalBarriers),
              (Texts{"screen: transfer TransferWrite -> host Present, TransferTarget -> Present"}));
}

TEST_F(Barriers, ImportedThingsThatAreReadAsBeforeNeedNone) {
    auto node = compute("shade");
    node.sample(0, frame.importImage("texture", kColour, {}, Access::Sampled));
    node.read(1, frame.importBuffer("scene", kBytes, {}, Access::StorageRead));
    node.read(2, frame.importBuffer("unknown", kBytes, {}));
    node.keep();
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "shade"), Texts{});
    EXPECT_EQ(texts(graph.finalBarriers), Texts{});
}

TEST_F(Barriers, WhatTheHostReadsIsMadeVisibleToIt) {
    const Buffer counters = frame.importBuffer("counters", kBytes, {}, Access::HostRead);
    (void)compute("count").write(0, counters);
    EXPECT_EQ(texts(compiled().finalBarriers),
              (Texts{"counters: compute StorageWrite -> host HostRead"}));
}

TEST_F(Barriers, HistoryRestsSampled) {
    const HistoryImage past = frame.history("past", kColour, true);
    auto node = compute("blend");
    node.read(0, past.previous);
    (void)node.write(1, past.current);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "blend"),
              (Texts{"past: nothing -> compute StorageRead, ReadOnly -> General",
                     "past: nothing -> compute StorageWrite, Undefined -> General, discards"}));
    EXPECT_EQ(texts(graph.finalBarriers),
              (Texts{"past: compute StorageRead -> compute Sampled + raster Sampled, General -> "
                     "ReadOnly",
                     "past: compute StorageWrite -> compute Sampled + raster Sampled, General -> "
                     "ReadOnly"}));
    ASSERT_EQ(graph.history.size(), 1u);
    EXPECT_TRUE(graph.history[0].currentWritten);
    EXPECT_EQ(graph.resources[past.previous.resource].accesses,
              graph.resources[past.current.resource].accesses);
    EXPECT_EQ(graph.resources[past.current.resource].heap, kNoHeap);
}

TEST_F(Barriers, HistoryThatIsOnlyReadStaysInPlace) {
    const HistoryImage past = frame.history("past", kColour, true);
    compute("show").sample(0, past.previous).keep();
    const CompiledGraph graph = compiled();
    EXPECT_EQ(barriers(graph, "show"), Texts{});
    EXPECT_FALSE(graph.history.at(0).currentWritten);
}

TEST_F(Barriers, MemoryHandedOnWaitsForEveryEarlierUser) {
    // Two small things lie in what the big one then takes.
    const Buffer a = compute("a").write(0, frame.buffer("small a", {512}));
    compute("read a").read(0, a).keep();
    const Image b = compute("b").write(0, frame.image("small b", {Format::R32Float, {16, 8}}));
    compute("read b").sample(0, b).keep();
    const Buffer big = compute("big").write(0, frame.buffer("big", {1024}));
    compute("read big").uniform(0, big).keep();
    const CompiledGraph graph = compiled();
    EXPECT_EQ(graph.transientBytes, 1024u);
    EXPECT_EQ(graph.transientBytesWithoutAliasing, 2048u);
    const MemoryBarrier& handover = step(graph, "big").handover;
    ASSERT_EQ(handover.handovers.size(), 2u);
    EXPECT_EQ(handover.handovers[0].from, a.resource);
    EXPECT_EQ(handover.handovers[1].from, b.resource);
    EXPECT_EQ(describe(handover.source), "compute StorageRead + compute Sampled");
    EXPECT_EQ(describe(handover.destination), "compute StorageWrite");
}

}  // namespace
}  // namespace lampyris::graph
