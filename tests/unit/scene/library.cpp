#include "scene/library.h"

#include <gtest/gtest.h>

namespace lampyris::scene {
namespace {

TEST(Library, BeginsWithAMattDefaultMaterial) {
    const Library library;
    ASSERT_EQ(library.materials().size(), 1u);
    const assets::Material& material = *library.materials()[kDefaultMaterial.value].value;
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_LT(material.baseColour.x, 1.0f);
}

TEST(Library, VersionsAreNeverUsedTwice) {
    Library library;
    const MeshId mesh = library.addMesh({});
    const MaterialId material = library.addMaterial({});
    const int32_t image = library.addImage({});
    const uint64_t first = library.meshes()[mesh.value].version;
    EXPECT_NE(first, library.materials()[material.value].version);
    EXPECT_NE(first, library.images()[static_cast<size_t>(image)].version);
    const auto kept = library.meshes()[mesh.value].value;
    assets::Mesh other;
    other.name = "other";
    library.replaceMesh(mesh, std::move(other));
    EXPECT_GT(library.meshes()[mesh.value].version, first);
    EXPECT_EQ(library.meshes()[mesh.value].value->name, "other");
    EXPECT_EQ(kept->name, "");
}

}  // namespace
}  // namespace lampyris::scene
