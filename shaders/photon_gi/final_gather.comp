// Indirect light at low resolution, about the geometry's normal; where each texel stands; and how often each slot of
// the grid was looked up.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/final_gather.glsl"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_FINAL_COARSE, rgba32ui) uniform writeonly uimage2D coarse;
layout(set = 0, binding = SLOT_FINAL_GUIDE, rgba32ui) uniform writeonly uimage2D guide;
layout(set = 0, binding = SLOT_FINAL_LOOK_UPS, std430) buffer LookUps { uint lookUps[]; };

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= int(params.coarseWidth) || texel.y >= int(params.coarseHeight)) return;
    ivec2 pixel = representative(texel);
    float depth = depthAt(pixel);
    CoarseLight light = CoarseLight(vec3(0.0), vec3(0.0), 1.0);
    uvec4 place = kNoPlace;
    if (depth > 0.0) {
        vec3 position = positionWorld(pixel, depth);
        vec3 normal = geometricNormalAt(pixel, depth);
        uint slot;
        light = finalGather(position, viewDepth(depth), normal, params.rays, params.emitterCount,
                            GatherPoints(placeInNet(uvec2(texel), params.turn) * params.rays,
                                         seedRandom(params.turn >> 6, params.seed)), slot);
        if (slot <= grid.slotMask) atomicAdd(lookUps[slot], 1u);  // one ray speaks for all
        place = uvec4(floatBitsToUint(position), packDirection(normal));
    }
    imageStore(coarse, texel, packLight(light));
    imageStore(guide, texel, place);
}
