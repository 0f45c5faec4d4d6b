/// \file Materials and textures as glTF 2.0 has them (metallic-roughness).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "math/glm.h"

namespace lampyris::assets {

/// 8-bit RGBA pixels as stored in the file (no colour conversion), from the top left.
struct TextureImage {
    std::string name;
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;  ///< width · height · 4
};

enum class Wrap : uint8_t { Repeat, Clamp, Mirror };
enum class Filter : uint8_t { Nearest, Linear };

/// How a material looks an image up. Bilinear at the base level: no mipmaps, as rays have no
/// footprint.
struct TextureUse {
    int32_t image = -1;  ///< index into the images of the model or snapshot; −1 is none
    uint32_t texcoordSet = 0;
    Wrap wrapU = Wrap::Repeat;
    Wrap wrapV = Wrap::Repeat;
    Filter filter = Filter::Linear;

    [[nodiscard]] bool present() const { return image >= 0; }
};

enum class AlphaMode : uint8_t { Opaque, Mask, Blend };

struct Material {
    std::string name;
    glm::vec4 baseColour{1.0f};  ///< linear RGBA
    float metallic = 1.0f;
    float roughness = 1.0f;
    glm::vec3 emissiveRadiance{
        0.0f};  ///< factor · emissive strength, W/(m²·sr); times its sRGB texture
    float normalScale = 1.0f;
    float specularFactor = 1.0f;  ///< KHR_materials_specular; 0 is Lambertian
    glm::vec3 specularColour{1.0f};
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    TextureUse baseColourTexture;         ///< sRGB
    TextureUse metallicRoughnessTexture;  ///< linear; roughness in G, metallic in B
    TextureUse emissiveTexture;           ///< sRGB
    TextureUse normalTexture;             ///< linear, tangent space

    [[nodiscard]] bool textured() const {
        return baseColourTexture.present() || metallicRoughnessTexture.present() ||
               emissiveTexture.present() || normalTexture.present();
    }
};

}  // namespace lampyris::assets
