// A tile's frustum as slopes x/depth and y/depth, and whether a sphere touches it. One grid, indexed by the
// full-resolution pixel; the image's own size divides, not the padded one.
#ifndef LAMPYRIS_LIB_TILE
#define LAMPYRIS_LIB_TILE
#include "lib/view_space.glsl"

struct TileFrustum {
    vec2 low;   // left and bottom slopes
    vec2 high;  // right and top slopes
    float nearDepth, farDepth;
};

TileFrustum tileFrustum(uvec2 tile, vec2 depthBounds) {
    vec2 a = slopes(vec2(tile * TILE_PIXELS));
    vec2 b = slopes(vec2((tile + 1u) * TILE_PIXELS));
    return TileFrustum(vec2(a.x, b.y), vec2(b.x, a.y), depthBounds.x, depthBounds.y);
}

// How far a point stands outside the planes of a tile's columns (x) and rows (y), metres; negative inside.
// centre: x, y in view space and z = depth along the axis (positive in front).
// Plane distances as the Thesis's listing 5.14, but each plane needs only two products.
vec2 outsidePlanes(vec3 centre, TileFrustum t) {
    vec2 below = (t.low * centre.z - centre.xy) * inversesqrt(1.0 + t.low * t.low);
    vec2 above = (centre.xy - t.high * centre.z) * inversesqrt(1.0 + t.high * t.high);
    return max(below, above);
}

bool sphereTouchesDepths(float depth, float radius, vec2 depthBounds) {
    return depth + radius >= depthBounds.x && depth - radius <= depthBounds.y;
}

bool sphereTouchesTile(vec3 centre, float radius, TileFrustum t) {
    if (!sphereTouchesDepths(centre.z, radius, vec2(t.nearDepth, t.farDepth))) return false;
    vec2 outside = outsidePlanes(centre, t);
    return max(outside.x, outside.y) < radius;
}

// Tiles whose frusta a sphere can touch, by its tangents through the eye: [first, last], empty if first > last.
// False where the eye's plane cuts the sphere: then these are all tiles, and no box.
bool sphereTiles(vec3 centre, float radius, out ivec2 first, out ivec2 last) {
    ivec2 tiles = ivec2(view.tilesX, view.tilesY);
    first = ivec2(0);
    last = tiles - 1;
    if (centre.z + radius <= 0.0) {
        last = ivec2(-1);
        return true;
    }
    float forward = centre.z * centre.z - radius * radius;
    if (centre.z <= radius * 1.001) return false;
    vec2 spread = radius * sqrt(max(vec2(0.0), centre.xy * centre.xy + forward));
    vec2 low = (centre.xy * centre.z - spread) / forward;
    vec2 high = (centre.xy * centre.z + spread) / forward;
    vec2 size = vec2(view.width, view.height);
    vec2 a = (vec2(low.x, -high.y) * view.projection.xy * 0.5 + 0.5) * size;
    vec2 b = (vec2(high.x, -low.y) * view.projection.xy * 0.5 + 0.5) * size;
    // Clamped before the cast (far outside the integers' range), and a hundredth of a pixel wider for rounding.
    vec2 limit = vec2(tiles) + 1.0;
    first = max(ivec2(floor(clamp((a - 0.01) / float(TILE_PIXELS), vec2(-1.0), limit))), ivec2(0));
    last = min(ivec2(floor(clamp((b + 0.01) / float(TILE_PIXELS), vec2(-1.0), limit))), tiles - 1);
    return true;
}

vec3 toViewDepth(vec3 world) {
    vec3 v = (view.worldToView * vec4(world, 1.0)).xyz;
    return vec3(v.xy, -v.z);
}

#endif
