// The refit nodes against their twin on the CPU, bit for bit.
#include "accel/refit_nodes.h"
#include "accel/tree_store.h"
#include "execute/executor.h"
#include "residency/pack_scene.h"
#include "support/deformations.h"
#include "support/gpu_test.h"

namespace lampyris::test {
namespace {

using accel::Blas;
using accel::LeafTriangle;
using accel::Node;

/// Trees on the device beside the same on the CPU.
class Grove {
 public:
    struct Tree {
        assets::Mesh mesh;
        Blas blas;  ///< links as on the device
        accel::TreeRange range;
        accel::RefitSlots slots;
        uint32_t firstVertex = 0, firstIndex = 0;
        accel::RefitQuality quality;
    };

    explicit Grove(gpu::Device& device)
        : store(device),
          positions(device, "posed positions", sizeof(residency::DevicePosition)),
          indices(device, "indices", sizeof(uint32_t)),
          executor(need(execute::Executor::create(device))) {}

    void add(assets::Mesh mesh) {
        Tree tree;
        tree.mesh = std::move(mesh);
        tree.blas = posedBlasOf(tree.mesh);
        tree.slots = accel::listSlots(tree.blas.tree);
        tree.range = store.take(tree.blas.tree.nodes.size(), tree.blas.triangles.size(),
                                tree.slots.texels.size());
        relocate(tree.blas.tree, tree.range);
        tree.firstVertex = vertices;
        tree.firstIndex = indexCount;
        vertices += static_cast<uint32_t>(tree.mesh.positions.size());
        indexCount += static_cast<uint32_t>(tree.mesh.indices.size());
        trees.push_back(std::move(tree));
    }

    void load() {
        need(store.reserve());
        need(positions.reserve(vertices * sizeof(residency::DevicePosition)));
        need(indices.reserve(indexCount * sizeof(uint32_t)));
        const auto put = [](residency::ResidentBuffer& buffer, uint64_t offset, const auto& data) {
            need(buffer.stage(offset, std::as_bytes(std::span(data))));
        };
        for (const Tree& tree : trees) {
            put(store.nodes, tree.range.firstNode * sizeof(Node), tree.blas.tree.nodes);
            put(store.triangles, tree.range.firstTriangle * sizeof(LeafTriangle),
                tree.blas.triangles);
            put(store.slots, tree.range.firstSlot * sizeof(uint32_t), tree.slots.texels);
            put(positions, tree.firstVertex * sizeof(residency::DevicePosition),
                residency::packPositions(tree.mesh.positions));
            put(indices, tree.firstIndex * sizeof(uint32_t), tree.mesh.indices);
        }
    }

    /// Moves one tree's vertices, and its boxes on the CPU.
    accel::RefitJob move(uint32_t index, const std::vector<glm::vec3>& to) {
        Tree& tree = trees[index];
        const auto packed = residency::packPositions(to);
        need(positions.stage(tree.firstVertex * sizeof(residency::DevicePosition),
                             std::as_bytes(std::span(packed))));
        tree.blas.tree.grid = accel::gridAround(finiteBounds(to));
        const auto corners = accel::leafCorners(tree.blas.tree, tree.mesh.indices);
        tree.quality = accel::refitOnCpu(
            {tree.blas.tree, static_cast<uint32_t>(tree.range.firstNode),
             static_cast<uint32_t>(tree.range.firstTriangle), tree.blas.triangles, corners},
            to);
        return {tree.blas.tree.grid,
                static_cast<uint32_t>(tree.range.firstNode),
                static_cast<uint32_t>(tree.range.nodes),
                static_cast<uint32_t>(tree.range.firstSlot),
                tree.slots.levels,
                tree.firstVertex,
                tree.firstIndex};
    }

