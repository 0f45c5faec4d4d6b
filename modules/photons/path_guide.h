/// \file path guide: which ways out of the emitters light what the picture looks up.
///   in      each path's importance in earlier frames      out   a split of the next frame's paths
///   shader  photons/path_importance.comp                  theory  README [P5], [P6]
///
/// Guiding only moves paths between parts of the emitters; a part's power stays its own, over its
/// number of paths. The estimate is therefore unbiased whatever was learned, stale or not.
#pragma once

#include "photons/irradiance_grid.h"

namespace lampyris::photons {

/// Importance of each path of a batch: a float a path, for PathGuide::learn after the frame.
/// \param lookUps how often each slot of the grid was looked up
[[nodiscard]] graph::Buffer addPathImportance(graph::Frame& frame, const PhotonList& photons,
                                              const GridCells& cells, const IrradianceGrid& grid,
                                              graph::Buffer lookUps);

/// What frames past taught about the emitters' parts.
class PathGuide {
 public:
    /// The parts' paths by power and by what was learned of parts of the same emitters.
    [[nodiscard]] PathSplit split(const std::vector<Emitter>& emitters, uint32_t paths);

    /// \param split of the frame, as split() gave it
    /// \param importance of its paths, in order
    void learn(const PathSplit& split, std::span<const float> importance);

 private:
    /// What splitPaths takes; empty before anything was learned.
    [[nodiscard]] std::vector<double> worthOf(const std::vector<EmitterPart>& parts) const;

    struct Layout {
        uint32_t kind, index, sides;
        bool operator==(const Layout&) const = default;
    };
    std::vector<Layout> layout_;   ///< how each emitter is parted
    std::vector<double> squares_;  ///< a part: running mean of importance by one watt's path
    bool learned_ = false;
};

}  // namespace lampyris::photons
