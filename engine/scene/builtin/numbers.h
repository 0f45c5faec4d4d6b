/// \file Random numbers and sines with the same bits on every machine and run.
#pragma once

#include <cstdint>

namespace lampyris::scene::builtin {

/// Well-mixed 32 bits of a seed and a counter (the "lowbias32" multiply-xorshift constants).
[[nodiscard]] constexpr uint32_t hashBits(uint32_t seed, uint32_t counter) {
    uint32_t x = seed * 0x9e3779b9u + counter;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Uniform in [0, 1); a multiple of 2⁻²⁴, so exact in a float.
[[nodiscard]] constexpr float hashUnit(uint32_t seed, uint32_t counter) {
    return static_cast<float>(hashBits(seed, counter) >> 8) * 0x1p-24f;
}

/// Uniform in [−1, 1).
[[nodiscard]] constexpr float hashSigned(uint32_t seed, uint32_t counter) {
    return 2.0f * hashUnit(seed, counter) - 1.0f;
}

struct SinCos {
    double sin;
    double cos;
};

/// Sine and cosine of an angle in whole turns, to about 1e-15; additions and products alone, where
/// the C library's differ from one to the next.
[[nodiscard]] SinCos sinCosTurns(double turns);

}  // namespace lampyris::scene::builtin