    struct Result {
        std::vector<std::byte> nodes, triangles, quality;
    };
    Result run(const std::vector<accel::RefitJob>& jobs, bool large = false) {
        graph::Frame frame;
        const auto refitted = addRefit(
            frame,
            {store.nodes.import(frame, "upload nodes"),
             store.triangles.import(frame, "upload triangles"),
             store.slots.import(frame, "upload slots"), positions.import(frame, "upload positions"),
             indices.import(frame, "upload indices"), large},
            jobs);
        execute::RunOptions options;
        options.readBackBuffers = {refitted.nodes, refitted.triangles, refitted.quality};
        for (const auto buffer : options.readBackBuffers) frame.output(buffer);
        auto done = need(executor.run(frame, options));
        return {done.buffers[0], done.buffers[1], done.buffers[2]};
    }

    void expectSame(const Result& result) const {
        for (size_t i = 0; i < trees.size(); ++i) {
            const Tree& tree = trees[i];
            EXPECT_EQ(std::memcmp(result.nodes.data() + tree.range.firstNode * sizeof(Node),
                                  tree.blas.tree.nodes.data(),
                                  tree.blas.tree.nodes.size() * sizeof(Node)),
                      0)
                << "nodes of tree " << i;
            EXPECT_EQ(
                std::memcmp(
                    result.triangles.data() + tree.range.firstTriangle * sizeof(LeafTriangle),
                    tree.blas.triangles.data(), tree.blas.triangles.size() * sizeof(LeafTriangle)),
                0)
                << "triangles of tree " << i;
        }
    }

    std::vector<Tree> trees;
    accel::TreeStore store;
    residency::ResidentBuffer positions, indices;
    execute::Executor executor;
    uint32_t vertices = 0, indexCount = 0;
};

class RefitNodesTest : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (IsSkipped()) return;
        grove.emplace(device());
        for (const uint32_t count : {1u, 700u, 2u, 20000u, 64u, 5u})
            grove->add(triangleSoup(count, 0.2f, count));
        grove->load();
    }
    std::optional<Grove> grove;
};

/// Each deformation, written to storage buffers and, as where those are too small, to texels.
std::vector<std::pair<Deformation, bool>> everyWay() {
    std::vector<std::pair<Deformation, bool>> ways;
    for (const bool large : {false, true})
        for (const Deformation how : kDeformations) ways.emplace_back(how, large);
    return ways;
}

TEST_F(RefitNodesTest, GiveTheBoxesOfTheCpu) {
    uint32_t seed = 1;
    for (const auto& [how, large] : everyWay()) {
        std::vector<accel::RefitJob> jobs;
        std::vector<uint32_t> nodes, moved;
        for (uint32_t i = 0; i < grove->trees.size(); ++i) {
            if (how != Deformation::None && (i + seed) % 3 == 0) continue;  // stays
            jobs.push_back(grove->move(i, deformed(grove->trees[i].mesh, how, ++seed)));
            nodes.push_back(jobs.back().nodes);
            moved.push_back(i);
        }
        const auto result = grove->run(jobs, large);
        grove->expectSame(result);
        const auto quality = accel::readQuality(nodes, result.quality);
        for (size_t k = 0; k < moved.size(); ++k) {
            const auto& tree = grove->trees[moved[k]];
            EXPECT_EQ(quality[k].dropped, tree.quality.dropped);
            EXPECT_NEAR(quality[k].cost, tree.quality.cost, 1e-6 * quality[k].cost);
            EXPECT_DOUBLE_EQ(tree.quality.cost, costOf(tree.blas.tree));
        }
    }
}

TEST_F(RefitNodesTest, ChangeNothingWhereNothingMoved) {
    std::vector<accel::RefitJob> jobs;
    for (uint32_t i = 0; i < grove->trees.size(); ++i) {
        const auto before = grove->trees[i].blas.tree.nodes;
        jobs.push_back(grove->move(i, grove->trees[i].mesh.positions));
        EXPECT_EQ(std::memcmp(before.data(), grove->trees[i].blas.tree.nodes.data(),
                              before.size() * sizeof(Node)),
                  0);
    }
    grove->expectSame(grove->run(jobs));
}

}  // namespace
}  // namespace lampyris::test
