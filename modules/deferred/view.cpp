#include "deferred/view.h"

namespace lampyris::deferred {

shared::View makeView(const scene::SnapshotCamera& camera, graph::Extent size) {
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    const glm::mat4 projection =
        math::perspectiveReversed(camera.verticalFovRadians, aspect, camera.nearMetres);
    shared::View view{};
    view.viewToWorld = camera.cameraToWorld;
    view.worldToView = glm::inverse(camera.cameraToWorld);
    view.worldToClip = projection * view.worldToView;
    view.projection = {projection[0][0], -projection[1][1], camera.nearMetres, 0.0f};
    view.width = size.width;
    view.height = size.height;
    view.tilesX = size.dividedBy(shared::TILE_PIXELS).width;
    view.tilesY = size.dividedBy(shared::TILE_PIXELS).height;
    return view;
}

}  // namespace lampyris::deferred
