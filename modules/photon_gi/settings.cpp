#include "photon_gi/settings.h"

#include <algorithm>

namespace lampyris::photon_gi {

void mend(Settings& settings) {
    if (settings.pipeline != Pipeline::Thesis) return;
    settings.gather = Gather::Tiles;
    settings.maxBounces = std::min(settings.maxBounces, 1u);
}

bool meanGoesOn(Settings before, const Settings& now) {
    before.photonPaths = now.photonPaths;
    before.radiusMetres = now.radiusMetres;  // another bias, which leaves the mean as light does
    before.gatherRays = now.gatherRays;
    before.filterLevels = now.filterLevels;  // what filters the mean is not in it
    before.gridColumns = now.gridColumns;
    before.history = now.history;
    before.largestBatch = now.largestBatch;
    return before == now;
}

bool pathsGoOn(Settings before, const Settings& now) {
    before.radiusMetres = now.radiusMetres;
    before.gatherDivisor = now.gatherDivisor;
    before.gatherRays = now.gatherRays;
    before.filterLevels = now.filterLevels;
    before.gridColumns = now.gridColumns;
    before.history = now.history;
    before.largestBatch = now.largestBatch;  // kept paths are one batch
    before.lightCutoff = now.lightCutoff;
    before.shadows = now.shadows;
    before.shadowDivisor = now.shadowDivisor;
    before.shadowRays = now.shadowRays;
    return before == now;
}

bool sameDirectLight(const Settings& a, const Settings& b) {
    return a.pipeline == b.pipeline && a.lightCutoff == b.lightCutoff && a.seed == b.seed &&
           a.shadows == b.shadows && a.shadowDivisor == b.shadowDivisor &&
           a.shadowRays == b.shadowRays && keepsUnchanged(a) == keepsUnchanged(b);
}

uint32_t frameSeed(const Settings& settings, uint64_t frameNumber) {
    if (!settings.reseed) return settings.seed;
    // One odd multiplier each, so that neighbouring frames and seeds share nothing (the hash proper
    // is TEA's).
    return settings.seed * 0x9E3779B1u + static_cast<uint32_t>(frameNumber) * 0x85EBCA77u;
}

}  // namespace lampyris::photon_gi
