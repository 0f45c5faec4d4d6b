// Which nodes are indirect light's, and of which part.
#include "photon_gi/indirect_cost.h"

#include <gtest/gtest.h>

namespace lampyris::photon_gi {
namespace {

TEST(IndirectCost, CountsAllButSurfacesDirectLightAndUpkeep) {
    execute::FrameStatistics frame;
    for (const char* name : {"gbuffer", "gbuffer_motion", "sphere_direct/cull", "shadow/edges",
                             "composite", "composite/display", "refit_levels/3", "tlas", "skin",
                             "morph", "upload", "overlay/panels"})
        frame.nodes.push_back({name, 1000.0, 0.0});
    frame.nodes.push_back({"photon_trace/store", 1.0, 0.0});
    frame.nodes.push_back({"irradiance_grid", 2.0, 0.0});
    frame.nodes.push_back({"tile_bin/pairs", 4.0, 0.0});
    frame.nodes.push_back({"gather/filter", 8.0, 0.0});
    frame.nodes.push_back({"upsample/edges", 16.0, 0.0});
    const IndirectCost cost = indirectCost(frame);
    EXPECT_EQ(cost.photons, 7.0);
    EXPECT_EQ(cost.gather, 8.0);
    EXPECT_EQ(cost.upsample, 16.0);
    EXPECT_EQ(cost.sum(), 31.0);
}

// Nodes that a program adds between declare() and run() drive no budget, whatever they are called.
TEST(IndirectCost, KnowsNoNodesButItsOwn) {
    execute::FrameStatistics frame;
    for (const char* name : {"fog", "screenshot", "gather_leaves", "upsampled", "photon",
                             "tile_bins", "show/edges", "", "my/gather"})
        frame.nodes.push_back({name, 1000.0, 0.0});
    EXPECT_EQ(indirectCost(frame).sum(), 0.0);
}

}  // namespace
}  // namespace lampyris::photon_gi
