#include "graph/versions.h"

#include <algorithm>

namespace lampyris::graph {
namespace {

uint64_t key(uint32_t resource, uint32_t version) {
    return uint64_t{resource} << 32 | version;
}

}  // namespace

bool needsContents(const Use& use) {
    if (!writes(use.access)) return true;
    const bool attachment = use.access == Access::ColorWrite || use.access == Access::DepthWrite;
    return use.access == Access::StorageUpdate || use.partial || (attachment && !use.clears);
}

bool startsWithContents(const ResourceInfo& info) {
    return info.origin == Origin::Imported ||
           (info.origin == Origin::History && info.historyPrevious);
}

bool outlivesFrame(const ResourceInfo& info) {
    return info.origin != Origin::Transient;
}

Versions::Versions(const Frame& frame) {
    for (uint32_t node = 0; node < frame.nodes().size(); ++node) {
        for (const Use& use : frame.nodes()[node].uses) {
            VersionLinks& links = at(use.resource, use.version);
            const bool known =
                std::find(links.readers.begin(), links.readers.end(), node) != links.readers.end();
            if (needsContents(use) && !known) links.readers.push_back(node);
            if (!writes(use.access)) continue;
            links.retirer = node;
            at(use.resource, use.writtenVersion).writer = node;
        }
    }
}

const VersionLinks* Versions::find(uint32_t resource, uint32_t version) const {
    const auto found = index_.find(key(resource, version));
    return found == index_.end() ? nullptr : &entries_[found->second].links;
}

VersionLinks& Versions::at(uint32_t resource, uint32_t version) {
    const auto [place, isNew] = index_.try_emplace(key(resource, version), entries_.size());
    if (isNew) entries_.push_back({resource, version, {}});
    return entries_[place->second].links;
}

}  // namespace lampyris::graph
