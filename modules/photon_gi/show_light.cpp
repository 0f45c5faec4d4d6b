#include "photon_gi/show_light.h"

#include <string>

#include "photon_gi/shaders.h"
#include "shared/show_light.h"
#include "shared/tile_bin.h"

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

/// All zeros.
graph::Image blackImage(graph::Frame& frame, const deferred::Surface& surface,
                        const std::string& name) {
    const uint64_t pixels = uint64_t{surface.view.width} * surface.view.height;
    auto node = frame.transfer("show/no_" + name);
    const graph::Buffer zeros =
        node.fill(frame.buffer("zeros", {pixels * sizeof(shared::vec4)}), 0);
    return node.copyToImage(zeros, 0, shownImage(frame, surface, name));
}

void publishEdges(graph::Frame& frame, const deferred::Surface& surface, const EdgeList& edges) {
    auto shown = blackImage(frame, surface, "edges");
    auto node = frame.compute("show/edges", shaders::showEdges);
    node.read(shared::SLOT_GATHER_COUNTERS, edges.counters)
        .read(shared::SLOT_GATHER_LIST, edges.list);
    shown = node.update(shared::SLOT_GATHER_EDGES, shown);
    node.dispatchIndirect(edges.groups);
    frame.publish("edges", shown);
}

}  // namespace

void publishLight(graph::Frame& frame, const deferred::Surface& surface,
                  const deferred::DirectLight& direct, graph::Image indirect,
                  const EdgeList& edges) {
    publish(frame, surface, "direct", shared::SHOW_DIRECT, direct.irradiance, direct.specular);
    publish(frame, surface, "irradiance_direct", shared::SHOW_IRRADIANCE, direct.irradiance,
            direct.specular);
    if (!indirect.valid()) {
        for (const char* name : {"indirect", "irradiance_indirect", "edges"})
            frame.publish(name, blackImage(frame, surface, name));
        return;
    }
    publish(frame, surface, "indirect", shared::SHOW_INDIRECT, indirect, direct.specular);
    publish(frame, surface, "irradiance_indirect", shared::SHOW_IRRADIANCE, indirect,
            direct.specular);
    publishEdges(frame, surface, edges);
}

}  // namespace lampyris::photon_gi
