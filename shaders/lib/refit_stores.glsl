// Where the refit nodes write. LARGE: for trees that no storage buffer holds.
#ifndef LAMPYRIS_LIB_REFIT_STORES
#define LAMPYRIS_LIB_REFIT_STORES
#include "shared/refit.h"

// [measured] Stores to storage buffers take half the time of stores to texels; but devices bound their size.
#ifdef LARGE
layout(set = 0, binding = SLOT_REFIT_NEW_NODES, rgba32ui) uniform writeonly uimageBuffer newNodes;
void putNode(uint texel, uvec4 node) { imageStore(newNodes, int(texel), node); }
#else
layout(set = 0, binding = SLOT_REFIT_NEW_NODES, std430) writeonly buffer NewNodes { uvec4 newNodes[]; };
void putNode(uint texel, uvec4 node) { newNodes[texel] = node; }
#endif

#endif
