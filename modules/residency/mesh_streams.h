/// \file Every mesh's vertices and indices on the device: a stream an attribute, a range a mesh.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "residency/pack_scene.h"
#include "residency/range_allocator.h"
#include "residency/resident_buffer.h"

namespace lampyris::residency {

/// The part of positions, normals and tangents that one deformed instance has to itself.
struct PosedRange {
    uint32_t firstVertex = 0;
    uint32_t vertexCount = 0;
    uint32_t firstTangent = shared::SCENE_NONE;
    uint32_t tangentCount = 0;
};

/// Streams begin with one neutral element, which stands in where a mesh lacks the attribute.
class MeshStreams {
 public:
    enum Stream : uint8_t { Indices, Positions, Normals, Tangents, Texcoords, Colours, Count };

    explicit MeshStreams(Device& device);

    /// Loads meshes whose version is new and forgets those that are gone; waits for the device
    /// where there are any, or where streams grow. \return the bytes sent.
    core::Result<uint64_t> follow(const scene::SceneSnapshot& snapshot);

    /// Room for a mesh's vertices once more, there from the next follow() on. Their contents are
    /// the taker's.
    [[nodiscard]] PosedRange takePosed(const assets::Mesh& mesh);
    void givePosed(const PosedRange& range);

    /// Where a mesh of the last snapshot stands.
    [[nodiscard]] const MeshRange& range(uint64_t meshVersion) const;
    [[nodiscard]] ResidentBuffer& buffer(Stream stream) { return streams_[stream].buffer; }
    [[nodiscard]] static uint64_t elementBytes(Stream stream);
    [[nodiscard]] uint64_t bytes() const;

 private:
    struct Storage {
        ResidentBuffer buffer;
        RangeAllocator ranges;
    };
    struct Entry {
        MeshRange range;
        std::array<uint64_t, Count> lengths{};
    };
    using Sources = std::array<std::span<const std::byte>, Count>;

    void forgetMissing(const scene::SceneSnapshot& snapshot);
    [[nodiscard]] Entry place(const assets::Mesh& mesh);
    core::Result<void> writeNeutral(Loading& loading);
    core::Result<uint64_t> write(Loading& loading, const assets::Mesh& mesh, const Entry& entry);

    Device* device_;
    std::vector<Storage> streams_;
    std::map<uint64_t, Entry> entries_;  ///< by mesh version
};

}  // namespace lampyris::residency
