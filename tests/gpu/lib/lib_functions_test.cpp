// shaders/lib against plain C++: the same bits for integers, closed forms and integrals for the
// rest.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "execute/executor.h"
#include "lib_test/shaders.h"
#include "math/glm.h"
#include "support/gpu_test.h"

namespace lampyris {
namespace {

struct Row {
    glm::vec4 radicalTea;
    glm::vec4 direction;
    glm::vec4 unpacked;
    glm::vec4 exponent;
    glm::vec4 sobol;
    glm::vec4 sobol4;
};

constexpr uint32_t kCount = 1u << 16;

class LibFunctions : public test::GpuTest {
 protected:
    static std::vector<Row> rows() {
        auto executor = test::need(execute::Executor::create(device()));
        graph::Frame frame;
        auto node = frame.compute("lib functions", lib_test::shaders::libFunctions);
        const auto out = node.write(0, frame.buffer("rows", {uint64_t{kCount} * sizeof(Row)}));
        node.push(kCount).dispatch(kCount / 64);
        frame.output(out);
        execute::RunOptions options;
        options.readBackBuffers = {out};
        return test::valuesOf<Row>(test::need(executor.run(frame, options)).buffers[0]);
    }
};

/// Bit by bit: the digits of the index in base 2, mirrored at the point.
double radicalInverse(uint32_t index) {
    double value = 0.0;
    for (double digit = 0.5; index != 0; index >>= 1, digit *= 0.5)
        if ((index & 1u) != 0) value += digit;
    return value;
}

std::array<uint32_t, 2> teaOf(uint32_t v0, uint32_t v1, int rounds) {
    uint32_t sum = 0;
    for (int i = 0; i < rounds; ++i) {
        sum += 0x9E3779B9u;
        v0 += ((v1 << 4) + 0xA341316Cu) ^ (v1 + sum) ^ ((v1 >> 5) + 0xC8013EA4u);
        v1 += ((v0 << 4) + 0xAD90777Du) ^ (v0 + sum) ^ ((v0 >> 5) + 0x7E95761Eu);
    }
    return {v0, v1};
}

/// ∫ over the cap of half-angle σ about a direction at θ of max(cos, 0)/π, by a fine midpoint rule.
double formFactor(double cosTheta, double sinSigma2) {
    const double cosSigma = std::sqrt(1.0 - sinSigma2);
    const double sinTheta = std::sqrt(std::max(0.0, 1.0 - cosTheta * cosTheta));
    constexpr int kSteps = 400;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = cosSigma + (1.0 - cosSigma) * (i + 0.5) / kSteps;
        const double s = std::sqrt(1.0 - z * z);
        for (int j = 0; j < kSteps; ++j)
            sum += std::max(
                0.0, z * cosTheta + s * sinTheta * std::cos(2.0 * M_PI * (j + 0.5) / kSteps));
    }
    return sum * 2.0 * (1.0 - cosSigma) / (kSteps * static_cast<double>(kSteps));
}

TEST_F(LibFunctions, AgreeWithPlainArithmetic) {
    const auto all = rows();
    double cosines = 0.0;
    glm::dvec3 mean(0.0);
    for (uint32_t i = 0; i < kCount; ++i) {
        const Row& row = all[i];
        ASSERT_EQ(static_cast<double>(row.radicalTea.x), radicalInverse(i)) << i;
        const auto hashed = teaOf(i, 77, 16);
        ASSERT_EQ(std::bit_cast<uint32_t>(row.radicalTea.y), hashed[0] & 0x3fffffffu);
        ASSERT_EQ(std::bit_cast<uint32_t>(row.radicalTea.z), hashed[1] & 0x3fffffffu);
        const glm::vec3 direction(row.direction);
        ASSERT_NEAR(glm::length(direction), 1.0f, 1e-5f);
        ASSERT_LT(glm::distance(direction, glm::vec3(row.unpacked)), 1e-4f);
        ASSERT_GE(row.unpacked.w, 0.0f);
        cosines += static_cast<double>(row.unpacked.w);
        mean += glm::dvec3(direction);
        // Half a step of the nine bits that the largest channel has.
        for (int c = 0; c < 3; ++c) ASSERT_LE(std::abs(row.exponent[c]), row.exponent.w / 511.0f);
    }
    EXPECT_NEAR(cosines / kCount, 2.0 / 3.0, 0.003);  // E[cos] under a cosine-weighted density
    EXPECT_LT(glm::length(mean) / kCount, 1e-3);
}

TEST_F(LibFunctions, AlignedRunsOfSobolPointsAreNets) {
    constexpr uint32_t kBits = 8;
    constexpr uint32_t kRun = 1u << kBits;
    const auto all = rows();
    for (uint32_t first = 0; first < 16 * kRun; first += kRun)
        for (uint32_t bitsX = 0; bitsX <= kBits; ++bitsX) {
            // Boxes of 2^-bitsX by 2^(bitsX - 8): one point each.
            std::array<uint32_t, kRun> hits{};
            for (uint32_t i = first; i < first + kRun; ++i) {
                const auto x = static_cast<uint32_t>(std::ldexp(all[i].sobol.x, int(bitsX)));
                const auto y =
                    static_cast<uint32_t>(std::ldexp(all[i].sobol.y, int(kBits - bitsX)));
                ASSERT_LT((x << (kBits - bitsX)) + y, kRun);
                ++hits[(x << (kBits - bitsX)) + y];
            }
            for (const uint32_t count : hits) ASSERT_EQ(count, 1u) << first << ", " << bitsX;
        }
}

/// How many of 2^bits equal parts of the unit interval the values fall into.
template <typename Values>
size_t partsHit(const Values& values, int bits) {
    std::set<uint32_t> parts;
    for (const float value : values) parts.insert(static_cast<uint32_t>(std::ldexp(value, bits)));
    return parts.size();
}

TEST_F(LibFunctions, SobolPointsOfFourDimensionsAreEvenInEach) {
    const auto all = rows();
    constexpr uint32_t kRun = 256;
    for (uint32_t first = 0; first < kCount; first += kRun)
        for (int d = 0; d < 4; ++d) {
            std::vector<float> values;
            for (uint32_t i = first; i < first + kRun; ++i) values.push_back(all[i].sobol4[d]);
            ASSERT_EQ(partsHit(values, 8), kRun) << first << ", " << d;
        }
    for (uint32_t i = 0; i < kCount; ++i)
        ASSERT_EQ(glm::vec2(all[i].sobol4), glm::vec2(all[i].sobol));
}

TEST_F(LibFunctions, SobolPointsOfFourDimensionsAreEvenInAllAtOnce) {
    const auto all = rows();
    constexpr uint32_t kRun = 4096;  // boxes of an eighth a side
    for (uint32_t first = 0; first < kCount; first += kRun) {
        std::set<std::array<int, 4>> boxes;
        for (uint32_t i = first; i < first + kRun; ++i) {
            const glm::ivec4 box(8.0f * all[i].sobol4);
            boxes.insert({box.x, box.y, box.z, box.w});
        }
        EXPECT_EQ(boxes.size(), kRun) << first;
    }
}

TEST_F(LibFunctions, TexelsOfASquareShareANetOverFrames) {
    const auto all = rows();
    const auto placeOf = [&](uint32_t texel, uint32_t frame) {
        return std::bit_cast<uint32_t>(all[(frame << 6u) | texel].sobol.w);
    };
    std::set<uint32_t> places;
    for (uint32_t frame = 0; frame < 64; ++frame) {
        std::set<uint32_t> ofFrame;
        for (uint32_t texel = 0; texel < 64; ++texel) ofFrame.insert(placeOf(texel, frame) / 64);
        EXPECT_EQ(ofFrame.size(), 1u);  // 64 that follow each other: a net of their own
        for (uint32_t texel = 0; texel < 64; ++texel) places.insert(placeOf(texel, frame));
    }
    EXPECT_EQ(places.size(), 4096u);
    // A texel goes through the first coordinate, in few frames already.
    for (uint32_t texel = 0; texel < 64; ++texel)
        for (uint32_t first = 0; first < 64; first += 16) {
            std::vector<float> x;
            for (uint32_t frame = first; frame < first + 16; ++frame)
                x.push_back(all[placeOf(texel, frame)].sobol.x);
            EXPECT_EQ(partsHit(x, 4), 16u) << texel << ", " << first;
        }
}

TEST_F(LibFunctions, ZOrderInterleavesTheBitsOfBothPlaces) {
    const auto all = rows();
    for (uint32_t i = 0; i < kCount; ++i) {
        uint32_t expected = 0;
        for (uint32_t bit = 0; bit < 8; ++bit)
            expected |= ((i >> bit) & 1u) << (2 * bit) | ((i >> (8 + bit)) & 1u) << (2 * bit + 1);
        ASSERT_EQ(std::bit_cast<uint32_t>(all[i].sobol.z), expected);
    }
}

TEST_F(LibFunctions, SphereFormFactorIsTheIntegralOverItsCap) {
    const auto all = rows();
    for (uint32_t i = 0; i < 101u * 50u; i += 17) {
        const double cosTheta = static_cast<double>(i % 101u) / 50.0 - 1.0;
        const double sinSigma2 = (static_cast<double>(i / 101u % 50u) + 0.5) / 50.0;
        ASSERT_NEAR(static_cast<double>(all[i].direction.w), formFactor(cosTheta, sinSigma2), 2e-3)
            << "cos " << cosTheta << " sin² " << sinSigma2;
    }
}

}  // namespace
}  // namespace lampyris
