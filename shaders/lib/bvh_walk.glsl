// Rays through the scene's two-level BVH. C++ binds the slots with accel::bindTraversal.
//   traceClosest  the nearest hit with tMin < t <= tMax; at equal t the lower (instance, primitive)
//   traceAny      whether there is one
// Both sides of a triangle are hit. Directions need not be unit; t counts their lengths. The triangle test is
// watertight (after Woop et al. 2013): no ray slips between triangles of a mesh that share an edge.
#ifndef LAMPYRIS_LIB_BVH_WALK
#define LAMPYRIS_LIB_BVH_WALK
#include "lib/scene_material.glsl"
#include "shared/bvh.h"

layout(constant_id = SPEC_BVH_STACK) const uint bvhStackEntries = 64u;
layout(constant_id = SPEC_BVH_MASKED) const uint bvhMasked = 1u;
layout(constant_id = SPEC_BVH_INSTANCED) const uint bvhInstanced = 1u;
layout(set = 0, binding = SLOT_BVH_NODES) uniform usamplerBuffer bvhNodes;
layout(set = 0, binding = SLOT_BVH_TRIANGLES) uniform samplerBuffer bvhTriangles;
layout(set = 0, binding = SLOT_BVH_ROOT, std140) uniform BvhRoot { GpuBvhRoot bvhRoot; };

// The one place that fetches: a device that prefers storage buffers changes these two lines.
uvec4 nodeTexel(uint node, int texel) { return texelFetch(bvhNodes, int(node * BVH_NODE_TEXELS) + texel); }
vec4 triangleTexel(uint triangle, int corner) {
    return texelFetch(bvhTriangles, int(triangle * BVH_TRIANGLE_TEXELS) + corner);
}

// A ray in the space of the tree being walked. A number of cells n is met at t = n · slabScale + slabOffset. The rows
// shear that space so that the ray runs along +z, with z = t.
struct WalkRay {
    vec3 origin;
    vec3 slabScale, slabOffset;
    vec3 rowX, rowY, rowZ;
};

WalkRay walkRay(vec3 origin, vec3 direction, vec3 gridOffset, vec3 gridCell) {
    WalkRay ray;
    ray.origin = origin;
    vec3 tiny = vec3(1e-20);
    vec3 inverse = 1.0 / mix(direction, tiny, lessThan(abs(direction), tiny));
    ray.slabScale = gridCell * inverse;
    ray.slabOffset = (gridOffset - origin) * inverse;
    vec3 a = abs(direction);
    vec3 axis = a.x > a.y ? (a.x > a.z ? vec3(1, 0, 0) : vec3(0, 0, 1)) : (a.y > a.z ? vec3(0, 1, 0) : vec3(0, 0, 1));
    ray.rowZ = axis / dot(axis, direction);
    ray.rowX = axis.yzx - ray.rowZ * dot(axis.yzx, direction);
    ray.rowY = axis.zxy - ray.rowZ * dot(axis.zxy, direction);
    return ray;
}

WalkRay worldRay(vec3 origin, vec3 direction) {
    return walkRay(origin, direction, bvhRoot.grid.offset.xyz, bvhRoot.grid.cell.xyz);
}

// Where the ray enters a box, or a huge number where it misses. Boxes are a cell too wide, the far end a few roundings.
float enterBox(WalkRay ray, uvec3 box, float tMin, float tMax) {
    vec3 a = vec3(box & 0xffffu) * ray.slabScale + ray.slabOffset;
    vec3 b = vec3(box >> 16) * ray.slabScale + ray.slabOffset;
    vec3 near = min(a, b);
    vec3 far = max(a, b);
    float enter = max(max(near.x, near.y), max(near.z, tMin));
    float leave = min(min(far.x, far.y), min(far.z, tMax)) * 1.0000005;
    return enter <= leave ? enter : 1e38;
}

// Weights of the three corners, not normalised, and t; false where the ray misses. Edge functions of an edge
// are exact negatives in the two triangles that share it: hence `precise`, and no fused product.
bool crossTriangle(WalkRay ray, vec3 v0, vec3 v1, vec3 v2, out vec2 bary, out float t) {
    v0 -= ray.origin;
    v1 -= ray.origin;
    v2 -= ray.origin;
    precise vec3 x = vec3(dot(ray.rowX, v0), dot(ray.rowX, v1), dot(ray.rowX, v2));
    precise vec3 y = vec3(dot(ray.rowY, v0), dot(ray.rowY, v1), dot(ray.rowY, v2));
    precise vec3 w = x.zxy * y.yzx - y.zxy * x.yzx;
    float total = w.x + w.y + w.z;
    vec3 z = vec3(dot(ray.rowZ, v0), dot(ray.rowZ, v1), dot(ray.rowZ, v2));
    float scale = 1.0 / total;
    bary = w.yz * scale;
    t = dot(w, z) * scale;
    return total != 0.0 && (min(min(w.x, w.y), w.z) >= 0.0 || max(max(w.x, w.y), w.z) <= 0.0);
}

