/// \file Where all emitted power went, exactly: emitted = absorbed + escaped + in flight +
/// roulette.
#pragma once

#include <span>

#include "math/glm.h"

namespace lampyris::photons {

/// Watts a channel, each added up where it happens and none as a remainder.
struct EnergyLedger {
    glm::dvec3 emitted{0.0};
    glm::dvec3 absorbed{0.0};  ///< Σ (1 − ρ)Φ over all hits
    glm::dvec3 escaped{0.0};   ///< left the scene
    glm::dvec3 inFlight{0.0};  ///< what the last allowed hits would still reflect
    glm::dvec3 roulette{0.0};  ///< killed less added to survivors; signed, of expectation 0

    /// Adds the partial sums that photon_trace wrote, shared::LEDGER_FLOATS a workgroup.
    void add(std::span<const float> partialSums);
    /// Largest |emitted − the rest| over the channels, as a share of the emitted power.
    [[nodiscard]] double relativeError() const;
};

}  // namespace lampyris::photons
