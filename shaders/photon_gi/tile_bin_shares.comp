// full: of each tile, the pairs before each share, in place, and their number in all.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/pair_shares.glsl"
#include "lib/view_space.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_BIN_SHARES, std430) buffer Shares { uint shares[]; };
layout(set = 0, binding = SLOT_BIN_COUNTS, std430) writeonly buffer Counts { uint counts[]; };

void main() {
    uint tile = gl_GlobalInvocationID.x;
    uint tileCount = view.tilesX * view.tilesY;
    if (tile >= tileCount) return;
    uint running = 0u;
    for (uint share = 0u; share * params.share < pairCount(); ++share) {
        uint own = shares[share * tileCount + tile];
        shares[share * tileCount + tile] = running;
        running += own;
    }
    counts[tile] = running;
}
