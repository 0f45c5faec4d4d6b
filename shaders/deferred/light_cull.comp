// For every tile: a bit a light that reaches some surface in it, and a bit a light whose own disc may show.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/tile.glsl"
#include "shared/direct.h"
#include "shared/scene.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { DirectParams params; };
layout(set = 0, binding = SLOT_TILE_BOUNDS, std430) readonly buffer Bounds { vec2 bounds[]; };
layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_LIGHT_REACH, std430) readonly buffer Reach { float reach[]; };
layout(set = 0, binding = SLOT_LIGHT_MASKS, std430) writeonly buffer Masks { uint masks[]; };

void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= view.tilesX * view.tilesY) return;
    uvec2 at = uvec2(tile % view.tilesX, tile / view.tilesX);
    vec2 depths = bounds[tile];
    bool surface = depths.x <= depths.y;
    TileFrustum surfaces = tileFrustum(at, depths);
    TileFrustum whole = tileFrustum(at, vec2(0.0, 1e30));
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint reaching = 0u, showing = 0u;
        for (uint bit = 0u; bit < 32u && word * 32u + bit < params.lightCount; ++bit) {
            uint i = word * 32u + bit;
            vec3 centre = toViewDepth(lights[i].positionRadius.xyz);
            if (surface && sphereTouchesTile(centre, reach[i], surfaces)) reaching |= 1u << bit;
            if (sphereTouchesTile(centre, lights[i].positionRadius.w, whole)) showing |= 1u << bit;
        }
        masks[(tile * 2u) * params.maskWords + word] = reaching;
        masks[(tile * 2u + 1u) * params.maskWords + word] = showing;
    }
}
