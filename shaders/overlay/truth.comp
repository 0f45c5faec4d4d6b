// A picture from the host as an image, to be looked at.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/overlay.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_TRUTH_WORDS, std430) readonly buffer Words { uint words[]; };
layout(set = 0, binding = SLOT_TRUTH_SHOWN, rgba8) uniform writeonly image2D shown;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(shown);
    if (all(lessThan(pixel, size))) imageStore(shown, pixel, unpackUnorm4x8(words[pixel.y * size.x + pixel.x]));
}
