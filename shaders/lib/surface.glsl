// Reading the G-buffer. Define SURFACE_MATERIAL to have the material images bound too.
#ifndef LAMPYRIS_LIB_SURFACE
#define LAMPYRIS_LIB_SURFACE
#include "lib/pack.glsl"
#include "lib/view_space.glsl"
#include "shared/surface.h"

layout(set = 0, binding = SLOT_SURFACE_DEPTH) uniform sampler2D surfaceDepth;
layout(set = 0, binding = SLOT_SURFACE_NORMAL) uniform usampler2D surfaceNormal;
#ifdef SURFACE_MATERIAL
layout(set = 0, binding = SLOT_SURFACE_ALBEDO) uniform sampler2D surfaceAlbedo;
layout(set = 0, binding = SLOT_SURFACE_SPECULAR) uniform sampler2D surfaceSpecular;
layout(set = 0, binding = SLOT_SURFACE_EMISSION) uniform usampler2D surfaceEmission;
#endif

bool insideImage(ivec2 pixel) { return all(lessThan(pixel, ivec2(view.width, view.height))); }
float depthAt(ivec2 pixel) { return texelFetch(surfaceDepth, pixel, 0).r; }
vec3 normalAt(ivec2 pixel) { return unpackDirection(texelFetch(surfaceNormal, pixel, 0).r); }

// The neighbour to one side or the other whose depth is nearer: on planes, depth is linear over the image.
ivec2 nearerNeighbour(ivec2 pixel, float depth, ivec2 side) {
    ivec2 last = ivec2(view.width, view.height) - 1;
    ivec2 a = clamp(pixel - side, ivec2(0), last), b = clamp(pixel + side, ivec2(0), last);
    if (a == pixel) return b;
    if (b == pixel) return a;
    return abs(depthAt(a) - depth) < abs(depthAt(b) - depth) ? a : b;
}

// The normal of the triangles, from depth; the mapped one at the background, or where the two are far apart, as beside
// other surfaces.
vec3 geometricNormalAt(ivec2 pixel, float depth) {
    vec3 mapped = normalAt(pixel);
    ivec2 h = nearerNeighbour(pixel, depth, ivec2(1, 0)), v = nearerNeighbour(pixel, depth, ivec2(0, 1));
    if (min(depthAt(h), depthAt(v)) <= 0.0) return mapped;
    vec3 position = positionView(pixel, depth);  // the world's numbers may be too large to tell pixels apart
    vec3 across = (positionView(h, depthAt(h)) - position) * float(h.x - pixel.x);
    vec3 down = (positionView(v, depthAt(v)) - position) * float(v.y - pixel.y);
    vec3 normal = mat3(view.viewToWorld) * cross(down, across);
    float size = length(normal);
    // [chosen] Normals are mapped, or smoothed over triangles, by less than 60 degrees.
    return size > 0.0 && dot(normal, mapped) > 0.5 * size ? normal / size : mapped;
}

#endif
