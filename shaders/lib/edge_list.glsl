// The list of pixels that take an estimate of their own; an indirect dispatch of 64 threads a group goes over it.
#ifndef LAMPYRIS_LIB_EDGE_LIST
#define LAMPYRIS_LIB_EDGE_LIST
#include "lib/indirect_groups.glsl"
#include "shared/photon.h"
#include "shared/tile_bin.h"

layout(set = 0, binding = SLOT_GATHER_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_GATHER_LIST, std430) readonly buffer List { uint list[]; };

uint listPlace() { return threadInRows(); }
ivec2 listedPixel(uint place) { return ivec2(list[place] & 0xffffu, list[place] >> 16); }

#endif
