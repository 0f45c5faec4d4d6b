#include "overlay/setting_list.h"

#include <array>

namespace lampyris::overlay {

// Ranges are those of the program's options.
std::span<const SettingInfo> settingList() {
    using S = photon_gi::Settings;
    static const std::array list{
        SettingInfo{"pipeline", "", &S::pipeline, 0, 0, false,
                    "full, the yardstick thesis, or direct light alone."},
        SettingInfo{"photons", "paths", &S::photonPaths, 1, 4294967295.0, true,
                    "Paths that leave the lights in a frame: more are calmer, and cost in "
                    "proportion."},
        SettingInfo{"radius", "m", &S::radiusMetres, 1e-6, 1e6, true,
                    "How far a photon's light reaches, and how wide the grid's cells are: smaller "
                    "is sharper and noisier."},
        SettingInfo{"max bounces", "", &S::maxBounces, 0, 255, false,
                    "A path hits at most one surface more; 0 leaves direct light alone."},
        SettingInfo{"gather", "", &S::gather, 0, 0, false,
                    "How indirect light is looked up: photons binned to tiles, or rays into a grid "
                    "of them."},
        SettingInfo{"gather divisor", "pixels", &S::gatherDivisor, 1, 16, false,
                    "Indirect light is gathered once for so many pixels an axis."},
        SettingInfo{"gather rays", "a texel", &S::gatherRays, 1, 256, false,
                    "Rays of the final gather: its noise falls with them, its cost grows."},
        SettingInfo{"filter levels", "", &S::filterLevels, 0, 5, false,
                    "Each level of the final gather's filter doubles its width."},
        SettingInfo{"history", "frames", &S::history, 0, 4096, true,
                    "Most frames in the mean of light; what moves is left out of it."},
        SettingInfo{"grid columns", "rays", &S::gridColumns, 1, 64, false,
                    "Rays that measure how much surface lies in a cell of the grid."},
        SettingInfo{"light cutoff", "", &S::lightCutoff, 0, 1e6, true,
                    "Share of the mean direct light under which a light's reach ends; 0: never."},
        SettingInfo{"seed", "", &S::seed, 0, 4294967295.0, false, "Of all random numbers."},
        SettingInfo{"reseed", "", &S::reseed, 0, 0, false, "Paths are drawn anew in every frame."},
        SettingInfo{"retrace", "", &S::retrace, 0, 0, false,
                    "auto keeps what cannot have changed since the frame before."},
        SettingInfo{"guiding", "", &S::guiding, 0, 0, false,
                    "Photons go where earlier frames looked them up."},
        SettingInfo{"shadows", "", &S::shadows, 0, 0, false, "Of direct light."},
        SettingInfo{"shadow divisor", "pixels", &S::shadowDivisor, 1, 16, false,
                    "Wide penumbrae are found once for so many pixels an axis."},
        SettingInfo{"shadow rays", "", &S::shadowRays, 1, 31, false,
                    "A light and low-resolution texel."},
        SettingInfo{"largest batch", "paths", &S::largestBatch, 64, 4294967295.0, true,
                    "Most paths traced in one go; smaller batches take less memory."},
    };
    return list;
}

}  // namespace lampyris::overlay
