// The range of paths that a path belongs to.
#ifndef LAMPYRIS_LIB_PATH_RANGE
#define LAMPYRIS_LIB_PATH_RANGE
#include "shared/photon.h"

layout(set = 0, binding = SLOT_PATH_RANGES, std430) readonly buffer Ranges { PathRange ranges[]; };

uint rangeIndexOf(uint path, uint rangeCount) {
    uint low = 0u, high = rangeCount - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (ranges[middle].firstPath <= path) low = middle;
        else high = middle - 1u;
    }
    return low;
}

#endif
