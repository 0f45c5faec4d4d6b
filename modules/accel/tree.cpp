#include "accel/tree.h"

namespace lampyris::accel {

uint32_t relocated(uint32_t link, uint32_t nodeOffset, uint32_t leafOffset) {
    if (link == shared::BVH_NOTHING) return link;
    return link + (isLeaf(link) ? leafOffset : nodeOffset);
}

void relocate(Tree& tree, uint32_t nodeOffset, uint32_t leafOffset) {
    tree.rootLink = relocated(tree.rootLink, nodeOffset, leafOffset);
    for (Node& node : tree.nodes) {
        node.leftLink = relocated(node.leftLink, nodeOffset, leafOffset);
        node.rightLink = relocated(node.rightLink, nodeOffset, leafOffset);
    }
}

}  // namespace lampyris::accel
