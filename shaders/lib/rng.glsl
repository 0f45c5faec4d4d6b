// Random and low-discrepancy numbers on [0, 1).
#ifndef LAMPYRIS_LIB_RNG
#define LAMPYRIS_LIB_RNG

const float kTwoToMinus24 = 1.0 / 16777216.0;

// Tiny Encryption Algorithm as a hash [Thesis 5.3.1; Zafar et al. 2010]. The key is the Thesis's.
uvec2 tea(uvec2 v, int rounds) {
    uint sum = 0u;
    for (int i = 0; i < rounds; ++i) {
        sum += 0x9E3779B9u;
        v.x += ((v.y << 4) + 0xA341316Cu) ^ (v.y + sum) ^ ((v.y >> 5) + 0xC8013EA4u);
        v.y += ((v.x << 4) + 0xAD90777Du) ^ (v.x + sum) ^ ((v.x >> 5) + 0x7E95761Eu);
    }
    return v;
}

// Sixteen rounds for a seed, eight for each draw [Thesis 5.3.1].
uvec2 seedRandom(uint stream, uint seed) { return tea(uvec2(stream, seed), 16); }

vec2 random2(inout uvec2 state) {
    state = tea(state, 8);
    return vec2(state & 0x00FFFFFFu) * kTwoToMinus24;
}

// Van der Corput sequence in base 2.
float radicalInverse2(uint index) { return float(bitfieldReverse(index) >> 8) * kTwoToMinus24; }

vec2 hammersley(uint index, uint count) {
    return vec2((float(index) + 0.5) / float(count), radicalInverse2(index));
}

// Nested uniform scrambling in base 2 by a hash (Owen 1995; Laine and Karras 2011, with Burley's constants of 2020).
uint owenScramble(uint bits, uint seed) {
    bits = bitfieldReverse(bits) + seed;
    bits ^= bits * 0x6c50b47cu;
    bits ^= bits * 0xb82f1e52u;
    bits ^= bits * 0xc7afe638u;
    bits ^= bits * 0x8d22f6e6u;
    return bitfieldReverse(bits);
}

// Point of a scrambled Sobol sequence: any 2^k from a multiple of 2^k on are a (0, k, 2)-net.
vec2 sobol2(uint index, uvec2 seed) {
    uvec2 bits = uvec2(bitfieldReverse(index), 0u);
    for (uint v = 0x80000000u; index != 0u; index >>= 1, v ^= v >> 1) bits.y ^= v * (index & 1u);
    bits = uvec2(owenScramble(bits.x, seed.x), owenScramble(bits.y, seed.y));
    return vec2(bits >> 8) * kTwoToMinus24;
}

// Of a frame: a point shifted by it goes evenly over the unit square, frame by frame (Roberts 2018, R2).
vec2 frameShift(uint frame) {
    // Multiples of 2^32 / 1.3247..., and of that ratio's square: whole numbers lose nothing in long runs.
    return vec2((uvec2(frame) * uvec2(3242174889u, 2447445414u)) >> 8) * kTwoToMinus24;
}

// A texel's number along a Z-order curve.
uint zOrder(uvec2 texel) {
    uvec2 b = texel;
    b = (b | (b << 8)) & 0x00ff00ffu;
    b = (b | (b << 4)) & 0x0f0f0f0fu;
    b = (b | (b << 2)) & 0x33333333u;
    b = (b | (b << 1)) & 0x55555555u;
    return b.x | (b.y << 1);
}

#endif
