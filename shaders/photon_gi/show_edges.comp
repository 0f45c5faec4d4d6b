// Pixels whose irradiance is estimated anew at full resolution: 1, else 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/view_space.glsl"
#include "shared/show_light.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_SHOWN_EDGES) uniform usampler2D edges;
layout(set = 0, binding = SLOT_SHOWN_LIGHT, rgba32f) uniform writeonly image2D shown;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= int(view.width) || pixel.y >= int(view.height)) return;
    imageStore(shown, pixel, vec4(vec3(texelFetch(edges, pixel, 0).r > 0u ? 1.0 : 0.0), 1.0));
}
