#include <vector>

#include "assets/gltf_check.h"

namespace lampyris::assets {
namespace {

constexpr size_t kNoParent = static_cast<size_t>(-1);

void checkNode(const Place& place, const TableSizes& sizes) {
    place.index("mesh", sizes.meshes);
    place.index("camera", sizes.cameras);
    place.index("skin", sizes.skins);
    place.indices("children", sizes.nodes);
    place.numbers("matrix", 16);
    place.numbers("translation", 3);
    place.numbers("rotation", 4);
    place.numbers("scale", 3);
    place.numbers("weights", 0);
    const Place extensions = place.object("extensions");
    if (extensions.has("KHR_lights_punctual"))
        extensions.object("KHR_lights_punctual").requiredIndex("light", sizes.lights);
}

/// The one parent of every node.
std::vector<size_t> findParents(const Place& root, size_t nodes) {
    std::vector<size_t> parents(nodes, kNoParent);
    size_t parent = 0;
    root.each("nodes", [&](const Place& place) {
        const size_t children = place.length("children");
        for (size_t i = 0; i < children && place.ok(); ++i) {
            const Place entry = place.element("children", i);
            size_t& known = parents[entry.json().get<size_t>()];
            if (known != kNoParent)
                entry.complain("node {} has a second parent", entry.json().dump());
            known = parent;
        }
        ++parent;
    });
    return parents;
}

/// With one parent each, a node is in or under a cycle if the walk up from it does not end.
void checkCycles(const Place& root, const std::vector<size_t>& parents) {
    enum class State : uint8_t { Unknown, OnThisWalk, ReachesRoot };
    std::vector<State> states(parents.size(), State::Unknown);
    std::vector<size_t> walk;
    for (size_t start = 0; start < parents.size(); ++start) {
        walk.clear();
        size_t node = start;
        while (node != kNoParent && states[node] == State::Unknown) {
            states[node] = State::OnThisWalk;
            walk.push_back(node);
            node = parents[node];
        }
        if (node != kNoParent && states[node] == State::OnThisWalk)
            return root.element("nodes", node).complain("is its own ancestor");
        for (const size_t visited : walk) states[visited] = State::ReachesRoot;
    }
}

/// `seenIn` holds for every node the place of the last scene that lists it.
void checkScene(const Place& place, const std::vector<size_t>& parents,
                std::vector<const Json*>& seenIn) {
    place.indices("nodes", parents.size());
    const size_t count = place.length("nodes");
    for (size_t i = 0; i < count && place.ok(); ++i) {
        const Place entry = place.element("nodes", i);
        const auto node = entry.json().get<size_t>();
        if (parents[node] != kNoParent) entry.complain("node {} is the child of another", node);
        if (seenIn[node] == &place.json()) entry.complain("node {} stands there twice", node);
        seenIn[node] = &place.json();
    }
}

}  // namespace

void checkNodes(const Place& root, const TableSizes& sizes) {
    root.each("skins", [&](const Place& place) {
        if (place.length("joints") == 0) place.complain("has no joints");
        place.indices("joints", sizes.nodes);
        place.index("inverseBindMatrices", sizes.accessors);
        place.index("skeleton", sizes.nodes);
    });
    root.each("nodes", [&](const Place& place) { checkNode(place, sizes); });
    if (!root.ok()) return;
    const std::vector<size_t> parents = findParents(root, sizes.nodes);
    if (!root.ok()) return;
    checkCycles(root, parents);
    std::vector<const Json*> seenIn(sizes.nodes, nullptr);
    root.each("scenes", [&](const Place& place) { checkScene(place, parents, seenIn); });
    root.index("scene", sizes.scenes);
}

}  // namespace lampyris::assets
