// Read this file first: the frame as a storyboard. Each node is one function in a file of its own
// name.
#include "photon_gi/frame.h"

#include "deferred/show_surface.h"
#include "deferred/sphere_direct.h"
#include "photon_gi/composite.h"
#include "photon_gi/grid_gather.h"
#include "photon_gi/show_light.h"
#include "photon_gi/tile_gather.h"

namespace lampyris::photon_gi {
namespace {

deferred::Keep keepOf(const Settings& s) {
    return keepsUnchanged(s) ? deferred::Keep::Yes : deferred::Keep::No;
}

deferred::DirectLight addDirect(graph::Frame& f, const FrameInputs& in, const Settings& s,
                                const deferred::Surface& surface,
                                const deferred::LightLists& lights) {
    if (in.past.still) return deferred::recallDirect(f, {in.view.width, in.view.height});
    if (!s.shadows || s.pipeline == Pipeline::Thesis)
        return deferred::addUnshadowedDirect(f, surface, lights, in.scene, keepOf(s));
    const deferred::ShadowSettings shadow{s.shadowDivisor, s.shadowRays, s.seed};
    const auto shadows = deferred::addShadow(f, surface, lights, in.scene, in.accel, shadow);
    return deferred::addSphereDirect(f, surface, lights, shadows, in.scene, in.accel, keepOf(s));
}

}  // namespace

DrawnFrame drawFrame(graph::Frame& f, const FrameInputs& in, const Settings& s,
                     const Capacities& room) {
    DrawnFrame out;
    const auto surface = in.past.still
                             ? deferred::recallGBuffer(f, in.view)
                             : deferred::addGBuffer(f, in.view, in.scene, in.draws, keepOf(s));
    const auto bounds = deferred::addTileBounds(f, surface);
    const auto lights =
        deferred::addLightLists(f, surface, bounds, in.scene, s.lightCutoff, in.seed);
    const auto direct = addDirect(f, in, s, surface, lights);

    JoinedIrradiance indirect;
    if (s.pipeline != Pipeline::Direct && s.maxBounces > 0 && in.paths.paths > 0)
        indirect = finalGathers(s) ? addGridGather(f, in, s, room, surface, out)
                                   : addTileGather(f, in, s, room, surface, bounds, out);
    out.insides.view = in.view;
    out.insides.depth = surface.depth;
    out.insides.accel = in.accel;
    out.counters = indirect.edges.counters;

    out.radiance = addComposite(f, surface, direct, indirect.irradiance, lights, in.scene,
                                in.settles ? deferred::Keep::Yes : deferred::Keep::No);
    out.lightReach = lights.reach;
    f.publish(kFinal, out.radiance);
    deferred::publishSurface(f, surface);
    publishLight(f, surface, direct, indirect.irradiance, indirect.edges);
    return out;
}

}  // namespace lampyris::photon_gi
