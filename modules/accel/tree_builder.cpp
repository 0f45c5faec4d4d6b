#include "accel/tree_builder.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <new>
#include <span>

#include "core/check.h"

namespace lampyris::accel {
namespace {

// Deep enough for the SAH to have its way, and a stack of 64 entries in the shader. Embree keeps
// the last 8 levels for halving what is still too large for a leaf. [chosen]
constexpr uint32_t kMaxDepth = 64;

constexpr uint32_t kMaxLeaf = 4;

#ifdef __SANITIZE_THREAD__
// Embree's and TBB's own synchronisation is not instrumented: their threads would look like races.
constexpr const char* kDeviceConfig = "threads=1";
#else
constexpr const char* kDeviceConfig = nullptr;
#endif

/// What Embree's callbacks build: an inner node where count is 0, else a leaf.
struct Branch {
    uint32_t count = 0;
    std::array<uint32_t, kMaxLeaf> primitives{};
    std::array<Branch*, 2> children{};
    std::array<RTCBounds, 2> boxes{};
};

void* createNode(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Branch), 16)) Branch;
}

void setChildren(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i)
        static_cast<Branch*>(node)->children[i] = static_cast<Branch*>(children[i]);
}

void setBounds(void* node, const RTCBounds** boxes, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<Branch*>(node)->boxes[i] = *boxes[i];
}

void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                 size_t count, void*) {
    auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(Branch), 16)) Branch;
    leaf->count = static_cast<uint32_t>(count);
    for (size_t i = 0; i < count; ++i) leaf->primitives[i] = primitives[i].primID;
    // Embree's threads leave them in any order.
    std::sort(leaf->primitives.begin(), leaf->primitives.begin() + count);
    return leaf;
}

std::vector<RTCBuildPrimitive> collect(uint32_t count, const BoxOf& boxOf, math::Bounds& bounds) {
    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        math::Bounds box;
        if (!boxOf(i, box)) continue;
        primitives.push_back(
            {box.lower.x, box.lower.y, box.lower.z, 0, box.upper.x, box.upper.y, box.upper.z, i});
        bounds.grow(box);
    }
    return primitives;
}

/// Turns Embree's branches into nodes in preorder, without recursion: trees may be deep.
class Flattening {
 public:
    explicit Flattening(Tree& tree) : tree_(&tree) {}

    void run(const Branch* root) {
        tree_->rootLink = place(root, 0);
        while (!open_.empty()) {
            const Open next = open_.back();
            open_.pop_back();
            const uint32_t link = place(next.branch, next.depth);
            Node& parent = tree_->nodes[next.parent];
            (next.right ? parent.rightLink : parent.leftLink) = link;
        }
    }

 private:
    struct Open {
        const Branch* branch;
        uint32_t parent;
        uint32_t depth;
        bool right;
    };

    uint32_t place(const Branch* branch, uint32_t depth) {
        if (branch->count > 0) {
            tree_->depth = std::max(tree_->depth, depth);
            const auto first = static_cast<uint32_t>(tree_->order.size());
            tree_->order.insert(tree_->order.end(), branch->primitives.begin(),
                                branch->primitives.begin() + branch->count);
            return leafLink(first, branch->count);
        }
        const auto index = static_cast<uint32_t>(tree_->nodes.size());
        Node node;
        node.leftBox = cellsOf(branch->boxes[0]);
        node.rightBox = cellsOf(branch->boxes[1]);
        tree_->nodes.push_back(node);
        // The left part comes off the stack first, and so follows its parent.
        open_.push_back({branch->children[1], index, depth + 1, true});
        open_.push_back({branch->children[0], index, depth + 1, false});
        return index;
    }

    [[nodiscard]] CellBox cellsOf(const RTCBounds& box) const {
        return toCells(tree_->grid, {glm::vec3(box.lower_x, box.lower_y, box.lower_z),
                                     glm::vec3(box.upper_x, box.upper_y, box.upper_z)});
    }

    Tree* tree_;
    std::vector<Open> open_;
};

RTCBuildArguments arguments(std::span<RTCBuildPrimitive> primitives, uint32_t leafSize,
                            RTCBVH bvh) {
    RTCBuildArguments args = rtcDefaultBuildArguments();
    args.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    args.maxDepth = kMaxDepth;
    args.maxLeafSize = leafSize;
    args.bvh = bvh;
    args.primitives = primitives.data();
    args.primitiveCount = primitives.size();
    args.primitiveArrayCapacity = primitives.size();
    args.createNode = createNode;
    args.setNodeChildren = setChildren;
    args.setNodeBounds = setBounds;
    args.createLeaf = createLeaf;
    return args;
}

/// Embree's tree while it is being flattened.
class ScopedBvh {
 public:
    explicit ScopedBvh(RTCDevice device) : bvh_(rtcNewBVH(device)) {}
    ~ScopedBvh() { rtcReleaseBVH(bvh_); }
    ScopedBvh(const ScopedBvh&) = delete;
    ScopedBvh& operator=(const ScopedBvh&) = delete;
    [[nodiscard]] RTCBVH get() const { return bvh_; }

 private:
    RTCBVH bvh_;
};

}  // namespace

struct TreeBuilder::Device {
    Device() : handle(rtcNewDevice(kDeviceConfig)) {}
    ~Device() {
        if (handle != nullptr) rtcReleaseDevice(handle);
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    RTCDevice handle;
};

TreeBuilder::TreeBuilder() : device_(std::make_unique<Device>()) {}
TreeBuilder::~TreeBuilder() = default;
TreeBuilder::TreeBuilder(TreeBuilder&&) noexcept = default;
TreeBuilder& TreeBuilder::operator=(TreeBuilder&&) noexcept = default;

core::Result<Tree> TreeBuilder::build(uint32_t count, uint32_t leafSize, const BoxOf& boxOf) {
    CHECK(leafSize >= 1u);
    CHECK(leafSize <= kMaxLeaf);
    if (device_->handle == nullptr)
        return core::error("Embree: no device ({})", rtcGetDeviceError(nullptr));
    Tree tree;
    auto primitives = collect(count, boxOf, tree.bounds);
    if (primitives.empty()) return tree;
    const ScopedBvh bvh(device_->handle);
    RTCBuildArguments args = arguments(primitives, leafSize, bvh.get());
    const void* root = rtcBuildBVH(&args);
    if (root == nullptr) {
        // The SAH ran out of levels; the Morton builder halves space and stays shallow.
        args.buildQuality = RTC_BUILD_QUALITY_LOW;
        static_cast<void>(rtcGetDeviceError(device_->handle));
        root = rtcBuildBVH(&args);
    }
    if (root == nullptr)
        return core::error("Embree: a tree over {} primitives failed with error {}",
                           primitives.size(), rtcGetDeviceError(device_->handle));
    tree.grid = gridAround(tree.bounds);
    Flattening(tree).run(static_cast<const Branch*>(root));
    return tree;
}

}  // namespace lampyris::accel
