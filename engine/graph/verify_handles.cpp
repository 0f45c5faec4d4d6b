#include <algorithm>
#include <map>
#include <optional>

#include "graph/verify.h"
#include "graph/versions.h"

namespace lampyris::graph {
namespace {

/// Walks the nodes as they were declared and keeps who retired which version.
class HandleCheck {
 public:
    explicit HandleCheck(const Frame& frame) : frame_(frame) {}

    core::Result<void> run() {
        for (const Node& node : frame_.nodes()) {
            for (const Use& use : node.uses) TRY_VOID(existing(node, use));
        }
        collectWriters();
        for (const Node& node : frame_.nodes()) {
            for (const Use& use : node.uses) {
                TRY_VOID(notStale(node, use));
                TRY_VOID(written(node, use));
                if (writes(use.access)) retirers_.try_emplace(key(use), &node);
            }
            TRY_VOID(oneLayout(node));
        }
        return {};
    }

    core::Result<void> outputs(const std::vector<Frame::Output>& outputs) const {
        for (const Frame::Output& output : outputs) {
            if (output.resource >= frame_.resources().size()) {
                return core::error("render graph: an output is not a handle of this frame");
            }
            const ResourceInfo& info = frame_.resources()[output.resource];
            const bool filled = output.version == 0
                                    ? startsWithContents(info)
                                    : writers_.contains({output.resource, output.version});
            if (filled) continue;
            return core::error("render graph: output '{}' is read before any node writes it",
                               info.name);
        }
        return {};
    }

 private:
    using Key = std::pair<uint32_t, uint32_t>;
    static Key key(const Use& use) { return {use.resource, use.version}; }
    const ResourceInfo& info(const Use& use) const { return frame_.resources()[use.resource]; }

    void collectWriters() {
        for (const Node& node : frame_.nodes()) {
            for (const Use& use : node.uses) {
                if (writes(use.access)) writers_[{use.resource, use.writtenVersion}] = &node;
            }
        }
    }

    core::Result<void> existing(const Node& node, const Use& use) const {
        if (use.resource >= frame_.resources().size()) {
            return core::error(
                "render graph: node '{}' uses ({}) a handle that is not of this frame", node.name,
                name(use.access));
        }
        if (info(use).isImage != use.isImage) {
            return core::error("render graph: node '{}' uses '{}' as {}, which it is not",
                               node.name, info(use).name, use.isImage ? "an image" : "a buffer");
        }
        if (writes(use.access) && info(use).historyPrevious) {
            return core::error("render graph: node '{}' writes the previous image of history '{}'",
                               node.name, info(use).name);
        }
        return {};
    }

    core::Result<void> notStale(const Node& node, const Use& use) const {
        const auto retirer = retirers_.find(key(use));
        if (retirer == retirers_.end()) return {};
        // A shader may read in one slot what it rewrites in another; a later copy may not.
        const bool readsInPlace = retirer->second == &node && !writes(use.access);
        if (readsInPlace && node.kind != NodeKind::Transfer) return {};
        return core::error(
            "render graph: node '{}' {} '{}' through a stale handle: node '{}' had rewritten it",
            node.name, writes(use.access) ? "writes" : "reads", info(use).name,
            retirer->second->name);
    }

    core::Result<void> written(const Node& node, const Use& use) const {
        const ResourceInfo& resource = info(use);
        if (use.version > 0) {
            const auto writer = writers_.find(key(use));
            if (writer == writers_.end()) return beforeWrite(node, use);
            const bool ownWrite = writer->second == &node && !writes(use.access);
            if (!ownWrite || node.kind == NodeKind::Transfer) return {};
            return core::error("render graph: node '{}' reads its own result '{}'", node.name,
                               resource.name);
        }
        if (!needsContents(use)) return {};
        if (!startsWithContents(resource)) {
            return use.partial && coversAll(node, use) ? core::Result<void>{}
                                                       : beforeWrite(node, use);
        }
        const bool unknown = resource.isImage && resource.origin == Origin::Imported &&
                             resource.importedAs == Access::None;
        if (!unknown) return {};
        return core::error(
            "render graph: node '{}' reads image '{}', which was imported as None: its layout and "
            "contents are unknown",
            node.name, resource.name);
    }

    core::Result<void> beforeWrite(const Node& node, const Use& use) const {
        return core::error("render graph: node '{}' {} '{}' before any node writes it", node.name,
                           writes(use.access) ? "keeps what stands in" : "reads", info(use).name);
    }

    /// Whether the copies of one node together write all of a target.
    bool coversAll(const Node& node, const Use& use) const {
        std::vector<std::pair<uint64_t, uint64_t>> parts;  // begin, end
        for (const Copy& copy : node.copies) {
            if (copy.targetResource != use.resource) continue;
            const uint64_t begin = use.isImage ? copy.targetLayer : copy.targetOffset;
            parts.emplace_back(begin, begin + (use.isImage ? 1 : copy.bytes));
        }
        std::sort(parts.begin(), parts.end());
        uint64_t covered = 0;
        for (const auto& [begin, end] : parts) {
            if (begin > covered) return false;
            covered = std::max(covered, end);
        }
        return covered >= (use.isImage ? info(use).image.layers : info(use).buffer.bytes);
    }

    core::Result<void> oneLayout(const Node& node) const {
        std::map<uint32_t, AccessSet> images;
        for (const Use& use : node.uses) {
            if (!use.isImage) continue;
            AccessSet& accesses = images[use.resource];
            accesses.add(use.access);
            if (layoutFor(accesses, info(use).image.format)) continue;
            return core::error(
                "render graph: node '{}' uses image '{}' in two ways that no layout serves at once "
                "({} is one)",
                node.name, info(use).name, name(use.access));
        }
        return {};
    }

    const Frame& frame_;
    std::map<Key, const Node*> writers_;   // of all nodes
    std::map<Key, const Node*> retirers_;  // of the nodes walked so far
};

}  // namespace

core::Result<void> verifyHandles(const Frame& frame, const std::vector<Frame::Output>& outputs) {
    HandleCheck check(frame);
    TRY_VOID(check.run());
    return check.outputs(outputs);
}

}  // namespace lampyris::graph
