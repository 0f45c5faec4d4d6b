#include "graph/order.h"

#include <algorithm>
#include <set>

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class Order : public GraphTest {};

TEST_F(Order, FollowsDeclarationWhereNothingElseDecides) {
    for (const char* name : {"c", "a", "b"}) frame.output(source(name));
    EXPECT_EQ(names(compiled()), (Texts{"c", "a", "b"}));
}

TEST_F(Order, APureWriteWaitsForReadersOfWhatItDestroys) {
    const Buffer first = source("write");
    auto reader = compute("read");
    reader.read(0, first);
    frame.output(reader.write(1, frame.buffer("copy", kBytes)));
    frame.output(compute("rewrite").write(0, first));
    for (uint64_t seed = 0; seed < 40; ++seed) {
        EXPECT_EQ(names(compiled({.randomOrderSeed = seed})), (Texts{"write", "read", "rewrite"}));
    }
}

TEST_F(Order, HoldsThroughCulledNodes) {
    // Only the culled node links the reader with the last writer.
    const Buffer first = source("write");
    auto reader = compute("read");
    reader.read(0, first);
    frame.output(reader.write(1, frame.buffer("copy", kBytes)));
    const Buffer unused = compute("culled").write(0, first);
    frame.output(compute("last").write(0, unused));
    for (uint64_t seed = 0; seed < 40; ++seed) {
        EXPECT_EQ(names(compiled({.randomOrderSeed = seed})), (Texts{"write", "read", "last"}));
    }
}

TEST_F(Order, RandomOrdersAreManyAndRepeatable) {
    for (const char* name : {"a", "b", "c", "d"}) frame.output(source(name));
    std::set<Texts> orders;
    for (uint64_t seed = 1; seed <= 200; ++seed) {
        const Texts order = names(compiled({.randomOrderSeed = seed}));
        EXPECT_EQ(names(compiled({.randomOrderSeed = seed})), order);
        orders.insert(order);
    }
    EXPECT_EQ(orders.size(), 24u);
}

TEST_F(Order, HandlesFromTheFutureAreFollowed) {
    const Buffer buffer = frame.buffer("x", kBytes);
    auto reader = compute("reader");
    reader.read(0, Buffer{buffer.resource, 1});
    frame.output(reader.write(1, frame.buffer("y", kBytes)));
    (void)compute("writer").write(0, buffer);
    EXPECT_EQ(names(compiled()), (Texts{"writer", "reader"}));
}

TEST_F(Order, NamesTheCycle) {
    const Buffer x = frame.buffer("x", kBytes);
    const Buffer y = frame.buffer("y", kBytes);
    frame.output(source("apart"));
    auto first = compute("first");
    first.read(0, Buffer{y.resource, 1});
    const Buffer newX = first.write(1, x);
    auto second = compute("second");
    second.read(0, newX);
    frame.output(second.write(1, y));
    EXPECT_EQ(failure(),
              "render graph: a cycle: 'first' -> 'second' (through 'x') -> 'first' (through 'y')");
}

}  // namespace
}  // namespace lampyris::graph
