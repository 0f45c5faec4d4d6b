#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class VerifySizes : public GraphTest {
 protected:
    void expectError(const std::string& part) {
        const std::string message = failure();
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    Buffer input = frame.importBuffer("input", {100}, {});
};

TEST_F(VerifySizes, AnEmptyBuffer) {
    (void)compute("a").write(0, frame.buffer("x", {}));
    expectError("node 'a' uses 'x', a buffer of size zero");
}

TEST_F(VerifySizes, AnEmptyImage) {
    (void)compute("a").write(0, frame.image("x", {Format::R32Float, {4, 0}}));
    expectError("node 'a' uses 'x', an image of size zero");
}

TEST_F(VerifySizes, AnImageWithoutFormat) {
    (void)compute("a").write(0, frame.image("x", {Format::Undefined, {4, 4}}));
    expectError("node 'a' uses 'x', an image of size zero or without a format");
}

TEST_F(VerifySizes, EmptyThingsThatNoNodeUsesDoNoHarm) {
    (void)frame.buffer("x", {});
    EXPECT_EQ(failure(), "");
}

TEST_F(VerifySizes, ARangeOutsideItsBuffer) {
    compute("a").readRange(0, input, 64, 37);
    expectError("node 'a' uses bytes 64 to 101 of buffer 'input', which has 100");
}

TEST_F(VerifySizes, ARangeThatWrapsRoundIsOutsideToo) {
    compute("a").readRange(0, input, 64, ~uint64_t{0});
    expectError("of buffer 'input', which has 100");
}

TEST_F(VerifySizes, ARangeUpToTheEndFits) {
    compute("a").readRange(0, input, 64, 36);
    EXPECT_EQ(failure(), "");
}

TEST_F(VerifySizes, IndirectGroupsNeedTwelveBytes) {
    compute("a").dispatchIndirect(input, 92);
    expectError("node 'a' uses bytes 92 to 104 of buffer 'input'");
}

TEST_F(VerifySizes, ACopyOutsideItsTarget) {
    auto node = frame.transfer("move");
    const Buffer target = node.fill(frame.buffer("x", {64}), 0);
    (void)node.copy(input, 0, target, 32, 33);
    expectError("node 'move' uses bytes 32 to 65 of buffer 'x', which has 64");
}

TEST_F(VerifySizes, AnImageThatDoesNotFitItsBuffer) {
    auto node = frame.transfer("read back");
    const Image image = compute("draw").write(0, frame.image("x", kColour));
    (void)node.copyToBuffer(image, frame.importBuffer("host", {1023}, {}));
    expectError("node 'read back' uses bytes 0 to 1024 of buffer 'host', which has 1023");
}

TEST_F(VerifySizes, TexelsThatDoNotDivideTheBuffer) {
    compute("a").texels(0, input, Format::RGBA32Float);
    expectError("node 'a' uses buffer 'input' of 100 bytes as texels of RGBA32Float (16 bytes)");
}

TEST_F(VerifySizes, AnAttachmentSmallerThanWhatIsDrawn) {
    auto node = frame.raster("draw", {16, 9});
    (void)node.clearedColour(0, frame.image("x", kColour));
    finish(node);
    expectError("node 'draw' draws 16x9 into 'x', which has 16x8");
}

TEST_F(VerifySizes, AColourFormatIsNoDepth) {
    auto node = frame.raster("draw", kColour.extent);
    (void)node.clearedDepth(frame.image("x", kColour));
    finish(node);
    expectError("node 'draw' has 'x' (RGBA16Float) as depth attachment");
}

TEST_F(VerifySizes, AFillOfOddSize) {
    (void)frame.transfer("clear").fill(frame.buffer("x", {6}), 0);
    expectError("node 'clear' fills buffer 'x' of 6 bytes, not a multiple of 4");
}

TEST_F(VerifySizes, ImagesOfDifferentSizesAreNotCopied) {
    const Image image = compute("draw").write(0, frame.image("x", kColour));
    (void)frame.transfer("copy").copy(image, frame.image("y", {kColour.format, {8, 8}}));
    expectError("node 'copy' copies image 'x' into 'y' of another size or format");
}

TEST_F(VerifySizes, ALayerThatIsNotThere) {
    (void)frame.transfer("up").copyToImage(input, 0, frame.image("x", {Format::R32Uint, {5, 5}}),
                                           1);
    expectError("node 'up' copies to layer 1 of image 'x', which has 1");
}

}  // namespace
}  // namespace lampyris::graph
