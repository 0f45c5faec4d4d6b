#include "reference/owen_sobol.h"

#include <array>

namespace lampyris::reference {
namespace {

constexpr uint32_t kDimensions = 4;
constexpr uint32_t kBytes = 2;  // of an index: kLongestSequence points

constexpr uint32_t reverseBits(uint32_t x) {
    x = (x << 16u) | (x >> 16u);
    x = ((x & 0x00ff00ffu) << 8u) | ((x & 0xff00ff00u) >> 8u);
    x = ((x & 0x0f0f0f0fu) << 4u) | ((x & 0xf0f0f0f0u) >> 4u);
    x = ((x & 0x33333333u) << 2u) | ((x & 0xccccccccu) >> 2u);
    return ((x & 0x55555555u) << 1u) | ((x & 0xaaaaaaaau) >> 1u);
}

/// Direction numbers of Joe and Kuo (2008): degree and inner coefficients of the dimension's
/// primitive polynomial, and its first odd numbers.
struct Polynomial {
    uint32_t degree, coefficients;
    std::array<uint32_t, 3> first;
};
constexpr std::array<Polynomial, kDimensions> kPolynomials{
    {{0, 0, {}}, {1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};

constexpr std::array<uint32_t, 8 * kBytes> columns(const Polynomial& p) {
    std::array<uint32_t, 8 * kBytes> v{};
    for (uint32_t i = 0; i < v.size(); ++i) {
        if (p.degree == 0) {
            v[i] = 1u << (31u - i);
        } else if (i < p.degree) {
            v[i] = p.first[i] << (31u - i);
        } else {
            v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
            for (uint32_t k = 1; k < p.degree; ++k)
                if (((p.coefficients >> (p.degree - 1 - k)) & 1u) != 0) v[i] ^= v[i - k];
        }
    }
    return v;
}

/// By the index's bytes, bits reversed: scrambling wants the leading bit in the lowest place.
using ByteTable = std::array<uint32_t, 256>;
constexpr std::array<std::array<ByteTable, kBytes>, kDimensions> makeTables() {
    std::array<std::array<ByteTable, kBytes>, kDimensions> tables{};
    for (uint32_t d = 0; d < kDimensions; ++d) {
        const auto column = columns(kPolynomials[d]);
        for (uint32_t place = 0; place < kBytes; ++place)
            for (uint32_t byte = 0; byte < 256; ++byte)
                for (uint32_t bit = 0; bit < 8; ++bit)
                    if (((byte >> bit) & 1u) != 0)
                        tables[d][place][byte] ^= reverseBits(column[8 * place + bit]);
    }
    return tables;
}
constexpr auto kTables = makeTables();

/// Flips each bit by a hash of the bits below it: an Owen scramble of reversed numbers (Laine and
/// Karras 2011, constants by Vegdahl 2021).
uint32_t scrambleReversed(uint32_t x, uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// The place of a sample in a group's own order, which keeps blocks of powers of two together
/// (Burley 2020).
uint32_t shuffled(uint32_t index, uint32_t groupSeed) {
    return reverseBits(scrambleReversed(reverseBits(index), groupSeed)) & (kLongestSequence - 1);
}

float number(uint32_t place, uint32_t dimension, uint32_t groupSeed) {
    const auto& table = kTables[dimension];
    const uint32_t reversed = table[0][place & 255u] ^ table[1][place >> 8u];
    const uint32_t seed = mixSeeds(groupSeed, dimension + 1);
    return static_cast<float>(reverseBits(scrambleReversed(reversed, seed)) >> 8u) * 0x1p-24f;
}

}  // namespace

uint32_t mixSeeds(uint32_t a, uint32_t b) {
    // Rounds of a 32-bit finaliser (Wellons 2018, lowbias32).
    uint32_t x = a ^ (b * 0x9e3779b9u + 0x7f4a7c15u);
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

glm::vec2 OwenSobol::two(uint32_t group) const {
    const uint32_t seed = mixSeeds(seed_, group);
    const uint32_t place = shuffled(index_, seed);
    return {number(place, 0, seed), number(place, 1, seed)};
}

glm::vec3 OwenSobol::three(uint32_t group) const {
    const uint32_t seed = mixSeeds(seed_, group);
    const uint32_t place = shuffled(index_, seed);
    return {number(place, 0, seed), number(place, 1, seed), number(place, 2, seed)};
}

glm::vec4 OwenSobol::four(uint32_t group) const {
    const uint32_t seed = mixSeeds(seed_, group);
    const uint32_t place = shuffled(index_, seed);
    return {number(place, 0, seed), number(place, 1, seed), number(place, 2, seed),
            number(place, 3, seed)};
}

}  // namespace lampyris::reference
