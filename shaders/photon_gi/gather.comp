// Irradiance at low resolution. ADD_TO_COARSE: adds to what earlier batches of photons gave.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/photon_estimate.glsl"

layout(local_size_x = 64) in;
#ifdef ADD_TO_COARSE
layout(set = 0, binding = SLOT_GATHER_COARSE, rgba32f) uniform image2D coarse;
#else
layout(set = 0, binding = SLOT_GATHER_COARSE, rgba32f) uniform writeonly image2D coarse;
#endif

// Eight neighbouring threads stand in one tile where the divisor allows it: they walk the same list.
ivec2 texelOfThread() {
    uint perAxis = max(TILE_PIXELS / params.divisor, 1u);        // texels a tile and axis
    uint perTile = perAxis * perAxis;
    uint tilesX = (params.coarseWidth + perAxis - 1u) / perAxis;
    uint thread = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x;
    uint tile = thread / perTile, inTile = thread % perTile;
    return ivec2(uvec2(tile % tilesX, tile / tilesX) * perAxis + uvec2(inTile % perAxis, inTile / perAxis));
}

void main() {
    ivec2 texel = texelOfThread();
    if (texel.x >= int(params.coarseWidth) || texel.y >= int(params.coarseHeight)) return;
    ivec2 pixel = representative(texel);
    float depth = depthAt(pixel);
    vec3 irradiance = vec3(0.0);
    if (depth > 0.0)
        irradiance = irradianceEstimate(uvec2(pixel) / TILE_PIXELS, positionWorld(pixel, depth), normalAt(pixel));
#ifdef ADD_TO_COARSE
    irradiance += imageLoad(coarse, texel).rgb;
#endif
    imageStore(coarse, texel, vec4(irradiance, 1.0));
}
