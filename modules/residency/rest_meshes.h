/// \file What poses start from: rest vertices and morph offsets of deformed meshes, once a mesh.
#pragma once

#include <map>

#include "residency/range_allocator.h"
#include "residency/resident_buffer.h"
#include "scene/snapshot.h"

namespace lampyris::residency {

/// Where a mesh stands; counted in vertices, a morph target after the other.
struct RestRange {
    uint32_t firstRest = 0;
    uint32_t firstDelta = 0;
};

/// Layout: shaders/shared/pose.h. Nothing is taken of the device while no instance is deformed.
class RestMeshes {
 public:
    explicit RestMeshes(Device& device);

    /// Loads the meshes of deformed instances whose version is new and forgets those that are
    /// gone; waits for the device where there are any. \return the bytes sent. Errors name the
    /// limit.
    core::Result<uint64_t> follow(const scene::SceneSnapshot& snapshot);

    [[nodiscard]] RestRange range(uint64_t meshVersion) const;
    [[nodiscard]] ResidentBuffer& vertices() { return vertices_; }
    [[nodiscard]] ResidentBuffer& deltas() { return deltas_; }
    [[nodiscard]] uint64_t bytes() const { return vertices_.bytes() + deltas_.bytes(); }

 private:
    struct Entry {
        RestRange range;
        uint64_t vertexCount = 0;
        uint64_t deltaCount = 0;
    };
    using Wanted = std::map<uint64_t, const assets::Mesh*>;  ///< by mesh version

    void forgetMissing(const Wanted& wanted);
    core::Result<uint64_t> write(Loading& loading, const assets::Mesh& mesh, const Entry& entry);

    Device* device_;
    ResidentBuffer vertices_;
    ResidentBuffer deltas_;
    RangeAllocator vertexRanges_;
    RangeAllocator deltaRanges_;
    std::map<uint64_t, Entry> entries_;  ///< by mesh version
};

}  // namespace lampyris::residency
