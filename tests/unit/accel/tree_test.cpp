#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "accel/tree_builder.h"

namespace lampyris::accel {
namespace {

std::vector<math::Bounds> randomBoxes(uint32_t count, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-10.0f, 10.0f);
    std::vector<math::Bounds> boxes(count);
    for (math::Bounds& box : boxes) {
        const glm::vec3 at(uniform(random), uniform(random), uniform(random));
        box.grow(at);
        box.grow(at + glm::vec3(0.05f * uniform(random)));
    }
    return boxes;
}

Tree built(const std::vector<math::Bounds>& boxes, uint32_t leafSize) {
    TreeBuilder builder;
    auto tree = builder.build(static_cast<uint32_t>(boxes.size()), leafSize,
                              [&](uint32_t i, math::Bounds& box) {
                                  box = boxes[i];
                                  return true;
                              });
    if (!tree.ok()) ADD_FAILURE() << tree.error().message;
    return std::move(tree).value();
}

/// Calls `leaf` for every leaf with the box that its parent has for it and the inner nodes above
/// it.
void visit(const Tree& tree, uint32_t link, const math::Bounds& box, uint32_t depth,
           const std::function<void(uint32_t, const math::Bounds&, uint32_t)>& leaf) {
    if (isLeaf(link)) return leaf(link, box, depth);
    const Node& node = tree.nodes[linkIndex(link)];
    visit(tree, node.leftLink, fromCells(tree.grid, node.leftBox), depth + 1, leaf);
    visit(tree, node.rightLink, fromCells(tree.grid, node.rightBox), depth + 1, leaf);
}

class TreeOfSize : public ::testing::TestWithParam<std::pair<uint32_t, uint32_t>> {};

TEST_P(TreeOfSize, HoldsEveryPrimitiveOnceInsideItsBox) {
    const uint32_t count = GetParam().first, leafSize = GetParam().second;
    const auto boxes = randomBoxes(count, 7);
    const Tree tree = built(boxes, leafSize);
    std::vector<uint32_t> seen(count, 0);
    uint32_t deepest = 0;
    const auto check = [&](uint32_t link, const math::Bounds& outer, uint32_t depth) {
        deepest = std::max(deepest, depth);
        EXPECT_LE(leafCount(link), leafSize);
        for (uint32_t i = 0; i < leafCount(link); ++i) {
            const uint32_t primitive = tree.order[linkIndex(link) + i];
            ++seen[primitive];
            if (depth == 0) continue;  // the root has no box
            EXPECT_TRUE(glm::all(glm::lessThan(outer.lower, boxes[primitive].lower)));
            EXPECT_TRUE(glm::all(glm::greaterThan(outer.upper, boxes[primitive].upper)));
        }
    };
    visit(tree, tree.rootLink, tree.bounds, 0, check);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1u), count);
    EXPECT_EQ(tree.depth, deepest);
}

INSTANTIATE_TEST_SUITE_P(Sizes, TreeOfSize,
                         ::testing::Values(std::pair{1u, 4u}, std::pair{2u, 1u}, std::pair{3u, 4u},
                                           std::pair{5u, 4u}, std::pair{1000u, 1u},
                                           std::pair{50000u, 4u}));

TEST(Grid, WidensBoxesByOneToThreeCells) {
    const math::Bounds bounds{glm::vec3(-3.0f, 100.0f, 2.0f), glm::vec3(7.0f, 100.0f, 2.5f)};
    const auto grid = gridAround(bounds);
    const glm::vec3 cell(grid.cell);
    EXPECT_GT(cell.y, 1e-5f) << "a flat side has cells too, larger than a float's rounding";
    for (const math::Bounds& box :
         {bounds, math::Bounds{glm::vec3(1.0f, 100.0f, 2.25f), glm::vec3(1.5f, 100.0f, 2.3f)}}) {
        const math::Bounds wider = fromCells(grid, toCells(grid, box));
        for (int i = 0; i < 3; ++i) {
            EXPECT_GT(box.lower[i] - wider.lower[i], 0.9f * cell[i]);
            EXPECT_LT(box.lower[i] - wider.lower[i], 3.1f * cell[i]);
            EXPECT_GT(wider.upper[i] - box.upper[i], 0.9f * cell[i]);
            EXPECT_LT(wider.upper[i] - box.upper[i], 3.1f * cell[i]);
        }
    }
}

TEST(Tree, IsEmptyWithoutPrimitives) {
    const Tree tree = built({}, 4);
    EXPECT_EQ(tree.rootLink, shared::BVH_NOTHING);
    EXPECT_TRUE(tree.nodes.empty());
}

TEST(Tree, LeavesOutWhatHasNoBox) {
    TreeBuilder builder;
    const auto tree = builder.build(10, 4, [](uint32_t i, math::Bounds& box) {
        box.grow(glm::vec3(static_cast<float>(i)));
        return i % 2 == 0;
    });
    ASSERT_TRUE(tree.ok());
    auto order = tree->order;
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (std::vector<uint32_t>{0, 2, 4, 6, 8}));
}

TEST(Tree, IsTheSameEveryTime) {
    const auto boxes = randomBoxes(30000, 3);
    const Tree first = built(boxes, 4), second = built(boxes, 4);
    EXPECT_EQ(first.order, second.order);
    EXPECT_EQ(first.depth, second.depth);
    EXPECT_EQ(first.nodes.size(), second.nodes.size());
}

TEST(Tree, EndsForBoxesThatCannotBeSplit) {
    const std::vector<math::Bounds> boxes(5000, math::Bounds{glm::vec3(1.0f), glm::vec3(2.0f)});
    const Tree tree = built(boxes, 4);
    EXPECT_EQ(tree.order.size(), 5000u);
    EXPECT_LE(tree.depth, 64u);
}

TEST(Tree, StaysShallowWhereTheHeuristicWouldPeelOffOneByOne) {
    std::vector<math::Bounds> boxes;
    // Each box is a little smaller than the last, towards one corner.
    float size = 1e30f;
    for (int i = 0; i < 4000; ++i, size *= 0.97f)
        boxes.push_back({glm::vec3(size), glm::vec3(size * 1.01f)});
    const Tree tree = built(boxes, 1);
    EXPECT_EQ(tree.order.size(), boxes.size());
    EXPECT_LE(tree.depth, 64u);
}

TEST(Tree, MovesItsLinks) {
    Tree tree = built(randomBoxes(20, 5), 4);
    const Tree before = tree;
    relocate(tree, 100, 1000);
    EXPECT_EQ(tree.rootLink, 100u);
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
        const uint32_t was = before.nodes[i].leftLink, is = tree.nodes[i].leftLink;
        EXPECT_EQ(isLeaf(is), isLeaf(was));
        EXPECT_EQ(linkIndex(is), linkIndex(was) + (isLeaf(was) ? 1000u : 100u));
        if (isLeaf(was)) {
            EXPECT_EQ(leafCount(is), leafCount(was));
        }
    }
    EXPECT_EQ(relocated(shared::BVH_NOTHING, 1, 1), shared::BVH_NOTHING);
}

}  // namespace
}  // namespace lampyris::accel
