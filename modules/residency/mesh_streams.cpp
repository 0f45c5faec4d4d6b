#include "residency/mesh_streams.h"

#include <set>

#include "core/check.h"

namespace lampyris::residency {
namespace {

struct StreamKind {
    const char* name;
    uint32_t elementBytes;
    uint32_t texelBytes;  ///< of the views that shaders fetch from
    glm::vec4 neutral;
};

constexpr std::array<StreamKind, MeshStreams::Count> kKinds = {{
    {"mesh indices", 4, 4, glm::vec4(0.0f)},
    {"mesh positions", sizeof(DevicePosition), sizeof(DevicePosition), glm::vec4(0.0f)},
    {"mesh normals", 12, 4, glm::vec4(0.0f, 0.0f, 1.0f, 0.0f)},
    {"mesh tangents", 16, 16, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f)},
    {"mesh texcoords", 16, 16, glm::vec4(0.0f)},
    {"mesh colours", 16, 16, glm::vec4(1.0f)},
}};

std::array<uint64_t, MeshStreams::Count> lengthsOf(const assets::Mesh& mesh) {
    const bool textured = !mesh.texcoords0.empty() || !mesh.texcoords1.empty();
    return {mesh.indices.size(),
            mesh.positions.size(),
            mesh.normals.size(),
            mesh.tangents.size(),
            textured ? mesh.positions.size() : 0,
            mesh.colours.size()};
}

std::array<uint64_t, MeshStreams::Count> firstsOf(const MeshRange& range) {
    return {range.firstIndex,   range.firstVertex,   range.firstVertex,
            range.firstTangent, range.firstTexcoord, range.firstColour};
}

std::vector<glm::vec4> bothTexcoordSets(const assets::Mesh& mesh) {
    std::vector<glm::vec4> both(mesh.positions.size(), glm::vec4(0.0f));
    for (size_t i = 0; i < mesh.texcoords0.size(); ++i)
        both[i] = glm::vec4(mesh.texcoords0[i], 0.0f, 0.0f);
    for (size_t i = 0; i < mesh.texcoords1.size(); ++i)
        both[i] = glm::vec4(both[i].x, both[i].y, mesh.texcoords1[i]);
    return both;
}

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

}  // namespace

MeshStreams::MeshStreams(Device& device) : device_(&device) {
    for (const StreamKind& kind : kKinds) {
        streams_.push_back({ResidentBuffer(device, kind.name, kind.texelBytes), {}});
        CHECK(streams_.back().ranges.take(1) == 0u);
    }
}

uint64_t MeshStreams::elementBytes(Stream stream) {
    return kKinds[stream].elementBytes;
}

uint64_t MeshStreams::bytes() const {
    uint64_t sum = 0;
    for (const Storage& stream : streams_) sum += stream.buffer.bytes();
    return sum;
}

const MeshRange& MeshStreams::range(uint64_t meshVersion) const {
    const auto entry = entries_.find(meshVersion);
    CHECK(entry != entries_.end());
    return entry->second.range;
}

void MeshStreams::forgetMissing(const scene::SceneSnapshot& snapshot) {
    std::set<uint64_t> wanted;
    for (const auto& mesh : snapshot.meshes) wanted.insert(mesh.version);
    std::erase_if(entries_, [&](const auto& item) {
        const auto& [version, entry] = item;
        if (wanted.contains(version)) return false;
        const auto firsts = firstsOf(entry.range);
        for (size_t i = 0; i < Count; ++i) streams_[i].ranges.give(firsts[i], entry.lengths[i]);
        return true;
    });
}

