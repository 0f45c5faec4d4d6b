// full: writes the (tile, photon) pairs, photon by photon, where the sums before them say.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bin_photons.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_BIN_OFFSETS, std430) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_BIN_TILES, std430) writeonly buffer Tiles { uint tiles[]; };
layout(set = 0, binding = SLOT_BIN_INDICES, std430) writeonly buffer Indices { uint indices[]; };
layout(set = 0, binding = SLOT_BIN_COUNTERS, std430) buffer Counters { FrameCounters counters; };

void main() {
    uint photon = gl_GlobalInvocationID.x;
    if (photon == 0u) {
        uint total = offsets[params.capacity];
        atomicAdd(counters.pairs, min(total, params.pairCapacity));
        atomicAdd(counters.pairsDropped, total - min(total, params.pairCapacity));
        atomicMax(counters.pairsNeeded, total);
    }
    if (photon >= photonCount()) return;
    vec3 centre = photonViewDepth(photon);
    ivec2 first, last;
    sphereTiles(centre, params.radius, first, last);
    uint at = offsets[photon];
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            uint tile = uint(y) * view.tilesX + uint(x);
            vec2 depths = bounds[tile];
            if (depths.x > depths.y || at >= params.pairCapacity) continue;
            if (!sphereTouchesTile(centre, params.radius, tileFrustum(uvec2(x, y), depths))) continue;
            tiles[at] = tile;
            indices[at] = photon;
            ++at;
        }
}
