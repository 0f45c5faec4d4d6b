#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class VerifyHandles : public GraphTest {};

TEST_F(VerifyHandles, AReadBeforeAnyWrite) {
    compute("gather").read(0, frame.buffer("tiles", kBytes));
    EXPECT_EQ(failure(), "render graph: node 'gather' reads 'tiles' before any node writes it");
}

TEST_F(VerifyHandles, AnUpdateOrALoadBeforeAnyWrite) {
    (void)compute("count").update(0, frame.buffer("counter", kBytes));
    EXPECT_EQ(
        failure(),
        "render graph: node 'count' keeps what stands in 'counter' before any node writes it");
}

TEST_F(VerifyHandles, ALoadedAttachmentBeforeAnyWrite) {
    auto node = frame.raster("overlay", kColour.extent);
    frame.output(node.colour(0, frame.image("final", kColour)));
    finish(node);
    EXPECT_EQ(
        failure(),
        "render graph: node 'overlay' keeps what stands in 'final' before any node writes it");
}

TEST_F(VerifyHandles, AnOutputThatNobodyWrites) {
    frame.output(frame.image("final", kColour));
    EXPECT_EQ(failure(), "render graph: output 'final' is read before any node writes it");
}

TEST_F(VerifyHandles, ImportedAndPreviousHaveContents) {
    const HistoryImage past = frame.history("past", kColour, false);
    EXPECT_TRUE(past.firstFrame);
    auto node = compute("blend");
    node.read(0, frame.importBuffer("scene", kBytes, {}));
    node.sample(1, past.previous);
    node.sample(2, frame.importImage("texture", kColour, {}, Access::Sampled));
    node.keep();
    EXPECT_EQ(failure(), "");
}

TEST_F(VerifyHandles, CurrentHistoryHasNone) {
    compute("blend").sample(0, frame.history("past", kColour, true).current);
    EXPECT_EQ(failure(), "render graph: node 'blend' reads 'past' before any node writes it");
}

TEST_F(VerifyHandles, PreviousHistoryIsNotWritten) {
    (void)compute("blend").write(0, frame.history("past", kColour, true).previous);
    EXPECT_EQ(failure(), "render graph: node 'blend' writes the previous image of history 'past'");
}

TEST_F(VerifyHandles, AHistoryDeclaredTwice) {
    (void)frame.history("past", kColour, true);
    (void)frame.history("past", kColour, true);
    EXPECT_EQ(failure(), "render graph: history image 'past' is declared twice");
}

TEST_F(VerifyHandles, AnImportedImageOfUnknownLayoutIsNotRead) {
    compute("shade").sample(0, frame.importImage("texture", kColour, {}));
    EXPECT_NE(failure().find("node 'shade' reads image 'texture', which was imported as None"),
              std::string::npos);
}

TEST_F(VerifyHandles, AStaleRead) {
    const Buffer first = source("a");
    (void)compute("b").write(0, first);
    compute("c").read(0, first);
    EXPECT_EQ(
        failure(),
        "render graph: node 'c' reads 'a out' through a stale handle: node 'b' had rewritten it");
}

TEST_F(VerifyHandles, TwoWritersOfOneVersion) {
    const Buffer first = source("a");
    (void)compute("b").update(0, first);
    (void)compute("c").update(0, first);
    EXPECT_EQ(
        failure(),
        "render graph: node 'c' writes 'a out' through a stale handle: node 'b' had rewritten it");
}

TEST_F(VerifyHandles, AStaleCopySourceWithinOneNode) {
    const Buffer first = source("a");
    const Buffer other = frame.buffer("b", kBytes);
    auto node = frame.transfer("move");
    (void)node.fill(first, 0);
    (void)node.copy(first, 0, other, 0, kBytes.bytes);
    EXPECT_EQ(failure(),
              "render graph: node 'move' reads 'a out' through a stale handle: node 'move' had "
              "rewritten it");
}

