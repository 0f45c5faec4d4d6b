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

// The same in four dimensions (Joe and Kuo 2008): any 2^k are evenly spread, the less so the more dimensions count.
vec4 sobol4(uint index, uvec4 seed) {
    uvec4 bits = uvec4(bitfieldReverse(index), 0u, 0u, 0u);
    uint y = 0x80000000u;                                              // directions: of the bit, and of the next ones
    uvec2 z = uvec2(0x80000000u, 0xC0000000u);
    uvec3 w = uvec3(0x80000000u, 0xC0000000u, 0x20000000u);
    for (; index != 0u; index >>= 1) {
        bits.yzw ^= uvec3(y, z.x, w.x) * (index & 1u);
        y ^= y >> 1;
        z = uvec2(z.y, z.y ^ z.x ^ (z.x >> 2));
        w = uvec3(w.yz, w.y ^ w.x ^ (w.x >> 3));
    }
    for (int i = 0; i < 4; ++i) bits[i] = owenScramble(bits[i], seed[i]);
    return vec4(bits >> 8) * kTwoToMinus24;
}

// What differs from frame to frame where nothing is shared out evenly.
uint turnSeed(uint seed, uint turn) { return seed + turn * 0x85EBCA77u; }

// A texel's number along a Z-order curve.
uint zOrder(uvec2 texel) {
    uvec2 b = texel;
    b = (b | (b << 8)) & 0x00ff00ffu;
    b = (b | (b << 4)) & 0x0f0f0f0fu;
    b = (b | (b << 2)) & 0x33333333u;
    b = (b | (b << 1)) & 0x55555555u;
    return b.x | (b.y << 1);
}

// A texel's number in a frame. A square of 8 x 8 texels has the same 4096 numbers in 64 frames, each once, and 64 that
// are evenly spread among them in each frame; so has a texel of its own in its 64 frames, and nearly so in fewer: the
// frame's Gray code, as all bits of a number count for the second coordinate, where the frame twice would cancel.
uint placeInNet(uvec2 texel, uint frame) {
    uint turn = frame & 63u;
    return (((zOrder(texel >> 3) << 6) | (turn ^ (turn >> 1))) << 6) | (zOrder(texel & 7u) ^ turn);
}

#endif
