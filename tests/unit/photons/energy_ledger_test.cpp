#include "photons/energy_ledger.h"

#include <gtest/gtest.h>

#include <vector>

#include "shared/photon.h"

namespace lampyris::photons {
namespace {

TEST(EnergyLedger, AddsWorkgroupsAndChannels) {
    std::vector<float> partial(2 * shared::LEDGER_FLOATS, 0.0f);
    for (size_t group = 0; group < 2; ++group)
        for (size_t i = 0; i < 15; ++i)
            partial[group * shared::LEDGER_FLOATS + i] = static_cast<float>(i + 1 + 100 * group);
    EnergyLedger ledger;
    ledger.add(partial);
    EXPECT_EQ(ledger.emitted, glm::dvec3(102, 104, 106));
    EXPECT_EQ(ledger.absorbed, glm::dvec3(108, 110, 112));
    EXPECT_EQ(ledger.roulette, glm::dvec3(126, 128, 130));
}

TEST(EnergyLedger, RelativeErrorSeesAMissingShare) {
    EnergyLedger ledger;
    ledger.emitted = {10.0, 10.0, 0.0};
    ledger.absorbed = {6.0, 6.0, 0.0};
    ledger.escaped = {3.0, 3.0, 0.0};
    ledger.inFlight = {1.5, 1.0, 0.0};
    ledger.roulette = {-0.5, 0.0, 0.0};
    EXPECT_NEAR(ledger.relativeError(), 0.0, 1e-12);
    ledger.escaped.y = 2.0;
    EXPECT_NEAR(ledger.relativeError(), 0.1, 1e-12);
}

}  // namespace
}  // namespace lampyris::photons
