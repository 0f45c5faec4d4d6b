#include "graph/cull.h"

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class Cull : public GraphTest {
 protected:
    Texts reasons(const CompiledGraph& graph) const {
        Texts list;
        for (const CulledNode& culled : graph.culled) {
            list.push_back(frame.nodes()[culled.node].name + ": " + culled.reason);
        }
        return list;
    }
};

TEST_F(Cull, DropsWhatNobodyUsesAndSaysWhy) {
    frame.output(source("used"));
    const Buffer unread = source("unused");
    auto chain = compute("chain");
    chain.read(0, unread);
    (void)chain.write(1, frame.buffer("y", kBytes));
    compute("idle").read(0, unread);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(names(graph), (Texts{"used"}));
    EXPECT_EQ(reasons(graph),
              (Texts{"unused: What it writes ('unused out') is read only by nodes that are culled "
                     "too: 'chain', 'idle'.",
                     "chain: Nobody reads what it writes: 'y'.",
                     "idle: It writes nothing and is not kept."}));
    EXPECT_EQ(graph.resources[unread.resource].heap, kNoHeap);
}

TEST_F(Cull, KeepsWhatIsKeptAndAllItNeeds) {
    const Buffer needed = source("needed");
    auto node = compute("kept");
    node.read(0, needed);
    node.keep();
    EXPECT_EQ(names(compiled()), (Texts{"needed", "kept"}));
}

TEST_F(Cull, AWriteThatIsLostBeforeAnyoneReadsItIsDropped) {
    const Buffer lost = source("lost");
    frame.output(compute("final").write(0, lost));
    EXPECT_EQ(names(compiled()), (Texts{"final"}));
}

TEST_F(Cull, AnUpdateNeedsWhatItUpdates) {
    const Buffer first = source("first");
    frame.output(compute("second").update(0, first));
    EXPECT_EQ(names(compiled()), (Texts{"first", "second"}));
}

TEST_F(Cull, AClearedAttachmentNeedsNothingAndALoadedOneDoes) {
    const Image image = frame.image("x", kColour);
    auto drawn = frame.raster("drawn", kColour.extent);
    const Image first = drawn.clearedColour(0, image);
    finish(drawn);
    auto over = frame.raster("over", kColour.extent);
    const Image second = over.colour(0, first);
    finish(over);
    frame.output(second);
    EXPECT_EQ(names(compiled()), (Texts{"drawn", "over"}));
}

TEST_F(Cull, WritesToWhatOutlivesTheFrameStay) {
    const Buffer imported = frame.importBuffer("store", kBytes, {}, Access::StorageRead);
    (void)compute("fills store").write(0, imported);
    const HistoryImage past = frame.history("past", kColour, true);
    (void)compute("makes history").write(0, past.current);
    EXPECT_EQ(names(compiled()), (Texts{"fills store", "makes history"}));
}

TEST_F(Cull, PublishingKeepsNothingAliveButExtraOutputsDo) {
    const Image image = compute("normals").write(0, frame.image("normal", kColour));
    frame.publish("normal", image);
    EXPECT_TRUE(names(compiled()).empty());
    EXPECT_EQ(names(compiled({.extraOutputs = {frame.published("normal")}})), (Texts{"normals"}));
}

TEST_F(Cull, AnOutputThatIsRewrittenIsAnError) {
    const Image early = compute("draw").write(0, frame.image("hdr", kColour));
    frame.output(compute("tint").update(0, early));
    EXPECT_EQ(failure({.extraOutputs = {early}}),
              "render graph: output 'hdr' is a stale handle: node 'tint' rewrites it");
}

TEST_F(Cull, AnOutputMayBeRewrittenByNodesThatAreCulled) {
    const Image early = compute("draw").write(0, frame.image("hdr", kColour));
    (void)compute("tint").update(0, early);
    EXPECT_EQ(names(compiled({.extraOutputs = {early}})), (Texts{"draw"}));
}

}  // namespace
}  // namespace lampyris::graph
