#include "photons/prefix_sum.h"

#include "photons/shaders.h"
#include "shared/photon.h"

namespace lampyris::photons {

graph::Buffer addPrefixSum(graph::Frame& frame, const std::string& node, graph::Buffer counts,
                           uint32_t count) {
    const uint32_t blockCount = (count + shared::SCAN_BLOCK - 1) / shared::SCAN_BLOCK;
    auto inside = frame.compute(node + "/sum_blocks", shaders::prefixSumBlocks);
    inside.read(shared::SLOT_SCAN_COUNTS, counts).push(count);
    graph::Buffer offsets =
        inside.write(shared::SLOT_SCAN_OFFSETS,
                     frame.buffer(node + " sums", {(uint64_t{count} + 1) * sizeof(uint32_t)}));
    graph::Buffer blocks = inside.write(
        shared::SLOT_SCAN_BLOCKS,
        frame.buffer(node + " block sums", {(uint64_t{blockCount} + 1) * sizeof(uint32_t)}));
    inside.dispatch(blockCount);

    auto totals = frame.compute(node + "/sum_totals", shaders::prefixSumTotals);
    totals.push(blockCount);
    blocks = totals.update(shared::SLOT_SCAN_BLOCKS, blocks);
    totals.dispatch(1);

    auto add = frame.compute(node + "/sum_add", shaders::prefixSumAdd);
    add.read(shared::SLOT_SCAN_BLOCKS, blocks).push(count);
    offsets = add.update(shared::SLOT_SCAN_OFFSETS, offsets);
    add.dispatch(blockCount);
    return offsets;
}

}  // namespace lampyris::photons