MeshStreams::Entry MeshStreams::place(const assets::Mesh& mesh) {
    Entry entry;
    entry.lengths = lengthsOf(mesh);
    std::array<uint32_t, Count> firsts{};
    for (size_t i = 0; i < Count; ++i)
        firsts[i] = entry.lengths[i] == 0
                        ? shared::SCENE_NONE
                        : static_cast<uint32_t>(streams_[i].ranges.take(entry.lengths[i]));
    // Positions and normals are always there, equally long and taken together: they stand side by
    // side.
    CHECK(firsts[Positions] == firsts[Normals]);
    entry.range = {firsts[Indices],   static_cast<uint32_t>(mesh.indices.size()),
                   firsts[Positions], firsts[Tangents],
                   firsts[Texcoords], firsts[Colours]};
    return entry;
}

PosedRange MeshStreams::takePosed(const assets::Mesh& mesh) {
    PosedRange range;
    range.vertexCount = static_cast<uint32_t>(mesh.positions.size());
    range.tangentCount = static_cast<uint32_t>(mesh.tangents.size());
    range.firstVertex = static_cast<uint32_t>(streams_[Positions].ranges.take(range.vertexCount));
    const uint64_t firstNormal = streams_[Normals].ranges.take(range.vertexCount);
    CHECK(firstNormal == range.firstVertex);
    if (range.tangentCount > 0)
        range.firstTangent =
            static_cast<uint32_t>(streams_[Tangents].ranges.take(range.tangentCount));
    return range;
}

void MeshStreams::givePosed(const PosedRange& range) {
    streams_[Positions].ranges.give(range.firstVertex, range.vertexCount);
    streams_[Normals].ranges.give(range.firstVertex, range.vertexCount);
    streams_[Tangents].ranges.give(range.firstTangent, range.tangentCount);
}

core::Result<void> MeshStreams::writeNeutral(Loading& loading) {
    for (size_t i = 0; i < Count; ++i) {
        const auto bytes = std::as_bytes(std::span(&kKinds[i].neutral, 1));
        TRY_VOID(loading.write(streams_[i].buffer, 0, bytes.first(kKinds[i].elementBytes)));
    }
    return {};
}

core::Result<uint64_t> MeshStreams::write(Loading& loading, const assets::Mesh& mesh,
                                          const Entry& entry) {
    const auto texcoords =
        entry.lengths[Texcoords] > 0 ? bothTexcoordSets(mesh) : std::vector<glm::vec4>{};
    const auto positions = packPositions(mesh.positions);
    const Sources sources = {bytesOf(mesh.indices),  bytesOf(positions), bytesOf(mesh.normals),
                             bytesOf(mesh.tangents), bytesOf(texcoords), bytesOf(mesh.colours)};
    const auto firsts = firstsOf(entry.range);
    uint64_t sum = 0;
    for (size_t i = 0; i < Count; ++i) {
        if (sources[i].empty()) continue;
        TRY_VOID(loading.write(streams_[i].buffer, firsts[i] * kKinds[i].elementBytes, sources[i]));
        sum += sources[i].size();
    }
    return sum;
}

core::Result<uint64_t> MeshStreams::follow(const scene::SceneSnapshot& snapshot) {
    forgetMissing(snapshot);
    std::map<uint64_t, const assets::Mesh*> added;
    for (const auto& mesh : snapshot.meshes)
        if (!entries_.contains(mesh.version) &&
            added.emplace(mesh.version, mesh.value.get()).second)
            entries_[mesh.version] = place(*mesh.value);
    const bool first = streams_[0].buffer.bytes() == 0;
    for (size_t i = 0; i < Count; ++i)
        TRY_VOID(
            streams_[i].buffer.reserve(streams_[i].ranges.capacity() * kKinds[i].elementBytes));
    if (added.empty() && !first) return uint64_t{0};
    TRY(Loading loading, Loading::begin(*device_));
    if (first) TRY_VOID(writeNeutral(loading));
    uint64_t sum = 0;
    for (const auto& [version, mesh] : added) {
        TRY(const uint64_t bytes, write(loading, *mesh, entries_[version]));
        sum += bytes;
    }
    TRY_VOID(loading.finish());
    return sum;
}

}  // namespace lampyris::residency
