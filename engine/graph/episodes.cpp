#include "graph/episodes.h"

#include <algorithm>
#include <map>

#include "graph/versions.h"

namespace lampyris::graph {
namespace {

/// Adds an episode, or makes the last one longer where no barrier is needed between the two.
void append(Episodes& episodes, const Episode& next) {
    const bool merges = !episodes.empty() && !episodes.back().writes && !next.writes &&
                        episodes.back().layout == next.layout;
    if (!merges) {
        episodes.push_back(next);
        return;
    }
    episodes.back().lastStep = next.lastStep;
    episodes.back().touches.add(next.touches);
}

Layout layoutOf(const ResourceInfo& info, const TouchSet& touches) {
    if (!info.isImage) return Layout::Undefined;
    return layoutFor(touches.accesses(), info.image.format).value_or(Layout::General);
}

/// Whether a use reads what its own node wrote: a later copy of a transfer node.
bool readsOwnWrite(const Node& node, const Use& use) {
    return std::any_of(node.uses.begin(), node.uses.end(), [&](const Use& other) {
        return other.resource == use.resource && writes(other.access) &&
               other.writtenVersion == use.version;
    });
}

/// What one node does to each of its resources.
std::map<uint32_t, Episode> touchesOf(const Node& node, uint32_t step) {
    std::map<uint32_t, Episode> touched;
    for (const Use& use : node.uses) {
        Episode fresh{.firstStep = step, .lastStep = step, .discards = true};
        Episode& episode = touched.try_emplace(use.resource, fresh).first->second;
        episode.touches.add({use.access, node.kind});
        episode.writes = episode.writes || writes(use.access);
        if (needsContents(use) && !readsOwnWrite(node, use)) episode.discards = false;
    }
    return touched;
}

Access accessAfterFrame(const ResourceInfo& info, bool isOutput) {
    switch (info.origin) {
        case Origin::Imported:
            return info.importedAs;
        case Origin::History:
            return Access::Sampled;
        case Origin::Transient:
            return isOutput ? Access::TransferRead : Access::None;
    }
    return Access::None;
}

void appendEnd(const ResourceInfo& info, bool isOutput, uint32_t end, Episodes& episodes) {
    const Access after = accessAfterFrame(info, isOutput);
    if (episodes.empty() || after == Access::None) return;
    Episode last{.firstStep = end, .lastStep = end, .touches = outsideTouches(after)};
    last.layout = layoutOf(info, last.touches);
    // The next frame opens with a full barrier: a writer outside needs the layout only.
    const bool sameLayout = !info.isImage || last.layout == episodes.back().layout;
    if (writes(after) && sameLayout) return;
    append(episodes, last);
}

}  // namespace

std::vector<Episodes> findEpisodes(const Frame& frame, const std::vector<Step>& steps,
                                   const std::vector<Frame::Output>& outputs) {
    const auto& resources = frame.resources();
    std::vector<Episodes> all(resources.size());
    for (uint32_t step = 0; step < steps.size(); ++step) {
        for (const uint32_t resource : steps[step].poisons) {
            Episode poison{.firstStep = step, .lastStep = step, .writes = true, .discards = true};
            poison.touches.add({Access::TransferWrite, NodeKind::Transfer});
            poison.layout = layoutOf(resources[resource], poison.touches);
            append(all[resource], poison);
        }
        if (steps[step].node == kNoNode) continue;
        for (auto& [resource, episode] : touchesOf(frame.nodes()[steps[step].node], step)) {
            episode.layout = layoutOf(resources[resource], episode.touches);
            append(all[resource], episode);
        }
    }
    std::vector<bool> isOutput(resources.size(), false);
    for (const Frame::Output& output : outputs) isOutput[output.resource] = true;
    for (uint32_t resource = 0; resource < resources.size(); ++resource) {
        appendEnd(resources[resource], isOutput[resource], static_cast<uint32_t>(steps.size()),
                  all[resource]);
    }
    return all;
}

Layout openingLayout(const ResourceInfo& info) {
    if (info.origin == Origin::History && info.historyPrevious) {
        return restLayout(info.image.format);
    }
    if (info.origin != Origin::Imported || info.importedAs == Access::None) {
        return Layout::Undefined;
    }
    return layoutOf(info, outsideTouches(info.importedAs));
}

}  // namespace lampyris::graph
