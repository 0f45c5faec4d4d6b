// full: the (tile, photon) pairs, photon by photon; run once to count them and once to write them (WRITE_PAIRS). A
// photon visits only the tiles under its outline, a thread for each band of rows. Pairs are tallied by tile and share,
// a share being a run of pairs.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bin_bounds.glsl"
#include "lib/bin_photons.glsl"

layout(local_size_x = 64) in;
#ifdef WRITE_PAIRS
layout(set = 0, binding = SLOT_BIN_OFFSETS, std430) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_BIN_PAIRS, std430) writeonly buffer Pairs { uvec2 pairs[]; };
layout(set = 0, binding = SLOT_BIN_SHARES, std430) buffer Shares { uint shares[]; };
#else
layout(set = 0, binding = SLOT_BIN_COUNTS, std430) writeonly buffer Counts { uint counts[]; };
#endif

// Whether the sphere touches the tile's column (x) and its row (y).
bvec2 touches(vec3 centre, ivec2 tile) {
    return lessThan(outsidePlanes(centre, tileFrustum(uvec2(tile), vec2(0.0))), vec2(params.radius));
}

void write(uint pair, uint tile, uint photon) {
#ifdef WRITE_PAIRS
    if (pair >= params.pairCapacity) return;
    pairs[pair] = uvec2(tile, photon);
    atomicAdd(shares[pair / params.share * view.tilesX * view.tilesY + tile], 1u);
#endif
}

// Visits a box of tiles, and the planes of each where `testPlanes`; returns the place behind the last pair.
uint visit(ivec2 first, ivec2 last, vec3 centre, uint photon, uint pair, const bool testPlanes) {
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            vec2 depths = boundsOf(uvec2(x, y));
            bool touching = depths.x <= depths.y && sphereTouchesDepths(centre.z, params.radius, depths);
            if (testPlanes) touching = touching && all(touches(centre, ivec2(x, y)));
            if (!touching) continue;
            write(pair, uint(y) * view.tilesX + uint(x), photon);
            ++pair;
        }
    return pair;
}

void main() {
    uint photon = gl_GlobalInvocationID.x;
    if (photon >= params.capacity) return;
    uint place = photon * params.bands + gl_WorkGroupID.y;
#ifdef WRITE_PAIRS
    uint pair = offsets[place];
#else
    uint pair = 0u;
#endif
    ivec2 first = ivec2(1), last = ivec2(0);
    vec3 centre = vec3(0.0);
    bool boxed = true;
    if (photon < photonCount()) {
        centre = photonViewDepth(photon);
        boxed = sphereTiles(centre, params.radius, first, last);
        // What sphereTiles took to be safe, less than a tile, goes by the very test of tile_test.comp; inside the box
        // only depths are left to test.
        if (boxed) {
            first += ivec2(not(touches(centre, first)));
            last -= ivec2(not(touches(centre, last)));
        }
    }
    int band = int(gl_WorkGroupID.y * params.bandRows);
    first.y = max(first.y, band);
    last.y = min(last.y, band + int(params.bandRows) - 1);
    // Two loops, since lavapipe does not branch around what no lane wants: few photons have no box.
    ivec2 none = ivec2(-1);
    pair = visit(first, boxed ? last : none, centre, photon, pair, false);
    pair = visit(first, boxed ? none : last, centre, photon, pair, true);
#ifndef WRITE_PAIRS
    counts[place] = pair;
#endif
}
