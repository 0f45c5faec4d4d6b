// Least and greatest view depth of every 8 × 8 tile; (1, 0) where it shows no surface.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/view_space.glsl"
#include "shared/direct.h"
#include "shared/surface.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_SURFACE_DEPTH) uniform sampler2D surfaceDepth;
layout(set = 0, binding = SLOT_TILE_BOUNDS, std430) writeonly buffer Bounds { vec2 bounds[]; };

// One thread a tile: 64 fetches each, no shared memory, no atomics.
void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= view.tilesX * view.tilesY) return;
    ivec2 first = ivec2(tile % view.tilesX, tile / view.tilesX) * int(TILE_PIXELS);
    ivec2 last = min(first + int(TILE_PIXELS), ivec2(view.width, view.height));
    float nearest = 0.0, farthest = 1e30;
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) {
            float depth = texelFetch(surfaceDepth, ivec2(x, y), 0).r;
            if (depth > 0.0) {
                nearest = max(nearest, depth);
                farthest = min(farthest, depth);
            }
        }
    bounds[tile] = nearest > 0.0 ? vec2(viewDepth(nearest), viewDepth(farthest)) : vec2(1.0, 0.0);
}
