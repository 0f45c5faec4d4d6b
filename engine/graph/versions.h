/// \file Which node makes, reads and retires each version of each resource: the edges of the graph.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::graph {

/// One version of one resource.
struct VersionLinks {
    uint32_t writer = kNoNode;      ///< makes it; none for version 0
    uint32_t retirer = kNoNode;     ///< makes its successor
    std::vector<uint32_t> readers;  ///< nodes that need its contents
};

/// Whether a use needs what the version it names holds (a pure or clearing write does not).
[[nodiscard]] bool needsContents(const Use& use);

/// Whether a resource holds something at version 0: imported ones and the previous image of a
/// history.
[[nodiscard]] bool startsWithContents(const ResourceInfo& info);

/// Whether what is written to it is seen after the frame.
[[nodiscard]] bool outlivesFrame(const ResourceInfo& info);

/// All versions of a frame; of two writers of one version the later one stands (verify() forbids
/// them).
class Versions {
 public:
    explicit Versions(const Frame& frame);
    /// Null where no node touches that version.
    [[nodiscard]] const VersionLinks* find(uint32_t resource, uint32_t version) const;
    /// Calls visit(resource, version, links) for each, in order of first mention.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (const Entry& entry : entries_) visit(entry.resource, entry.version, entry.links);
    }

 private:
    struct Entry {
        uint32_t resource;
        uint32_t version;
        VersionLinks links;
    };
    VersionLinks& at(uint32_t resource, uint32_t version);
    std::vector<Entry> entries_;
    std::unordered_map<uint64_t, size_t> index_;
};

}  // namespace lampyris::graph
