#include <algorithm>
#include <cmath>
#include <limits>

#include "assets/gltf_images.h"
#include "assets/gltf_source.h"

namespace lampyris::assets {
namespace {

using Extensions = tinygltf::ExtensionMap;

/// A number in an extension object, checked to be one where it is there.
double numberIn(const tinygltf::Value& object, const char* key, double fallback) {
    if (!object.IsObject() || !object.Has(key)) return fallback;
    const tinygltf::Value& value = object.Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : fallback;
}

template <int Count>
glm::vec<Count, float> vectorIn(const tinygltf::Value& object, const char* key,
                                glm::vec<Count, float> fallback) {
    if (!object.IsObject() || !object.Has(key)) return fallback;
    const tinygltf::Value& array = object.Get(key);
    for (int c = 0; c < Count; ++c)
        fallback[c] = static_cast<float>(array.Get(c).GetNumberAsDouble());
    return fallback;
}

const tinygltf::Value& extension(const Extensions& extensions, const char* name) {
    static const tinygltf::Value kNone;
    const auto found = extensions.find(name);
    return found == extensions.end() ? kNone : found->second;
}

Wrap wrapOf(int gltfWrap) {
    if (gltfWrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::Clamp;
    if (gltfWrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::Mirror;
    return Wrap::Repeat;
}

/// Reads the materials one after the other; images are decoded when the first texture wants them.
class MaterialReader {
 public:
    MaterialReader(GltfSource& source, ImageReader& images) : source_(source), images_(images) {}

    core::Result<Material> read(const tinygltf::Material& from, const std::string& place,
                                MaterialNeeds& needs) {
        place_ = place;
        needs_ = &needs;
        const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
        Material to;
        to.name = from.name;
        for (int c = 0; c < 4; ++c)
            to.baseColour[c] = unit(pbr.baseColorFactor[static_cast<size_t>(c)]);
        to.metallic = unit(pbr.metallicFactor);
        to.roughness = unit(pbr.roughnessFactor);
        to.doubleSided = from.doubleSided;
        readAlpha(from, to);
        readEmission(from, to);
        readSpecular(from, to);
        TRY_VOID(readTexture(pbr.baseColorTexture, to.baseColourTexture));
        TRY_VOID(readTexture(pbr.metallicRoughnessTexture, to.metallicRoughnessTexture));
        TRY_VOID(readTexture(from.emissiveTexture, to.emissiveTexture));
        TRY_VOID(readTexture(from.normalTexture, to.normalTexture));
        to.normalScale = static_cast<float>(from.normalTexture.scale);
        if (to.normalTexture.present()) needs.tangentSlot = to.normalTexture.texcoordSet;
        return to;
    }

 private:
    static float unit(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

    void readAlpha(const tinygltf::Material& from, Material& to) {
        to.alphaCutoff = static_cast<float>(from.alphaCutoff);
        if (from.alphaMode == "MASK") {
            to.alphaMode = AlphaMode::Mask;
        } else if (from.alphaMode == "BLEND") {
            to.alphaMode = AlphaMode::Blend;
            source_.context.warn(place_, "material {} blends and is drawn opaque", from.name);
        } else if (from.alphaMode != "OPAQUE") {
            source_.context.warn(place_, "has the unknown alphaMode {}", from.alphaMode);
        }
    }

    static void readEmission(const tinygltf::Material& from, Material& to) {
        const double strength = numberIn(
            extension(from.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
        for (size_t c = 0; c < from.emissiveFactor.size() && c < 3; ++c)
            to.emissiveRadiance[static_cast<int>(c)] =
                static_cast<float>(std::clamp(from.emissiveFactor[c] * std::max(strength, 0.0), 0.0,
                                              double{std::numeric_limits<float>::max()}));
    }

    void readSpecular(const tinygltf::Material& from, Material& to) {
        const tinygltf::Value& specular = extension(from.extensions, "KHR_materials_specular");
        if (!specular.IsObject()) return;
        to.specularFactor = unit(numberIn(specular, "specularFactor", 1.0));
        to.specularColour =
            glm::max(vectorIn<3>(specular, "specularColorFactor", glm::vec3(1.0f)), 0.0f);
        if (specular.Has("specularTexture") || specular.Has("specularColorTexture"))
            source_.context.warn(place_, "material {} is drawn without its specular textures",
                                 from.name);
    }

    /// For the three kinds of texture info, which share these members only by name.
    template <typename TextureInfo>
    core::Result<void> readTexture(const TextureInfo& info, TextureUse& use) {
        if (info.index < 0) return {};
        const tinygltf::Texture& texture =
            source_.document.textures[static_cast<size_t>(info.index)];
        if (texture.source < 0) {
            source_.context.warn(place_, "texture {} has no image that can be read", info.index);
            return {};
        }
        TRY(use.image, images_.find(static_cast<size_t>(texture.source)));
        if (!use.present()) return {};
        if (texture.sampler >= 0) {
            const tinygltf::Sampler& sampler =
                source_.document.samplers[static_cast<size_t>(texture.sampler)];
            use.wrapU = wrapOf(sampler.wrapS);
            use.wrapV = wrapOf(sampler.wrapT);
            if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) use.filter = Filter::Nearest;
        }
        chooseTexcoords(info.texCoord, extension(info.extensions, "KHR_texture_transform"), use);
        return {};
    }

    /// Takes a slot for the set and transform; two differing ones fit, which is as many as a mesh
    /// has.
    void chooseTexcoords(int set, const tinygltf::Value& transform, TextureUse& use) {
        const TextureTransform wanted{vectorIn<2>(transform, "offset", glm::vec2(0.0f)),
                                      vectorIn<2>(transform, "scale", glm::vec2(1.0f)),
                                      static_cast<float>(numberIn(transform, "rotation", 0.0))};
        const auto fileSet = static_cast<uint32_t>(numberIn(transform, "texCoord", set));
        const uint32_t likely = fileSet == 1 ? 1 : 0;
        for (const uint32_t slot : {likely, 1 - likely}) {
            TexcoordSlot& known = needs_->slots[slot];
            if (known.used && (known.fileSet != fileSet || !(known.transform == wanted))) continue;
            known = {fileSet, wanted, true};
            use.texcoordSet = slot;
            return;
        }
        use.texcoordSet = likely;
        source_.context.warn(place_,
                             "its textures read more than two sets or transforms of "
                             "texture coordinates; one of those serves the rest");
    }

    GltfSource& source_;
    ImageReader& images_;
    std::string place_;
    MaterialNeeds* needs_ = nullptr;
};

bool someNameNone(const tinygltf::Model& document) {
    for (const tinygltf::Mesh& mesh : document.meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (primitive.material < 0) return true;
    return false;
}

}  // namespace

glm::vec2 TextureTransform::apply(glm::vec2 uv) const {
    if (*this == TextureTransform{}) return uv;
    const float s = std::sin(rotationRadians);
    const float c = std::cos(rotationRadians);
    const glm::vec2 scaled = scale * uv;
    return offset + glm::vec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
}

core::Result<std::vector<MaterialNeeds>> readMaterials(GltfSource& source, Model& model) {
    ImageReader images(source, model);
    MaterialReader reader(source, images);
    const std::vector<tinygltf::Material>& materials = source.document.materials;
    std::vector<MaterialNeeds> needs(materials.size());
    for (size_t i = 0; i < materials.size(); ++i) {
        TRY(Material material,
            reader.read(materials[i], fmt::format("/materials/{}", i), needs[i]));
        model.materials.push_back(std::move(material));
    }
    if (someNameNone(source.document)) {
        model.materials.emplace_back().name = "default";
        needs.emplace_back();
    }
    return needs;
}

}  // namespace lampyris::assets
