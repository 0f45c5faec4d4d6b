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

#endif
