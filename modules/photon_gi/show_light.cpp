#include "photon_gi/show_light.h"

#include <string>

#include "photon_gi/shaders.h"
#include "shared/show_light.h"

namespace lampyris::photon_gi {
namespace {

graph::Image shownImage(graph::Frame& frame, const deferred::Surface& surface,
                        const std::string& name) {
    return frame.image(name,
                       {graph::Format::RGBA32Float, {surface.view.width, surface.view.height}});
}

void publish(graph::Frame& frame, const deferred::Surface& surface, const std::string& name,
             uint32_t what, graph::Image irradiance, graph::Image specular) {
    auto node = frame.compute("show/" + name, shaders::showLight);
    deferred::bindSurfaceMaterial(node, surface);
    node.specialise(0, what)
        .sample(shared::SLOT_SHOWN_IRRADIANCE, irradiance)
        .sample(shared::SLOT_SHOWN_SPECULAR, specular);
    frame.publish(name, node.write(shared::SLOT_SHOWN_LIGHT, shownImage(frame, surface, name)));
    node.dispatchOver({surface.view.width, surface.view.height});
}

}  // namespace

void publishLight(graph::Frame& frame, const deferred::Surface& surface,
                  const deferred::DirectLight& direct, graph::Image indirect, graph::Image edges) {
    publish(frame, surface, "direct", shared::SHOW_DIRECT, direct.irradiance, direct.specular);
    publish(frame, surface, "irradiance_direct", shared::SHOW_IRRADIANCE, direct.irradiance,
            direct.specular);
    if (indirect.valid()) {
        publish(frame, surface, "indirect", shared::SHOW_INDIRECT, indirect, direct.specular);
        publish(frame, surface, "irradiance_indirect", shared::SHOW_IRRADIANCE, indirect,
                direct.specular);
    }
    if (edges.valid()) {
        auto node = frame.compute("show/edges", shaders::showEdges);
        node.sample(shared::SLOT_SHOWN_EDGES, edges).uniformData(shared::SLOT_VIEW, surface.view);
        frame.publish("edges",
                      node.write(shared::SLOT_SHOWN_LIGHT, shownImage(frame, surface, "edges")));
        node.dispatchOver({surface.view.width, surface.view.height});
    }
}

}  // namespace lampyris::photon_gi
