#include "deferred/sphere_direct.h"

#include "deferred/shaders.h"
#include "shared/scene.h"

namespace lampyris::deferred {
namespace {

void bindShading(graph::ComputeNode& node, const Surface& surface, const LightLists& lights,
                 const residency::SceneHandles& scene) {
    bindSurfaceMaterial(node, surface);
    node.read(shared::SLOT_LIGHTS, scene.lights)
        .read(shared::SLOT_LIGHT_REACH, lights.reach)
        .read(shared::SLOT_LIGHT_MASKS, lights.masks)
        .specialise(shared::SPEC_ANY_SPECULAR, scene.anySpecular ? 1 : 0);
}

constexpr const char* kIrradiance = "direct irradiance";
constexpr const char* kSpecular = "direct specular";

DirectLight writeLight(graph::Frame& frame, graph::ComputeNode& node, graph::Extent size,
                       Keep keep) {
    const graph::ImageDesc desc{graph::Format::RGBA16Float, size};
    DirectLight direct;
    direct.irradiance =
        node.write(shared::SLOT_IRRADIANCE_DIRECT, keepable(frame, keep, kIrradiance, desc));
    direct.specular =
        node.write(shared::SLOT_SPECULAR_DIRECT, keepable(frame, keep, kSpecular, desc));
    return direct;
}

/// Pixels that trace rays of their own.
struct ShadowList {
    graph::Buffer pixels, count;
};

graph::Buffer addShadowGroups(graph::Frame& frame, const ShadowList& list) {
    auto node = frame.compute("shadow/groups", shaders::shadowGroups);
    node.read(shared::SLOT_SHADOW_LISTED, list.count);
    const graph::Buffer groups = node.write(shared::SLOT_SHADOW_GROUPS,
                                            frame.buffer("shadow groups", {3 * sizeof(uint32_t)}));
    node.dispatch(1);
    return groups;
}

void addListedPixels(graph::Frame& frame, const Surface& surface, const LightLists& lights,
                     const Shadows& shadows, const ShadowList& list,
                     const residency::SceneHandles& scene, const accel::AccelHandles& accel,
                     DirectLight& direct) {
    const graph::Buffer groups = addShadowGroups(frame, list);
    auto node = frame.compute("shadow/edges", shaders::shadowEdges);
    bindShading(node, surface, lights, scene);
    accel::bindTraversal(node, accel, scene);
    node.read(shared::SLOT_SHADOW_LIST, list.pixels)
        .read(shared::SLOT_SHADOW_LISTED, list.count)
        .push(shadows.params);
    direct.irradiance = node.update(shared::SLOT_IRRADIANCE_DIRECT, direct.irradiance);
    direct.specular = node.update(shared::SLOT_SPECULAR_DIRECT, direct.specular);
    node.dispatchIndirect(groups);
}

}  // namespace

DirectLight addUnshadowedDirect(graph::Frame& frame, const Surface& surface,
                                const LightLists& lights, const residency::SceneHandles& scene,
                                Keep keep) {
    const graph::Extent size{surface.view.width, surface.view.height};
    auto node = frame.compute("sphere_direct", shaders::sphereDirectUnshadowed);
    bindShading(node, surface, lights, scene);
    node.push(lights.params);
    const DirectLight direct = writeLight(frame, node, size, keep);
    node.dispatchOver(size);
    return direct;
}

DirectLight recallDirect(graph::Frame& frame, graph::Extent size) {
    const graph::ImageDesc desc{graph::Format::RGBA16Float, size};
    return {kept(frame, kIrradiance, desc), kept(frame, kSpecular, desc)};
}

DirectLight addSphereDirect(graph::Frame& frame, const Surface& surface, const LightLists& lights,
                            const Shadows& shadows, const residency::SceneHandles& scene,
                            const accel::AccelHandles& accel, Keep keep) {
    const graph::Extent size{surface.view.width, surface.view.height};
    auto clear = frame.transfer("shadow/clear");
    ShadowList list;
    list.count = clear.fill(frame.buffer("shadow pixels listed", {sizeof(uint32_t)}), 0);

    auto node = frame.compute("sphere_direct", shaders::sphereDirect);
    bindShading(node, surface, lights, scene);
    node.sample(shared::SLOT_SHADOW_SHARES, shadows.shares)
        .sample(shared::SLOT_SHADOW_GUIDE, shadows.guide)
        .specialise(shared::SPEC_MANY_LIGHTS, shadows.params.maskWords > 1 ? 1 : 0)
        .push(shadows.params);
    DirectLight direct = writeLight(frame, node, size, keep);
    const uint64_t pixels = uint64_t{size.width} * size.height;
    list.pixels = node.write(shared::SLOT_SHADOW_LIST,
                             frame.buffer("shadow pixels", {pixels * 2 * sizeof(uint32_t)}));
    list.count = node.update(shared::SLOT_SHADOW_LISTED, list.count);
    node.dispatchOver({shadows.params.coarseWidth + 1, shadows.params.coarseHeight + 1});
    addListedPixels(frame, surface, lights, shadows, list, scene, accel, direct);
    return direct;
}

}  // namespace lampyris::deferred
