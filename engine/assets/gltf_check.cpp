#include "assets/gltf_check.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace lampyris::assets {
namespace {

constexpr std::array<std::string_view, 5> kUnderstood = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_specular",
    "KHR_mesh_quantization", "KHR_texture_transform"};

void checkAsset(const Place& root) {
    if (!root.has("asset")) return root.complain("is no glTF: asset is missing");
    const Place asset = root.object("asset");
    const std::string version = asset.text("version");
    if (asset.ok() && !version.starts_with("2."))
        asset.complain("is of glTF version {}; only 2 is read", version);
    const std::string least = asset.text("minVersion", "2.0");
    if (least != "2.0") asset.complain("needs a reader of glTF version {}", least);
}

void checkExtensions(const Place& root) {
    const size_t count = root.length("extensionsRequired");
    for (size_t i = 0; i < count; ++i) {
        const Place place = root.element("extensionsRequired", i);
        if (!place.json().is_string()) return place.complain("must be a string");
        const std::string& name = place.json().get_ref<const std::string&>();
        if (!understands(name))
            place.complain("the file requires {}, which is not understood", name);
    }
}

}  // namespace

Place lightsExtension(const Place& root) {
    return root.object("extensions").object("KHR_lights_punctual");
}

TableSizes tableSizes(const Place& root) {
    return {.accessors = root.length("accessors"),
            .animations = root.length("animations"),
            .bufferViews = root.length("bufferViews"),
            .cameras = root.length("cameras"),
            .images = root.length("images"),
            .lights = lightsExtension(root).length("lights"),
            .materials = root.length("materials"),
            .meshes = root.length("meshes"),
            .nodes = root.length("nodes"),
            .samplers = root.length("samplers"),
            .scenes = root.length("scenes"),
            .skins = root.length("skins"),
            .textures = root.length("textures")};
}

bool understands(std::string_view extension) {
    return std::find(kUnderstood.begin(), kUnderstood.end(), extension) != kUnderstood.end();
}

core::Result<void> checkHeader(const Json& json, const GltfContext& context) {
    Complaint complaint;
    const Place root(json, complaint);
    checkAsset(root);
    checkExtensions(root);
    if (!root.ok()) return context.error(complaint.place, "{}", complaint.message);
    return {};
}

core::Result<void> checkDocument(const Json& json, const std::vector<GltfBuffer>& buffers,
                                 const GltfContext& context) {
    Complaint complaint;
    const Place root(json, complaint);
    checkData(root, buffers);
    const TableSizes sizes = tableSizes(root);
    checkReferences(root, sizes);
    checkNodes(root, sizes);
    if (!root.ok()) return context.error(complaint.place, "{}", complaint.message);
    return {};
}

}  // namespace lampyris::assets
