#include "accel/tlas.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "support/snapshot_builder.h"

namespace lampyris::accel {
namespace {

constexpr uint32_t kOffset = 64;

/// A scene of instances of one mesh, and where its tree is said to stand.
struct Scene : test::SnapshotBuilder {
    Scene() {
        addMesh(test::triangleSoup(10, 0.3f, 1));
        addMaterial(test::mattMaterial());
        places = {{777, 3, snapshot.meshes[0].value->bounds, {}}};
    }
    Tlas built() {
        TreeBuilder builder;
        std::vector<BlasPlace> ofInstances;
        for (const auto& instance : snapshot.instances)
            ofInstances.push_back(places[instance.mesh]);
        auto tlas = buildTlas(builder, snapshot, ofInstances, kOffset);
        if (!tlas.ok()) ADD_FAILURE() << tlas.error().message;
        return std::move(tlas).value();
    }
    std::vector<BlasPlace> places;  ///< by mesh
};

/// The instances that a link leads to.
void collect(const Tlas& tlas, uint32_t link, std::multiset<uint32_t>& instances) {
    const Node& node = tlas.nodes.at(linkIndex(link) - kOffset);
    if ((link & shared::BVH_INSTANCE) != 0) {
        shared::GpuBvhInstance record{};
        std::memcpy(&record, &node, sizeof(record));
        EXPECT_EQ(record.rootLink, 777u);
        instances.insert(record.instance);
        return;
    }
    collect(tlas, node.leftLink, instances);
    collect(tlas, node.rightLink, instances);
}

TEST(Tlas, LeadsToEveryInstanceOnce) {
    Scene scene;
    for (uint32_t i = 0; i < 100; ++i) scene.addInstance(0, 0, test::anyTransform(i, i % 2 == 0));
    const Tlas tlas = scene.built();
    std::multiset<uint32_t> instances;
    collect(tlas, tlas.root.link, instances);
    EXPECT_EQ(instances.size(), 100u);
    EXPECT_EQ(std::set<uint32_t>(instances.begin(), instances.end()).size(), 100u);
    EXPECT_LE(tlas.nodes.size(), tlasCapacity(100));
    EXPECT_GT(tlas.depth, 3u + 5u);
    EXPECT_EQ(tlas.root.instance, shared::BVH_NOTHING);
}

TEST(Tlas, BeginsInTheTreeOfASingleInstanceAtTheIdentity) {
    Scene scene;
    scene.addInstance(0, 0);
    const Tlas tlas = scene.built();
    EXPECT_EQ(tlas.root.link, 777u);
    EXPECT_EQ(tlas.root.instance, 0u);
    EXPECT_TRUE(tlas.nodes.empty());
    EXPECT_EQ(tlas.depth, 3u);
}

TEST(Tlas, LeavesOutWhatCannotBeHit) {
    Scene scene;
    scene.addMesh({});
    scene.places.push_back({});
    scene.addInstance(1, 0);                                                // no triangles
    scene.addInstance(0, 0, glm::mat4(0.0f));                               // a point
    scene.addInstance(0, 0, glm::scale(glm::mat4(1), glm::vec3(2, 0, 1)));  // flat, but there
    const Tlas tlas = scene.built();
    std::multiset<uint32_t> instances;
    collect(tlas, tlas.root.link, instances);
    EXPECT_EQ(instances, (std::multiset<uint32_t>{2}));
}

TEST(Tlas, HasNoRootWithoutInstances) {
    Scene scene;
    EXPECT_EQ(scene.built().root.link, shared::BVH_NOTHING);
}

}  // namespace
}  // namespace lampyris::accel
