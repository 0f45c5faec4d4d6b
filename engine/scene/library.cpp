#include "scene/library.h"

#include "core/check.h"

namespace lampyris::scene {

namespace {

std::shared_ptr<const PoseExtents> extentsWhereDeformed(const assets::Mesh& mesh) {
    if (mesh.joints.empty() && mesh.morphTargets.empty()) return nullptr;
    return std::make_shared<const PoseExtents>(poseExtents(mesh));
}

}  // namespace

Library::Library() {
    assets::Material plain;
    plain.name = "default";
    plain.baseColour = glm::vec4(glm::vec3(0.8f), 1.0f);
    plain.metallic = 0.0f;
    addMaterial(std::move(plain));
}

MeshId Library::addMesh(assets::Mesh mesh) {
    extents_.push_back(extentsWhereDeformed(mesh));
    meshes_.push_back({std::make_shared<const assets::Mesh>(std::move(mesh)), ++lastVersion_});
    return {static_cast<uint32_t>(meshes_.size() - 1)};
}

MaterialId Library::addMaterial(assets::Material material) {
    materials_.push_back(
        {std::make_shared<const assets::Material>(std::move(material)), ++lastVersion_});
    return {static_cast<uint32_t>(materials_.size() - 1)};
}

int32_t Library::addImage(assets::TextureImage image) {
    images_.push_back(
        {std::make_shared<const assets::TextureImage>(std::move(image)), ++lastVersion_});
    return static_cast<int32_t>(images_.size() - 1);
}

ClipId Library::addClip(assets::Animation clip) {
    clips_.push_back(std::make_shared<const assets::Animation>(std::move(clip)));
    return {static_cast<uint32_t>(clips_.size() - 1)};
}

void Library::replaceMesh(MeshId id, assets::Mesh mesh) {
    CHECK(id.value < meshes_.size());
    extents_[id.value] = extentsWhereDeformed(mesh);
    meshes_[id.value] = {std::make_shared<const assets::Mesh>(std::move(mesh)), ++lastVersion_};
}

void Library::replaceMaterial(MaterialId id, assets::Material material) {
    CHECK(id.value < materials_.size());
    materials_[id.value] = {std::make_shared<const assets::Material>(std::move(material)),
                            ++lastVersion_};
}

}  // namespace lampyris::scene
