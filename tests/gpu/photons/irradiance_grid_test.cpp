#include "photons/irradiance_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "glm/gtc/packing.hpp"
#include "support/frame_test.h"
#include "support/scene_frame.h"
#include "support/small_scenes.h"

namespace lampyris::photons {
namespace {

constexpr float kCell = 0.5f;

struct Filled {
    std::vector<shared::PackedPhoton> photons;
    uint32_t stored = 0;
    std::vector<uint32_t> table;
    std::vector<shared::GridCell> cells;
    std::vector<glm::uvec4> lookUp;
    shared::FrameCounters counters{};
    shared::GridParams params{};
    float powerScale = 1.0f;

    [[nodiscard]] uint32_t slotOf(size_t cell) const {
        return cells[cell].faceSlot >> shared::GRID_FACE_BITS;
    }
    [[nodiscard]] double power(size_t cell, uint32_t channel) const {
        const size_t word = size_t{slotOf(cell)} * shared::GRID_SLOT_WORDS + channel;
        return (table[word + shared::GRID_WORD_LOW] +
                0x1p32 * table[word + shared::GRID_WORD_HIGH]) /
               shared::GRID_POWER_UNITS;
    }
    [[nodiscard]] double areaMetres2(size_t cell) const {
        const size_t word = size_t{slotOf(cell)} * shared::GRID_SLOT_WORDS;
        return double{kCell} * double{kCell} * table[word + shared::GRID_WORD_AREA] /
               (double{shared::GRID_AREA_UNITS} * params.columns);
    }
};

class IrradianceGridTest : public test::FrameTest {
 protected:
    static Filled fill(const scene::SceneSnapshot& snapshot, uint32_t paths, uint32_t slots) {
        test::SceneFrame on(device(), snapshot);
        const auto split = splitPaths(listEmitters(snapshot.lights, on.scene.emitters()), paths);
        const TraceSettings settings{4, true, 1, paths * 4, true};
        const auto list = addPhotonTrace(on.frame, on.handles, on.tree, split, {0, split.paths},
                                         settings, on.counters);
        auto cells = beginGrid(on.frame, {kCell, slots, 64, 1}, split.powerScale, list.counters);
        cells = addToGrid(on.frame, cells, list, on.handles, on.tree);
        const auto grid = finishGrid(on.frame, cells, on.handles, on.tree);
        const auto result =
            on.run({list.photons, grid.table, cells.cells, cells.counters, grid.lookUp});
        Filled filled;
        filled.photons = test::valuesOf<shared::PackedPhoton>(result.buffers[0]);
        filled.table = test::valuesOf<uint32_t>(result.buffers[1]);
        filled.cells = test::valuesOf<shared::GridCell>(result.buffers[2]);
        filled.counters = test::valuesOf<shared::FrameCounters>(result.buffers[3]).front();
        filled.lookUp = test::valuesOf<glm::uvec4>(result.buffers[4]);
        filled.stored = filled.counters.photonsStored;
        filled.cells.resize(std::min<size_t>(filled.counters.cells, filled.cells.size()));
        filled.params = cells.params;
        filled.powerScale = split.powerScale;
        return filled;
    }

    /// A closed room of 4 × 3 × 5 m with a box of 1 m on its floor.
    static scene::SceneSnapshot roomWithBox() {
        scene::SceneSnapshot snapshot;
        const auto grey = test::lambertian(glm::vec3(0.6f));
        addBox(snapshot, {-2.0f, 0.0f, -2.5f}, {2.0f, 3.0f, 2.5f}, grey, true);
        addBox(snapshot, {-0.3f, 0.0f, -0.8f}, {0.7f, 1.0f, 0.2f}, grey, false);
        test::addLight(snapshot, {-1.2f, 2.0f, 1.1f}, 0.1f, 100.0f);
        return snapshot;
    }

 private:
    static void addBox(scene::SceneSnapshot& snapshot, const glm::vec3& a, const glm::vec3& b,
                       const assets::Material& material, bool inwards) {
        const auto side = [&](const std::array<glm::vec3, 4>& v) {
            test::addInstance(
                snapshot,
                inwards ? test::quad(v[3], v[2], v[1], v[0]) : test::quad(v[0], v[1], v[2], v[3]),
                material);
        };
        side({glm::vec3{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}});
        side({glm::vec3{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}});
        side({glm::vec3{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}});
        side({glm::vec3{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}});
        side({glm::vec3{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}});
        side({glm::vec3{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}});
    }
};

TEST_F(IrradianceGridTest, HoldsThePowerOfEveryPhotonInTheCellThatThePhotonIsIn) {
    const Filled filled = fill(test::builtinSnapshot("two_rooms"), 3000, 1u << 16);
    EXPECT_EQ(filled.counters.cellsDropped, 0u);
    ASSERT_GT(filled.cells.size(), 500u);
    // A twin by place alone: the parts and faces of a place summed.
    using At = std::array<int, 3>;
    std::map<At, double> twin;
    std::map<At, double> found;
    for (uint32_t i = 0; i < filled.stored; ++i) {
        const auto& photon = filled.photons[i];
        At at{};
        for (int c = 0; c < 3; ++c)
            at[static_cast<size_t>(c)] =
                static_cast<int>(std::floor(std::bit_cast<float>(photon.positionPower[c]) / kCell +
                                            filled.params.offsetCell[c]));
        twin[at] += static_cast<double>(glm::unpackHalf2x16(photon.positionPower.w).x);
    }
    double total = 0.0;
    for (size_t i = 0; i < filled.cells.size(); ++i) {
        const auto& cell = filled.cells[i];
        found[{static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)}] +=
            filled.power(i, 0);
        total += filled.power(i, 0);
    }
    double difference = 0.0;
    double expected = 0.0;
    for (const auto& [at, power] : twin) {
        expected += power;
        difference += std::abs(power - found[at]);
    }
    EXPECT_NEAR(total, expected, 1e-5 * expected);  // rounding to 2^-20, each
    EXPECT_LT(difference, 1e-3 * expected);         // a photon on a border may fall either way
}

TEST_F(IrradianceGridTest, MeasuresTheSurfaceThatLightCanReach) {
    const Filled filled = fill(roomWithBox(), 200000, 1u << 16);
    double area = 0.0;
    for (size_t i = 0; i < filled.cells.size(); ++i) area += filled.areaMetres2(i);
    // Walls, the box's five open sides, and the floor but for what the box stands on.
    const double walls = 2.0 * (4.0 * 3.0 + 4.0 * 5.0 + 3.0 * 5.0);
    EXPECT_NEAR(area, walls + 5.0 - 1.0, 0.01 * walls);
}

TEST_F(IrradianceGridTest, GivesPowerOverArea) {
    const Filled filled = fill(roomWithBox(), 20000, 1u << 16);
    int compared = 0;
    for (size_t i = 0; i < filled.cells.size(); ++i) {
        if (filled.areaMetres2(i) < 0.1) continue;
        const float found = std::bit_cast<float>(filled.lookUp[filled.slotOf(i)].y);
        const double expected =
            filled.power(i, 1) * static_cast<double>(filled.powerScale) / filled.areaMetres2(i);
        EXPECT_NEAR(found, expected, 1e-4 * expected);
        ++compared;
    }
    EXPECT_GT(compared, 200);
}

TEST_F(IrradianceGridTest, CountsThePhotonsThatFindNoRoom) {
    const Filled filled = fill(test::builtinSnapshot("two_rooms"), 3000, 256);
    EXPECT_GT(filled.counters.cellsDropped, 1000u);
}

}  // namespace
}  // namespace lampyris::photons
