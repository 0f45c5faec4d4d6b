// How far a low-resolution texel stands for another place of a surface: same way up, same plane.                 [F2]
#ifndef LAMPYRIS_LIB_JOINT_WEIGHT
#define LAMPYRIS_LIB_JOINT_WEIGHT
#include "lib/pack.glsl"

struct Place {
    vec3 position;  // world, metres; far out where there is no surface
    vec3 normal;    // of the geometry; shadows': mapped
};

const uvec4 kNoPlace = uvec4(0x7149f2cau);  // 1e30, and some normal

Place placeOf(uvec4 guide) { return Place(uintBitsToFloat(guide.xyz), unpackDirection(guide.w)); }

// spacing: metres between two texels. The normal may be a mapped one.
float jointWeight(vec3 position, vec3 normal, Place other, float spacing) {
    // [chosen] Light is carried over to surfaces that lean by less than 70 degrees.
    float same = max(dot(normal, other.normal) - 0.34, 0.0) / 0.66;
    // [chosen] Half a texel off the tangent plane is another surface; a curved one bends no more within a texel.
    float off = abs(dot(other.normal, other.position - position)) / (0.5 * spacing);
    return same * same * max(1.0 - off, 0.0);
}

// Looser than jointWeight: what hides a light does not hang on a mapped normal, which may lean far from its neighbours'.
// [D5]
float sameSurface(vec3 position, vec3 normal, Place other, float spacing) {
    float off = abs(dot(normal, other.position - position)) / (1.5 * spacing);
    return dot(normal, other.normal) > 0.5 ? clamp(2.0 - 2.0 * off, 0.0, 1.0) : 0.0;
}

// [chosen] Where the shares of a light that texels see differ by more, an edge lies between them.
const float kMostApart = 0.7;

#endif
