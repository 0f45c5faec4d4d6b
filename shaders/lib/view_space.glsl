// From pixels to positions and back. Depth is reversed: near plane 1, infinity 0, background exactly 0.
#ifndef LAMPYRIS_LIB_VIEW_SPACE
#define LAMPYRIS_LIB_VIEW_SPACE
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };

// Metres along the viewing axis; depth must not be 0.
float viewDepth(float depth) { return view.projection.z / depth; }

// Slopes x/depth and y/depth of a point of the image plane in pixels (y up).
vec2 slopes(vec2 pixel) {
    vec2 ndc = pixel / vec2(view.width, view.height) * 2.0 - 1.0;
    return vec2(ndc.x, -ndc.y) / view.projection.xy;
}

vec3 positionWorld(ivec2 pixel, float depth) {
    float z = viewDepth(depth);
    return (view.viewToWorld * vec4(slopes(vec2(pixel) + 0.5) * z, -z, 1.0)).xyz;
}

vec3 cameraWorld() { return view.viewToWorld[3].xyz; }

// Width of a pixel at this distance along the axis, metres.
float pixelFootprint(float z) { return 2.0 * z / (view.projection.y * float(view.height)); }

#endif
