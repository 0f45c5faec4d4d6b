/// \file Well-spread random numbers: Sobol points, Owen-scrambled, in groups of four dimensions.
#pragma once

#include <cstdint>

#include "math/glm.h"

namespace lampyris::reference {

/// Samples a sequence may have before its points repeat.
constexpr uint32_t kLongestSequence = 1u << 16u;

/// Numbers of one sample of one sequence. A group is a set of up to four dimensions that are spread
/// together; groups are independent of each other (their points are shuffled), so there are as many
/// as a path needs. Equal seeds, indices and groups give equal numbers. All are in [0, 1).
class OwenSobol {
 public:
    OwenSobol(uint32_t seed, uint32_t index) : seed_(seed), index_(index) {}

    [[nodiscard]] glm::vec2 two(uint32_t group) const;
    [[nodiscard]] glm::vec3 three(uint32_t group) const;
    [[nodiscard]] glm::vec4 four(uint32_t group) const;

 private:
    uint32_t seed_;
    uint32_t index_;
};

/// A seed from two numbers, as unlike its neighbours' as chance.
[[nodiscard]] uint32_t mixSeeds(uint32_t a, uint32_t b);

}  // namespace lampyris::reference
