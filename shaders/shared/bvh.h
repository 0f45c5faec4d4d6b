// The two-level BVH as traversal reads it. Written by modules/accel; read through lib/bvh_walk.glsl alone.
#ifndef LAMPYRIS_SHARED_BVH_H
#define LAMPYRIS_SHARED_BVH_H

#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_BVH_NODES, 16u);      // texels RGBA32Uint, BVH_NODE_TEXELS a node
LAMPYRIS_SLOT(SLOT_BVH_TRIANGLES, 17u);  // texels RGBA32Float, BVH_TRIANGLE_TEXELS a triangle
LAMPYRIS_SLOT(SLOT_BVH_ROOT, 18u);       // uniform GpuBvhRoot

// Specialization constants.
LAMPYRIS_SLOT(SPEC_BVH_STACK, 16u);      // entries of the traversal stack: at least the depth of the deepest path
LAMPYRIS_SLOT(SPEC_BVH_MASKED, 17u);     // 0 where no instance is alpha-masked
LAMPYRIS_SLOT(SPEC_BVH_INSTANCED, 18u);  // 0 where the root leads to triangles alone: one instance at the identity

// A node: for the left and the right child a texel of the child's box and link. A box is three words, x y z:
// lower in the low half, upper in the high half, in cells of the tree's grid (see BvhGrid).
LAMPYRIS_SLOT(BVH_NODE_TEXELS, 2u);
// A triangle: (v0, primitive) (v1, 0) (v2, 0), object space, in the order of the leaves.
LAMPYRIS_SLOT(BVH_TRIANGLE_TEXELS, 3u);

// A link: an inner node's index; or a leaf: 1 to 4 triangles, count − 1 in two bits; or an instance's record.
LAMPYRIS_SLOT(BVH_LEAF, 0x80000000u);
LAMPYRIS_SLOT(BVH_INSTANCE, 0x40000000u);
LAMPYRIS_SLOT(BVH_COUNT_SHIFT, 28u);
LAMPYRIS_SLOT(BVH_INDEX_MASK, 0x0fffffffu);
LAMPYRIS_SLOT(BVH_NOTHING, 0xffffffffu);  // no child

// A tree's boxes are whole cells: coordinate = offset + cell · number, numbers from 0 to 65535.
struct GpuBvhGrid {
    vec4 offset;  // xyz in the tree's space, metres
    vec4 cell;    // xyz, metres
};

// An instance's record stands among the nodes and takes the place of three.
struct GpuBvhInstance {
    vec4 worldToObject0, worldToObject1, worldToObject2;  // rows
    uint rootLink;  // of its mesh's tree
    uint instance;
    uint flags;     // INSTANCE_…
    uint pad0;
    GpuBvhGrid grid;  // of its mesh's tree
};
LAMPYRIS_SLOT(BVH_RECORD_NODES, 3u);

// Where every ray begins. With one instance at the identity it begins in that instance's tree.
struct GpuBvhRoot {
    uint link;        // BVH_NOTHING for an empty scene
    uint instance;    // of the tree begun in, or BVH_NOTHING where the link leads to instances
    uint flags;       // of that instance, INSTANCE_…
    uint pad0;
    GpuBvhGrid grid;  // of the tree begun in
};

LAMPYRIS_SHARED_END

#endif
