#include <array>

#include "assets/gltf_check.h"

namespace lampyris::assets {
namespace {

constexpr uint64_t kLastPrimitiveMode = 6;  // triangle fan
constexpr uint64_t kLastTexcoordSet = 255;  // [chosen] far beyond any exporter

void checkTextureInfo(const Place& owner, const char* key, const TableSizes& sizes) {
    if (!owner.has(key)) return;
    const Place place = owner.object(key);
    place.requiredIndex("index", sizes.textures);
    (void)place.number("scale", 1.0);
    const Place transform = place.object("extensions").object("KHR_texture_transform");
    transform.numbers("offset", 2);
    transform.numbers("scale", 2);
    (void)transform.number("rotation", 0.0);
    for (const Place& chooser : {place, transform})
        if (chooser.whole("texCoord", 0) > kLastTexcoordSet)
            chooser.complain("reads TEXCOORD_{}", chooser.whole("texCoord", 0));
}

void checkMaterial(const Place& place, const TableSizes& sizes) {
    const Place pbr = place.object("pbrMetallicRoughness");
    pbr.numbers("baseColorFactor", 4);
    (void)pbr.number("metallicFactor", 1.0);
    (void)pbr.number("roughnessFactor", 1.0);
    checkTextureInfo(pbr, "baseColorTexture", sizes);
    checkTextureInfo(pbr, "metallicRoughnessTexture", sizes);
    checkTextureInfo(place, "normalTexture", sizes);
    checkTextureInfo(place, "occlusionTexture", sizes);
    checkTextureInfo(place, "emissiveTexture", sizes);
    place.numbers("emissiveFactor", 3);
    (void)place.text("alphaMode", "OPAQUE");
    (void)place.number("alphaCutoff", 0.5);
    const Place extensions = place.object("extensions");
    (void)extensions.object("KHR_materials_emissive_strength").number("emissiveStrength", 1.0);
    const Place specular = extensions.object("KHR_materials_specular");
    (void)specular.number("specularFactor", 1.0);
    specular.numbers("specularColorFactor", 3);
}

/// An object whose members are all accessors.
void checkAttributes(const Place& place, size_t accessors) {
    for (const auto& [name, value] : place.json().items()) place.index(name.c_str(), accessors);
}

void checkIndices(const Place& place, std::optional<uint32_t> accessor, const Place& root) {
    if (accessor && !root.element("accessors", *accessor).has("bufferView"))
        place.complain("its indices, accessor {}, have no bufferView", *accessor);
}

void checkPrimitive(const Place& place, const TableSizes& sizes, const Place& root) {
    if (!place.has("attributes")) place.complain("attributes is missing");
    checkAttributes(place.object("attributes"), sizes.accessors);
    checkIndices(place, place.index("indices", sizes.accessors), root);
    place.index("material", sizes.materials);
    const uint64_t mode = place.whole("mode", 4);
    if (mode > kLastPrimitiveMode) place.complain("has the unknown mode {}", mode);
    place.each("targets", [&](const Place& target) { checkAttributes(target, sizes.accessors); });
}

void checkAnimation(const Place& place, const TableSizes& sizes) {
    const size_t samplers = place.length("samplers");
    place.each("samplers", [&](const Place& sampler) {
        sampler.requiredIndex("input", sizes.accessors);
        sampler.requiredIndex("output", sizes.accessors);
        (void)sampler.text("interpolation", "LINEAR");
    });
    place.each("channels", [&](const Place& channel) {
        channel.requiredIndex("sampler", samplers);
        if (!channel.has("target")) channel.complain("target is missing");
        const Place target = channel.object("target");
        target.index("node", sizes.nodes);
        (void)target.text("path");
    });
}

void checkCamera(const Place& place) {
    const std::string type = place.text("type");
    if (type != "perspective" && type != "orthographic")
        return place.complain("has the unknown type {}", type);
    if (!place.has(type.c_str())) return place.complain("{} is missing", type);
    const Place lens = place.object(type.c_str());
    if (type == "orthographic") {
        for (const char* key : {"xmag", "ymag", "zfar", "znear"}) (void)lens.number(key);
        return;
    }
    const double fov = lens.number("yfov");
    if (lens.ok() && (fov <= 0.0 || fov >= 3.14159))
        lens.complain("has a yfov of {}, which is not between 0 and pi", fov);
    if (lens.number("znear") <= 0.0) lens.complain("has a znear that is not above 0");
    (void)lens.number("zfar", 1.0);
    (void)lens.number("aspectRatio", 1.0);
}

void checkLight(const Place& place) {
    const std::string type = place.text("type");
    if (type != "point" && type != "spot" && type != "directional")
        return place.complain("has the unknown type {}", type);
    if (type == "spot" && !place.has("spot")) place.complain("spot is missing");
    place.numbers("color", 3, false);
    for (const char* key : {"intensity", "range"}) {
        if (place.number(key, 1.0) < 0.0) place.complain("has a negative {}", key);
    }
    const Place spot = place.object("spot");
    for (const char* key : {"innerConeAngle", "outerConeAngle"}) {
        const double angle = spot.number(key, 0.1);
        if (angle < 0.0 || angle > 1.5708) spot.complain("has an {} of {}", key, angle);
    }
}

}  // namespace

void checkReferences(const Place& root, const TableSizes& sizes) {
    root.each("samplers", [](const Place& place) {
        for (const char* key : {"magFilter", "minFilter", "wrapS", "wrapT"})
            (void)place.whole(key, 0);
    });
    root.each("textures", [&](const Place& place) {
        place.index("sampler", sizes.samplers);
        place.index("source", sizes.images);
    });
    root.each("materials", [&](const Place& place) { checkMaterial(place, sizes); });
    root.each("meshes", [&](const Place& place) {
        place.each("primitives",
                   [&](const Place& primitive) { checkPrimitive(primitive, sizes, root); });
        place.numbers("weights", 0);
    });
    root.each("animations", [&](const Place& place) { checkAnimation(place, sizes); });
    root.each("cameras", checkCamera);
    lightsExtension(root).each("lights", checkLight);
}

}  // namespace lampyris::assets
