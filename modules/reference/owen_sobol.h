/// \file Well-spread random numbers: Sobol points, Owen-scrambled, in groups of four dimensions.
#pragma once

#include <cstdint>

#include "math/glm.h"

namespace lampyris::reference {

/// Samples a sequence may have before its points repeat.
constexpr uint32_t kLongestSequence = 1u << 16u;

/// Numbers of one sample of one sequence. A group is a set of four dimensions that are spread
/// together; groups are independent of each other (their points are shuffled), so there are as many
/// as a path needs. Equal seeds, indices and groups give equal numbers.
class OwenSobol {
 public:
    OwenSobol(uint32_t seed, uint32_t index);

    /// Four numbers in [0, 1). Of the first two, three or four any power of two of consecutive
    /// samples is well spread.
    [[nodiscard]] glm::vec4 group(uint32_t number) const;

 private:
    uint32_t seed_;
    uint32_t reversedIndex_;  ///< leading bit in the lowest place
};

/// A seed from two numbers, as unlike its neighbours' as chance.
[[nodiscard]] constexpr uint32_t mixSeeds(uint32_t a, uint32_t b) {
    // Wellons' finaliser lowbias32 (2018).
    uint32_t x = a ^ (b * 0x9e3779b9u + 0x7f4a7c15u);
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

}  // namespace lampyris::reference
