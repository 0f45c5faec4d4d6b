/// \file Pictures by formula; known_pairs.py makes the same ones and prints what they must measure.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "evaluation/picture.h"

namespace lampyris::evaluation {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 48;

/// A picture whose display values are formula(x, y, channel), clamped to 0 to 255.
template <typename Formula>
Picture draw(const Formula& formula, uint32_t width = kWidth, uint32_t height = kHeight) {
    core::DisplayImage display{width, height, {}};
    for (int y = 0; std::cmp_less(y, height); ++y)
        for (int x = 0; std::cmp_less(x, width); ++x)
            for (int c = 0; c < 3; ++c)
                display.values.push_back(
                    static_cast<uint8_t>(std::clamp(formula(x, y, c), 0, 255)));
    return fromDisplay("drawn", std::move(display));
}

inline Picture constant(int red, int green, int blue) {
    return draw([=](int, int, int c) { return c == 0 ? red : c == 1 ? green : blue; });
}
inline Picture grey(int value) {
    return constant(value, value, value);
}

inline int ramp(int x, int y, int c) {
    return (3 * x + 2 * y + 50 * c) % 256;
}
inline int noisyRamp(int x, int y, int c) {
    return ramp(x, y, c) + (31 * x + 17 * y + 11 * c) % 41 - 20;
}
inline int checkers(int x, int y, int c) {
    return (x / 8 + y / 8) % 2 == 0 ? 220 - 40 * c : 30 + 20 * c;
}
inline int shiftedCheckers(int x, int y, int c) {
    return checkers(x + 3, y, c);
}
inline int dimCheckers(int x, int y, int c) {
    return checkers(x, y, c) * 3 / 4;
}
/// A white pixel on grey.
inline int dot(int x, int y, int /*c*/) {
    return x == 30 && y == 20 ? 255 : 128;
}

/// The mean of a map, which is the value of all measures but NRMSE.
inline double meanOf(const core::Image& map) {
    double sum = 0.0;
    for (const float value : map.values) sum += value;
    return sum / static_cast<double>(map.values.size());
}

}  // namespace lampyris::evaluation
