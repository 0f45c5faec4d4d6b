// A number a texel or tile, from black over red and yellow to white, over the picture.
// HEAT_TILES: photons a tile; else frames in the mean of light.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/overlay.h"
#include "shared/view.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { HeatParams params; };
#ifdef HEAT_TILES
layout(set = 0, binding = SLOT_HEAT_RANGES, std430) readonly buffer Ranges { uvec2 ranges[]; };
#else
layout(set = 0, binding = SLOT_HEAT_MEAN) uniform sampler2D mean;
#endif
layout(set = 0, binding = SLOT_HEAT_SHOWN, rgba8) uniform image2D shown;

float valueAt(uvec2 pixel) {
#ifdef HEAT_TILES
    uvec2 tile = pixel / TILE_PIXELS;
    return float(ranges[tile.y * params.tilesX + tile.x].y);
#else
    return texelFetch(mean, ivec2(pixel / params.divisor), 0).a;
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(shown)))) return;
    float x = clamp(valueAt(uvec2(pixel)) / params.most, 0.0, 1.0);
    vec3 heat = clamp(3.0 * x - vec3(0.0, 1.0, 2.0), 0.0, 1.0);
    vec3 under = imageLoad(shown, pixel).rgb;
    imageStore(shown, pixel, vec4(mix(under, heat, params.opacity), 1.0));
}
