// From pixels to positions and back. Depth is reversed: near plane 1, infinity 0, background exactly 0.
#ifndef LAMPYRIS_LIB_VIEW_SPACE
#define LAMPYRIS_LIB_VIEW_SPACE
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };

// Metres along the viewing axis; depth must not be 0.
float viewDepth(float depth) { return view.projection.z / depth; }

// Slopes x/depth and y/depth of a point of the image plane in pixels (y up).
vec2 slopes(vec2 pixel) {
    vec2 scale = vec2(2.0, -2.0) / (vec2(view.width, view.height) * view.projection.xy);
    return pixel * scale + vec2(-1.0, 1.0) / view.projection.xy;
}

vec3 positionView(ivec2 pixel, float depth) {
    float z = viewDepth(depth);
    return vec3(slopes(vec2(pixel) + 0.5) * z, -z);
}

vec3 positionWorld(ivec2 pixel, float depth) { return (view.viewToWorld * vec4(positionView(pixel, depth), 1.0)).xyz; }

vec3 cameraWorld() { return view.viewToWorld[3].xyz; }

// Width of a pixel at this distance along the axis, metres.
float pixelFootprint(float z) { return 2.0 * z / (view.projection.y * float(view.height)); }

#endif