TEST_F(VerifyHandles, AShaderDoesNotReadItsOwnResult) {
    auto node = compute("scan");
    const Buffer sums = node.write(0, frame.buffer("sums", kBytes));
    node.read(1, sums);
    EXPECT_EQ(failure(), "render graph: node 'scan' reads its own result 'sums'");
}

TEST_F(VerifyHandles, AShaderMayReadInOneSlotWhatItRewritesInAnother) {
    const Buffer nodes = source("build");
    auto refit = compute("refit");
    const Buffer refitted = refit.update(0, nodes);
    refit.texels(1, nodes, Format::RGBA32Float);
    frame.output(refitted);
    EXPECT_EQ(names(compiled()), (Texts{"build", "refit"}));
}

TEST_F(VerifyHandles, AHandleFromNowhere) {
    compute("lost").read(4, Buffer{});
    EXPECT_EQ(failure(),
              "render graph: node 'lost' uses (StorageRead) a handle that is not of this frame");
}

TEST_F(VerifyHandles, AVersionThatNobodyMakes) {
    const Buffer buffer = source("a");
    compute("b").read(0, Buffer{buffer.resource, 7});
    EXPECT_EQ(failure(), "render graph: node 'b' reads 'a out' before any node writes it");
}

TEST_F(VerifyHandles, ABufferIsNoImage) {
    const Buffer buffer = source("a");
    compute("b").sample(0, Image{buffer.resource, 1});
    EXPECT_EQ(failure(), "render graph: node 'b' uses 'a out' as an image, which it is not");
}

TEST_F(VerifyHandles, NoLayoutServesSampledAndWritten) {
    const Image image = compute("a").write(0, frame.image("x", kColour));
    auto node = compute("blur");
    node.sample(0, image);
    (void)node.update(1, image);
    EXPECT_NE(failure().find("node 'blur' uses image 'x' in two ways"), std::string::npos);
}

TEST_F(VerifyHandles, DepthMayBeTestedAndSampledAtOnce) {
    auto prepass = frame.raster("prepass", kDepth.extent);
    const Image depth = prepass.clearedDepth(frame.image("depth", kDepth));
    finish(prepass);
    auto node = frame.raster("decals", kDepth.extent);
    node.testDepth(depth).sample(0, depth);
    node.keep();
    finish(node);
    EXPECT_EQ(failure(), "");
}

TEST_F(VerifyHandles, CopiesThatTogetherCoverTheirTargetNeedNoFillBefore) {
    const Buffer half = frame.importBuffer("half", {512}, {});
    auto node = frame.transfer("join");
    const Buffer first = node.copy(half, 0, frame.buffer("whole", kBytes), 512, 512);
    frame.output(node.copy(half, 0, first, 0, 512));
    EXPECT_EQ(failure(), "");
}

TEST_F(VerifyHandles, CopiesThatLeaveAGapDo) {
    const Buffer half = frame.importBuffer("half", {512}, {});
    auto node = frame.transfer("join");
    const Buffer first = node.copy(half, 0, frame.buffer("whole", kBytes), 513, 511);
    frame.output(node.copy(half, 0, first, 0, 512));
    EXPECT_EQ(failure(),
              "render graph: node 'join' keeps what stands in 'whole' before any node writes it");
}

TEST_F(VerifyHandles, LayersThatTogetherCoverAnArray) {
    const Buffer texels = frame.importBuffer("texels", {16 * 8 * 8}, {});
    const Image array = frame.image("array", {Format::RGBA16Float, {16, 8}, 2});
    auto node = frame.transfer("upload");
    node.keep();
    const Image first = node.copyToImage(texels, 0, array, 0);
    EXPECT_EQ(failure(),
              "render graph: node 'upload' keeps what stands in 'array' before any node writes it");
    (void)node.copyToImage(texels, 0, first, 1);
    EXPECT_EQ(failure(), "");
}

}  // namespace
}  // namespace lampyris::graph