// Loops within loops, and little else: a SIMD device pays for every branch of a loop's body in every turn.
bool walkBvh(vec3 origin, vec3 direction, float tMin, float tMax, bool any, out Hit hit, out uint triangle) {
    hit = Hit(tMax, BVH_NOTHING, BVH_NOTHING, vec2(0.0), vec3(0.0));
    triangle = BVH_NOTHING;
    uint stack[bvhStackEntries];
    uint top = 1u;
    stack[0] = BVH_NOTHING;  // under the entries of each tree: its end
    uint link = bvhRoot.link;
    uint instance = bvhRoot.instance;
    uint flags = bvhRoot.flags;
    WalkRay ray = worldRay(origin, direction);
    while (true) {
        while ((link & BVH_INSTANCE) == 0u) {  // inner node or leaf: neither record nor end
            while ((link & (BVH_LEAF | BVH_INSTANCE)) == 0u) {
                uvec4 left = nodeTexel(link, 0), right = nodeTexel(link, 1);
                float enterLeft = enterBox(ray, left.xyz, tMin, hit.t);
                float enterRight = enterBox(ray, right.xyz, tMin, hit.t);
                bool leftFirst = enterLeft <= enterRight;
                link = leftFirst ? left.w : right.w;
                if (max(enterLeft, enterRight) < 1e38) stack[top++] = leftFirst ? right.w : left.w;
                if (min(enterLeft, enterRight) >= 1e38) link = stack[--top];
            }
            if ((link & BVH_INSTANCE) != 0u) break;
            uint next = link & BVH_INDEX_MASK;
            uint end = next + ((link >> BVH_COUNT_SHIFT) & 3u) + 1u;
            for (; next < end; ++next) {
                vec4 v0 = triangleTexel(next, 0);
                vec2 bary;
                float t;
                bool inside = crossTriangle(ray, v0.xyz, triangleTexel(next, 1).xyz, triangleTexel(next, 2).xyz, bary, t);
                uint primitive = floatBitsToUint(v0.w);
                bool closer = t < hit.t || (t == hit.t && (instance < hit.instance ||
                                            (instance == hit.instance && primitive < hit.primitive)));
                if (!(inside && t > tMin && closer)) continue;
                if (bvhMasked != 0u && (flags & INSTANCE_MASKED) != 0u && !opaqueAt(instance, primitive, bary)) continue;
                hit.t = t;
                hit.bary = bary;
                hit.instance = instance;
                hit.primitive = primitive;
                triangle = next;
            }
            link = any && triangle != BVH_NOTHING ? BVH_NOTHING : stack[--top];
        }
        if (bvhInstanced == 0u || (any && triangle != BVH_NOTHING)) break;
        if (link != BVH_NOTHING) {
            uint record = link & BVH_INDEX_MASK;
            vec4 x = uintBitsToFloat(nodeTexel(record, 0)), y = uintBitsToFloat(nodeTexel(record, 1));
            vec4 z = uintBitsToFloat(nodeTexel(record, 2)), from = vec4(origin, 1.0);
            uvec4 tree = nodeTexel(record, 3);
            ray = walkRay(vec3(dot(x, from), dot(y, from), dot(z, from)),
                          vec3(dot(x.xyz, direction), dot(y.xyz, direction), dot(z.xyz, direction)),
                          uintBitsToFloat(nodeTexel(record, 4).xyz), uintBitsToFloat(nodeTexel(record, 5).xyz));
            link = tree.x;
            instance = tree.y;
            flags = tree.z;
            stack[top++] = BVH_NOTHING;
        } else {
            if (instance == BVH_NOTHING) break;
            ray = worldRay(origin, direction);
            instance = BVH_NOTHING;
            link = stack[--top];
        }
    }
    return triangle != BVH_NOTHING;
}

bool traceClosest(vec3 origin, vec3 direction, float tMin, float tMax, out Hit hit) {
    uint triangle;
    if (!walkBvh(origin, direction, tMin, tMax, false, hit, triangle)) return false;
    vec3 v0 = triangleTexel(triangle, 0).xyz;
    vec3 normal = cross(triangleTexel(triangle, 1).xyz - v0, triangleTexel(triangle, 2).xyz - v0);
    normal /= max(max(abs(normal.x), abs(normal.y)), abs(normal.z));  // its square might not be a float
    hit.normalWorld = normalize(normal.x * instances[hit.instance].worldToObject0.xyz +
                                normal.y * instances[hit.instance].worldToObject1.xyz +
                                normal.z * instances[hit.instance].worldToObject2.xyz);
    return true;
}

bool traceAny(vec3 origin, vec3 direction, float tMin, float tMax) {
    Hit hit;
    uint triangle;
    return walkBvh(origin, direction, tMin, tMax, true, hit, triangle);
}

#endif
