#include "residency/emitters.h"

#include <algorithm>
#include <array>

#include "residency/image_lookup.h"
#include "residency/pack_scene.h"

namespace lampyris::residency {
namespace {

// Points a side at which a textured triangle's emission is averaged. [chosen]
constexpr int kMostSteps = 64;

/// One triangle corner by corner.
template <typename T>
std::array<T, 3> corners(const std::vector<T>& attribute, const assets::Mesh& mesh,
                         size_t triangle) {
    const uint32_t* corner = &mesh.indices[3 * triangle];
    return {attribute[corner[0]], attribute[corner[1]], attribute[corner[2]]};
}

/// About a point a texel that the triangle covers.
int stepsFor(const std::array<glm::vec2, 3>& uv, const assets::TextureImage& image) {
    const glm::vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const float texels = 0.5f * std::abs(a.x * b.y - a.y * b.x) * static_cast<float>(image.width) *
                         static_cast<float>(image.height);
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(texels)), 2.0f, float{kMostSteps}));
}

/// The mean of the emissive texture over a triangle: centres of the small triangles of a regular
/// subdivision.
glm::vec3 meanTexel(const assets::TextureUse& use, const assets::TextureImage& image,
                    const std::array<glm::vec2, 3>& uv) {
    const int steps = stepsFor(uv, image);
    const auto at = [&](float i, float j) {
        const float u = i / static_cast<float>(steps), v = j / static_cast<float>(steps);
        return lookUpSrgb(image, use, uv[0] * (1.0f - u - v) + uv[1] * u + uv[2] * v);
    };
    glm::dvec3 sum(0.0);
    for (int i = 0; i < steps; ++i)
        for (int j = 0; i + j < steps; ++j) {
            const auto x = static_cast<float>(i), y = static_cast<float>(j);
            sum += at(x + 1.0f / 3.0f, y + 1.0f / 3.0f);
            if (i + j + 1 < steps) sum += at(x + 2.0f / 3.0f, y + 2.0f / 3.0f);
        }
    return glm::vec3(sum / static_cast<double>(steps * steps));
}

/// Radiance of a triangle: the material's, times its texture's mean.
glm::vec3 radianceOf(const scene::SceneSnapshot& snapshot, const assets::Mesh& mesh,
                     const assets::Material& material, size_t triangle) {
    const assets::TextureUse& use = material.emissiveTexture;
    if (!use.present()) return material.emissiveRadiance;
    const auto& texcoords = use.texcoordSet == 1 ? mesh.texcoords1 : mesh.texcoords0;
    const auto& image = *snapshot.images[static_cast<size_t>(use.image)].value;
    const std::array<glm::vec2, 3> uv =
        texcoords.empty() ? std::array<glm::vec2, 3>{} : corners(texcoords, mesh, triangle);
    return material.emissiveRadiance * meanTexel(use, image, uv);
}

EmitterTriangle triangleOf(const std::vector<glm::vec3>& positions, const assets::Mesh& mesh,
                           const Placement& placement, size_t triangle) {
    const auto position = corners(positions, mesh, triangle);
    std::array<glm::vec3, 3> world;
    for (size_t i = 0; i < 3; ++i)
        world[i] = glm::vec3(placement.objectToWorld * glm::vec4(position[i], 1.0f));
    // glTF turns the winding of mirrored instances round, so that their front stays outside.
    if (placement.mirrored) std::swap(world[1], world[2]);
    EmitterTriangle result;
    result.v0 = world[0];
    result.e1 = world[1] - world[0];
    result.e2 = world[2] - world[0];
    result.primitive = static_cast<uint32_t>(triangle);
    result.areaSquareMetres = 0.5f * glm::length(glm::cross(result.e1, result.e2));
    return result;
}

double mean(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0;
}

void addEmitter(EmitterTable& table, const scene::SceneSnapshot& snapshot, uint32_t index) {
    const auto& instance = snapshot.instances[index];
    const auto& mesh = *snapshot.meshes[instance.mesh].value;
    const auto& material = *snapshot.materials[instance.material].value;
    const auto placement = placementOf(instance.objectToWorld);
    if (!placement) return;
    const uint32_t flags = instanceFlags(material, *placement);
    const auto posed =
        instance.pose ? scene::posedVertices(mesh, *instance.pose) : scene::PosedVertices{};
    const auto& positions = instance.pose ? posed.positions : mesh.positions;
    const double sides = material.doubleSided ? 2.0 : 1.0;
    const size_t first = table.triangles.size();
    glm::dvec3 power(0.0);
    std::vector<double> cumulative;
    for (size_t i = 0; i < mesh.triangleCount(); ++i) {
        EmitterTriangle triangle = triangleOf(positions, mesh, *placement, i);
        triangle.radiance = radianceOf(snapshot, mesh, material, i);
        const glm::dvec3 part =
            glm::dvec3(triangle.radiance) * (glm::pi<double>() * triangle.areaSquareMetres * sides);
        if (!(mean(part) > 0.0) || !std::isfinite(mean(part))) continue;
        power += part;
        cumulative.push_back(mean(power));
        table.triangles.push_back(triangle);
    }
    if (cumulative.empty()) return;
    for (size_t i = 0; i < cumulative.size(); ++i)
        table.triangles[first + i].cumulative =
            static_cast<float>(cumulative[i] / cumulative.back());
    table.emitters.push_back({glm::vec4(power, mean(power)), index, static_cast<uint32_t>(first),
                              static_cast<uint32_t>(cumulative.size()), flags});
}

void shareOfAll(EmitterTable& table) {
    double all = 0.0;
    for (const auto& emitter : table.emitters) all += static_cast<double>(emitter.power.w);
    double before = 0.0;
    for (const auto& emitter : table.emitters) {
        const double power = static_cast<double>(emitter.power.w);
        for (uint32_t i = 0; i < emitter.triangleCount; ++i) {
            auto& triangle = table.triangles[emitter.firstTriangle + i];
            triangle.cumulativeOfAll = static_cast<float>(
                (before + static_cast<double>(triangle.cumulative) * power) / all);
        }
        before += power;
    }
    if (!table.triangles.empty()) table.triangles.back().cumulativeOfAll = 1.0f;
}

}  // namespace

bool emits(const scene::SceneSnapshot& snapshot, const scene::SnapshotInstance& instance) {
    const glm::vec3 radiance = snapshot.materials[instance.material].value->emissiveRadiance;
    return glm::any(glm::greaterThan(radiance, glm::vec3(0.0f)));
}

EmitterTable buildEmitters(const scene::SceneSnapshot& snapshot) {
    EmitterTable table;
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i)
        if (emits(snapshot, snapshot.instances[i])) addEmitter(table, snapshot, i);
    shareOfAll(table);
    return table;
}

std::vector<uint64_t> emitterSignature(const scene::SceneSnapshot& snapshot) {
    std::vector<uint64_t> signature;
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i) {
        const auto& instance = snapshot.instances[i];
        if (!emits(snapshot, instance)) continue;
        const auto& material = snapshot.materials[instance.material];
        const assets::TextureUse& use = material.value->emissiveTexture;
        signature.insert(
            signature.end(),
            {i, instance.entity.bits, instance.version, snapshot.meshes[instance.mesh].version,
             material.version,
             use.present() ? snapshot.images[static_cast<size_t>(use.image)].version : 0});
    }
    return signature;
}

}  // namespace lampyris::residency
