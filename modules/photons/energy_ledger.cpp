#include "photons/energy_ledger.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/photon.h"

namespace lampyris::photons {

void EnergyLedger::add(std::span<const float> partialSums) {
    const std::array<glm::dvec3*, 5> accounts{&emitted, &absorbed, &escaped, &inFlight, &roulette};
    for (size_t group = 0; group + shared::LEDGER_FLOATS <= partialSums.size();
         group += shared::LEDGER_FLOATS)
        for (size_t account = 0; account < accounts.size(); ++account)
            for (int channel = 0; channel < 3; ++channel)
                (*accounts[account])[channel] += static_cast<double>(
                    partialSums[group + account * 3 + static_cast<size_t>(channel)]);
}

double EnergyLedger::relativeError() const {
    const glm::dvec3 left = emitted - (absorbed + escaped + inFlight + roulette);
    double worst = 0.0;
    for (int channel = 0; channel < 3; ++channel)
        if (emitted[channel] > 0.0)
            worst = std::max(worst, std::abs(left[channel]) / emitted[channel]);
    return worst;
}

}  // namespace lampyris::photons
