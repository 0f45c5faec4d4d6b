#include "assets/tangents.h"

#include <cmath>
#include <vector>

#include "core/check.h"

namespace lampyris::assets {
namespace {

/// Directions in which u grows and v falls.
struct Frame {
    glm::vec3 alongU{0.0f};
    glm::vec3 againstV{0.0f};
};

glm::vec3 unitOrZero(const glm::vec3& vector) {
    const float length = glm::length(vector);
    return length > 0.0f && std::isfinite(length) ? vector / length : glm::vec3(0.0f);
}

Frame triangleFrame(const glm::vec3 positions[3], const glm::vec2 uvs[3]) {
    const glm::vec3 edge1 = positions[1] - positions[0];
    const glm::vec3 edge2 = positions[2] - positions[0];
    const glm::vec2 uv1 = uvs[1] - uvs[0];
    const glm::vec2 uv2 = uvs[2] - uvs[0];
    const float determinant = uv1.x * uv2.y - uv2.x * uv1.y;
    if (determinant == 0.0f) return {};
    const float sign = determinant > 0.0f ? 1.0f : -1.0f;
    return {unitOrZero(sign * (edge1 * uv2.y - edge2 * uv1.y)),
            unitOrZero(sign * (edge1 * uv2.x - edge2 * uv1.x))};
}

float angleBetween(const glm::vec3& a, const glm::vec3& b) {
    return std::acos(glm::clamp(glm::dot(unitOrZero(a), unitOrZero(b)), -1.0f, 1.0f));
}

glm::vec3 anyPerpendicular(const glm::vec3& normal) {
    const glm::vec3 axis =
        std::abs(normal.x) < 0.7f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    return glm::normalize(axis - normal * glm::dot(axis, normal));
}

glm::vec4 tangentOf(const Frame& frame, const glm::vec3& normal) {
    const glm::vec3 flat = unitOrZero(frame.alongU - normal * glm::dot(frame.alongU, normal));
    if (flat == glm::vec3(0.0f)) return {anyPerpendicular(normal), 1.0f};
    const bool mirrored = glm::dot(glm::cross(normal, flat), frame.againstV) < 0.0f;
    return {flat, mirrored ? -1.0f : 1.0f};
}

}  // namespace

void generateTangents(Mesh& mesh, uint32_t texcoordSet) {
    const std::vector<glm::vec2>& texcoords = texcoordSet == 0 ? mesh.texcoords0 : mesh.texcoords1;
    CHECK(texcoords.size() == mesh.positions.size());
    std::vector<Frame> frames(mesh.positions.size());
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t* corners = &mesh.indices[i];
        glm::vec3 positions[3];
        glm::vec2 uvs[3];
        for (int c = 0; c < 3; ++c) {
            positions[c] = mesh.positions[corners[c]];
            uvs[c] = texcoords[corners[c]];
        }
        const Frame frame = triangleFrame(positions, uvs);
        for (int c = 0; c < 3; ++c) {
            const float angle = angleBetween(positions[(c + 1) % 3] - positions[c],
                                             positions[(c + 2) % 3] - positions[c]);
            frames[corners[c]].alongU += angle * frame.alongU;
            frames[corners[c]].againstV += angle * frame.againstV;
        }
    }
    mesh.tangents.resize(mesh.positions.size());
    for (size_t i = 0; i < frames.size(); ++i)
        mesh.tangents[i] = tangentOf(frames[i], mesh.normals[i]);
}

void normalizeTangents(Mesh& mesh) {
    for (size_t i = 0; i < mesh.tangents.size(); ++i) {
        const glm::vec3 unit = unitOrZero(glm::vec3(mesh.tangents[i]));
        const float w = mesh.tangents[i].w < 0.0f ? -1.0f : 1.0f;
        mesh.tangents[i] = {unit == glm::vec3(0.0f) ? anyPerpendicular(mesh.normals[i]) : unit, w};
    }
}

}  // namespace lampyris::assets
