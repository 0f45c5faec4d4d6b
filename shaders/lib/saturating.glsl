// Sums that stay at the largest number instead of wrapping: what is too much must look so.
#ifndef LAMPYRIS_LIB_SATURATING
#define LAMPYRIS_LIB_SATURATING

uint saturatingAdd(uint a, uint b) {
    uint sum = a + b;
    return sum < a ? 0xffffffffu : sum;
}

#endif
