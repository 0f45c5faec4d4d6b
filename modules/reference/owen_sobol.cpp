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

/// By the index's bytes, lowest first. Numbers and bytes have their bits reversed: scrambling wants
/// the leading bit in the lowest place.
using ByteTable = std::array<std::array<uint32_t, kDimensions>, 256>;
constexpr std::array<ByteTable, kBytes> makeTables() {
    std::array<ByteTable, kBytes> tables{};
    for (uint32_t d = 0; d < kDimensions; ++d) {
        const auto column = columns(kPolynomials[d]);
        for (uint32_t place = 0; place < kBytes; ++place)
            for (uint32_t byte = 0; byte < 256; ++byte)
                for (uint32_t bit = 0; bit < 8; ++bit)
                    if (((byte >> (7 - bit)) & 1u) != 0)
                        tables[place][byte][d] ^= reverseBits(column[8 * place + bit]);
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

}  // namespace

OwenSobol::OwenSobol(uint32_t seed, uint32_t index)
    : seed_(seed), reversedIndex_(reverseBits(index)) {}

glm::vec4 OwenSobol::group(uint32_t number) const {
    const uint32_t seed = mixSeeds(seed_, number);
    // The group's points in an order of its own, which keeps blocks of powers of two together
    // (Burley 2020).
    const uint32_t place = scrambleReversed(reversedIndex_, seed);
    // Loops of four steps: the compiler makes them one of vectors.
    std::array<uint32_t, kDimensions> x{};
    for (uint32_t d = 0; d < kDimensions; ++d)
        x[d] = kTables[0][place >> 24u][d] ^ kTables[1][(place >> 16u) & 255u][d];
    for (uint32_t d = 0; d < kDimensions; ++d) {
        uint32_t own = (seed + (d + 1) * 0x9e3779b9u) * 0x7feb352du;
        own ^= own >> 15u;
        x[d] = reverseBits(scrambleReversed(x[d], own)) >> 8u;
    }
    glm::vec4 result;
    for (uint32_t d = 0; d < kDimensions; ++d)
        result[static_cast<int>(d)] = static_cast<float>(static_cast<int32_t>(x[d])) * 0x1p-24f;
    return result;
}

}  // namespace lampyris::reference
