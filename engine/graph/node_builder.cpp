#include <algorithm>

#include "graph/frame.h"

namespace lampyris::graph {

void NodeBuilder::keep() {
    node().keep = true;
}

Node& NodeBuilder::node() {
    return frame_->nodes_[node_];
}

void NodeBuilder::use(const Use& use) {
    node().uses.push_back(use);
    // A handle from nowhere is recorded as it is: compile() says which node used it.
    if (use.resource >= frame_->resources_.size() || !writes(use.access)) return;
    uint32_t& versions = frame_->resources_[use.resource].versions;
    versions = std::max(versions, use.writtenVersion + 1);
}

Image NodeBuilder::useImage(Image image, Use declared) {
    declared.isImage = true;
    declared.resource = image.resource;
    declared.version = image.version;
    if (writes(declared.access)) declared.writtenVersion = ++image.version;
    use(declared);
    return image;
}

Buffer NodeBuilder::useBuffer(Buffer buffer, Use declared) {
    declared.resource = buffer.resource;
    declared.version = buffer.version;
    if (writes(declared.access)) declared.writtenVersion = ++buffer.version;
    use(declared);
    return buffer;
}

}  // namespace lampyris::graph
