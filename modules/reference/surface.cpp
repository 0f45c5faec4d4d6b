#include "reference/surface.h"

#include <algorithm>
#include <cmath>

#include "reference/texture.h"

namespace lampyris::reference {
namespace {

glm::vec4 texel(const MeshPoint& point, const assets::TextureUse& use, Encoding encoding,
                const glm::vec4& absent) {
    if (!use.present()) return absent;
    const auto& image = *(*point.placed->images)[static_cast<size_t>(use.image)].value;
    return lookUp(image, use, point.texcoords(use.texcoordSet), encoding);
}

glm::vec4 baseColour(const MeshPoint& point) {
    const assets::Material& material = *point.placed->material;
    return material.baseColour * point.mix(point.placed->mesh->colours, glm::vec4(1.0f)) *
           texel(point, material.baseColourTexture, Encoding::Srgb, glm::vec4(1.0f));
}

/// x roughness, y metallic.
glm::vec2 roughnessMetallic(const MeshPoint& point) {
    const assets::Material& material = *point.placed->material;
    const glm::vec4 packed =
        texel(point, material.metallicRoughnessTexture, Encoding::Linear, glm::vec4(1.0f));
    return {material.roughness * packed.g, material.metallic * packed.b};
}

/// `otherwise` where there is no direction.
glm::vec3 unit(const glm::vec3& v, const glm::vec3& otherwise) {
    const float length2 = glm::dot(v, v);
    return length2 > 0.0f && std::isfinite(length2) ? v / std::sqrt(length2) : otherwise;
}

glm::vec3 frontNormal(const MeshPoint& point) {
    const glm::vec3 across = point.acrossWorld();
    const float length2 = glm::dot(across, across);
    if (length2 > 1e-30f && length2 < 1e30f) return across * (1.0f / std::sqrt(length2));
    // Squares of tiny and huge areas leave the range of float.
    const glm::dvec3 precise(across);
    const double length = glm::length(precise);
    return length > 0.0 ? glm::vec3(precise / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

glm::vec3 mappedNormal(const MeshPoint& point, const glm::vec3& normal) {
    const PlacedMesh& placed = *point.placed;
    const assets::Material& material = *placed.material;
    if (!material.normalTexture.present() || placed.mesh->tangents.empty()) return normal;
    const glm::vec4 tangent = point.mix(placed.mesh->tangents, glm::vec4(0.0f));
    const glm::vec3 along = placed.toWorld * glm::vec3(tangent);
    const glm::vec3 t = unit(along - normal * glm::dot(normal, along), glm::vec3(0.0f));
    if (t == glm::vec3(0.0f)) return normal;
    const glm::vec3 b = glm::cross(normal, t) * (placed.mirrored ? -tangent.w : tangent.w);
    const glm::vec3 n = glm::vec3(texel(point, material.normalTexture, Encoding::Linear,
                                        glm::vec4(0.5f, 0.5f, 1.0f, 1.0f))) *
                            2.0f -
                        1.0f;
    return unit(material.normalScale * (n.x * t + n.y * b) + n.z * normal, normal);
}

glm::vec3 shadingNormal(const MeshPoint& point, const glm::vec3& geometric) {
    const glm::vec3 interpolated =
        unit(point.placed->normalsToWorld * point.mix(point.placed->mesh->normals, glm::vec3(0.0f)),
             geometric);
    const glm::vec3 mapped = mappedNormal(point, interpolated);
    return glm::dot(interpolated, geometric) < 0.0f ? -mapped : mapped;
}

}  // namespace

Surface mattSurfaceAt(const MeshPoint& point, const glm::vec3& rayDirection) {
    Surface surface;
    surface.position = point.positionWorld();
    const glm::vec3 normal = frontNormal(point);
    const bool front = glm::dot(normal, rayDirection) < 0.0f;
    surface.geometric = front ? normal : -normal;
    surface.shading = surface.geometric;
    surface.albedo = glm::vec3(baseColour(point)) * (1.0f - roughnessMetallic(point).y);
    surface.emission = emittedRadiance(point, front);
    return surface;
}

Surface surfaceAt(const MeshPoint& point, const glm::vec3& rayDirection) {
    const assets::Material& material = *point.placed->material;
    Surface surface = mattSurfaceAt(point, rayDirection);
    surface.shading = shadingNormal(point, surface.geometric);
    const glm::vec2 gloss = roughnessMetallic(point);
    surface.roughness = gloss.x;
    const glm::vec3 dielectric =
        glm::min(0.04f * material.specularColour, glm::vec3(1.0f)) * material.specularFactor;
    surface.f0 = glm::mix(dielectric, glm::vec3(baseColour(point)), gloss.y);
    return surface;
}

glm::vec3 emittedRadiance(const MeshPoint& point, bool front) {
    const assets::Material& material = *point.placed->material;
    if (material.emissiveRadiance == glm::vec3(0.0f)) return glm::vec3(0.0f);
    if (!front && !material.doubleSided) return glm::vec3(0.0f);
    return material.emissiveRadiance *
           glm::vec3(texel(point, material.emissiveTexture, Encoding::Srgb, glm::vec4(1.0f)));
}

bool opaque(const MeshPoint& point) {
    const assets::Material& material = *point.placed->material;
    return material.alphaMode != assets::AlphaMode::Mask ||
           baseColour(point).a >= material.alphaCutoff;
}

}  // namespace lampyris::reference
