// The rooms hold light in: every edge of the walls is shared, and walls are thick.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "courtyard/courtyard.h"
#include "courtyard/floor_plan.h"
#include "unit/courtyard/world_facts.h"

namespace lampyris::courtyard {
namespace {

using Edge = std::array<float, 6>;

Edge edgeOf(glm::vec3 a, glm::vec3 b) {
    const auto key = [](const glm::vec3& v) { return std::array<float, 3>{v.x, v.y, v.z}; };
    if (key(b) < key(a)) std::swap(a, b);
    return {a.x, a.y, a.z, b.x, b.y, b.z};
}

TEST(Walls, AreWatertightButForTheOpenSky) {
    const ecs::World world = makeCourtyard();
    const auto& meshes = world.resource<scene::Library>().meshes();
    std::map<Edge, int> uses;
    for (const char* name :
         {"walls", "west wall", "arcade's wall", "study's walls", "ceilings", "floors"}) {
        const ecs::Entity entity = test::named(world, name);
        const auto& mesh = *meshes[world.get<scene::MeshInstance>(entity).mesh.value].value;
        for (size_t i = 0; i < mesh.indices.size(); i += 3)
            for (size_t k = 0; k < 3; ++k)
                ++uses[edgeOf(mesh.positions[mesh.indices[i + k]],
                              mesh.positions[mesh.indices[i + (k + 1) % 3]])];
    }
    for (const auto& [edge, count] : uses) {
        const bool atTheSky = edge[1] == kRoofY && edge[4] == kRoofY;
        EXPECT_TRUE(count % 2 == 0 || atTheSky)
            << edge[0] << ' ' << edge[1] << ' ' << edge[2] << " to " << edge[3] << ' ' << edge[4]
            << ' ' << edge[5];
    }
}

TEST(Walls, BetweenRoomsAre20CentimetresOrMore) {
    const std::vector<Room> all = rooms();
    for (const Room& a : all)
        for (const Room& b : all)
            for (int axis = 0; axis < 3; ++axis) {
                const float gap = b.lower[axis] - a.upper[axis];
                const int u = (axis + 1) % 3;
                const int v = (axis + 2) % 3;
                const bool opposite = a.lower[u] < b.upper[u] && b.lower[u] < a.upper[u] &&
                                      a.lower[v] < b.upper[v] && b.lower[v] < a.upper[v];
                if (opposite && gap > 1e-4f) {
                    EXPECT_GE(gap, 0.2f);
                }
            }
}

}  // namespace
}  // namespace lampyris::courtyard
