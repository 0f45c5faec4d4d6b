// The boxes of one level of the BVH: each instance is a way down from the root, a bit a level.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/bvh.h"
#include "shared/overlay.h"
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };
layout(set = 0, binding = SLOT_BOX_NODES) uniform usamplerBuffer nodes;
layout(set = 0, binding = SLOT_BOX_ROOT, std140) uniform Root { GpuBvhRoot root; };
layout(push_constant) uniform Push { BoxParams params; };

layout(location = 0) out vec3 colourOut;

// Where a tree's coordinates lie in the world.
struct Space {
    mat3 linear;
    vec3 shift;
    vec3 gridOffset, gridCell;
};

vec4 floatsAt(uint texel) { return uintBitsToFloat(texelFetch(nodes, int(texel))); }

// An instance's record: into its own tree.
uint enterInstance(uint link, out Space space) {
    uint texel = (link & BVH_INDEX_MASK) * BVH_NODE_TEXELS;
    vec4 r0 = floatsAt(texel), r1 = floatsAt(texel + 1u), r2 = floatsAt(texel + 2u);
    mat3 worldToObject = transpose(mat3(r0.xyz, r1.xyz, r2.xyz));
    space.linear = inverse(worldToObject);
    space.shift = -space.linear * vec3(r0.w, r1.w, r2.w);
    space.gridOffset = floatsAt(texel + 4u).xyz;
    space.gridCell = floatsAt(texel + 5u).xyz;
    return texelFetch(nodes, int(texel + 3u)).x;
}

bool isInner(uint link) { return (link & (BVH_LEAF | BVH_INSTANCE)) == 0u; }

vec3 cornerAt(uint which, uvec3 box) {
    uvec3 bit = uvec3(which & 1u, (which >> 1) & 1u, (which >> 2) & 1u);
    return vec3(mix(box & 0xffffu, box >> 16, equal(bit, uvec3(1u))));
}

void main() {
    const uint edges[24] = uint[](0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 0u, 2u, 1u, 3u, 4u, 6u, 5u, 7u, 0u, 4u, 1u, 5u, 2u, 6u, 3u, 7u);
    colourOut = vec3(0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    Space space = Space(mat3(1.0), vec3(0.0), root.grid.offset.xyz, root.grid.cell.xyz);
    uint link = root.link;
    uvec3 box = uvec3(0u);
    uint way = gl_InstanceIndex;
    bool below = false;  // in an instance's own tree
    for (uint level = 0u; level < params.level; ++level) {
        if (link == BVH_NOTHING) return;
        if ((link & BVH_LEAF) == 0u && (link & BVH_INSTANCE) != 0u) {
            link = enterInstance(link, space);
            below = true;
        }
        if (link == BVH_NOTHING || !isInner(link)) return;  // ends above
        uvec4 child = texelFetch(nodes, int(link * BVH_NODE_TEXELS + (way & 1u)));
        way >>= 1;
        box = child.xyz;
        link = child.w;
    }
    if (link == BVH_NOTHING) return;
    vec3 local = space.gridOffset + space.gridCell * cornerAt(edges[gl_VertexIndex], box);
    colourOut = below ? vec3(0.3, 1.0, 0.45) : vec3(1.0, 0.75, 0.2);
    vec4 clip = view.worldToClip * vec4(space.linear * local + space.shift, 1.0);
    clip.z *= 1.004;
    gl_Position = clip;
}
