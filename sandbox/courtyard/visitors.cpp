#include "courtyard/visitors.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/lanterns.h"
#include "ecs/commands.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"
#include "scene/motion.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::hashBits;
using scene::builtin::hashSigned;
using scene::builtin::hashUnit;

constexpr float kFallMetresPerSecond = 0.55f;

/// When a slot's visitor comes and goes: it stays from `from` to `until` of each round's `period`.
struct Stay {
    double period, phase, from, until;
};

Stay stayOf(uint32_t slot) {
    if (slot < kCrateSlots) return {7.0 + slot, 1.7 * slot, 0.0, 4.0 + 0.6 * slot};
    if (slot < kLanternSlot) return {10.0, 0.41 * (slot - kCrateSlots), 0.0, 9.4};
    return {9.0, 2.0, 0.0, 5.0};
}

struct Guest {
    Visitor visitor;
    uint32_t seed;
    double sinceSeconds;
};

/// Who is in the slot at that time, if anyone.
std::optional<Guest> guestOf(uint32_t slot, double seconds, uint32_t seed) {
    const Stay stay = stayOf(slot);
    const double rounds = std::floor((seconds + stay.phase) / stay.period);
    const double start = rounds * stay.period - stay.phase;
    if (seconds - start < stay.from || seconds - start >= stay.until) return std::nullopt;
    const auto round = static_cast<int64_t>(rounds);
    const uint32_t own = hashBits(hashBits(seed, slot), static_cast<uint32_t>(round));
    return Guest{{slot, round}, own, start};
}

/// Stacks stand at the south and east of the square, out of everyone's way.
scene::Transform cratePlace(uint32_t slot, uint32_t seed) {
    constexpr std::array<glm::vec2, kCrateSlots> kSpots{{{-4.2f, 4.6f},
                                                         {-3.4f, 5.1f},
                                                         {-2.5f, 4.8f},
                                                         {5.9f, -4.0f},
                                                         {6.2f, -3.1f},
                                                         {5.1f, -4.6f},
                                                         {-0.6f, 4.9f},
                                                         {6.2f, 2.3f},
                                                         {-5.4f, -1.9f}}};
    const float size = 0.8f + 0.3f * hashUnit(seed, 0);
    return {{kSpots[slot].x, 0.03f + 0.3f * size, kSpots[slot].y},
            turned({0.0f, 1.0f, 0.0f}, hashUnit(seed, 1)),
            glm::vec3(size)};
}

void comeAsCrate(ecs::Commands& commands, ecs::NewEntity entity, const Stock& stock,
                 const Guest& guest) {
    commands.add(entity, cratePlace(guest.visitor.slot, guest.seed));
    const bool dyed = hashUnit(guest.seed, 2) < 0.5f;
    commands.add(entity,
                 scene::MeshInstance{stock.crate, dyed ? stock.dyes[guest.seed % 4] : stock.wood});
}

void comeAsLeaf(ecs::Commands& commands, ecs::NewEntity entity, const Stock& stock,
                const Guest& guest) {
    glm::vec3 from(5.6f * hashSigned(guest.seed, 0), 4.6f, 4.2f * hashSigned(guest.seed, 1));
    if (glm::length(glm::vec2(from.x - kFountain.x, from.z - kFountain.z)) < 2.0f) from.x += 4.0f;
    commands.add(entity, scene::Transform{from});
    commands.add(entity, Falling{from, guest.sinceSeconds, hashUnit(guest.seed, 2)});
    commands.add(entity, scene::MeshInstance{stock.leaf, stock.dyes[guest.seed % 2]});
}

/// On the ground, at one of three places.
void comeAsLantern(ecs::Commands& commands, ecs::NewEntity entity, const Stock& stock,
                   const Guest& guest) {
    constexpr std::array<glm::vec3, 3> kSpots{
        {{2.2f, 0.25f, -7.4f}, {5.3f, 0.25f, -1.9f}, {4.9f, 0.25f, -7.6f}}};
    commands.add(entity, scene::Transform{kSpots[guest.seed % 3]});
    commands.add(entity, scene::MeshInstance{stock.cage, stock.iron});
    commands.add(entity,
                 scene::SphereLight{.radiusMetres = 0.09f, .powerWatts = {210.0f, 70.0f, 120.0f}});
}

void come(ecs::Commands& commands, const Stock& stock, const Guest& guest) {
    const ecs::NewEntity entity = commands.create();
    commands.add(entity, guest.visitor);
    const uint32_t slot = guest.visitor.slot;
    commands.add(entity, scene::Name{"visitor " + std::to_string(slot)});
    if (slot < kCrateSlots) return comeAsCrate(commands, entity, stock, guest);
    if (slot < kLanternSlot) return comeAsLeaf(commands, entity, stock, guest);
    comeAsLantern(commands, entity, stock, guest);
}

/// Whoever is here and should not be, goes; whoever should be here and is not, comes.
void visit(const ecs::World& world, ecs::Commands& commands, const Stock& stock,
           const scene::FrameTime& time) {
    std::array<bool, kSlots> here{};
    for (const auto& [entity, visitor] : world.view<Visitor>()) {
        const auto due = guestOf(visitor.slot, time.seconds, stock.seed);
        here[visitor.slot] = due && due->visitor == visitor;
        if (!here[visitor.slot]) commands.destroy(entity);
    }
    for (uint32_t slot = 0; slot < kSlots; ++slot)
        if (const auto due = guestOf(slot, time.seconds, stock.seed); due && !here[slot])
            come(commands, stock, *due);
}

/// It lies where it lands, still, until its stay ends.
void fall(ecs::Write<scene::Transform> transform, ecs::Read<Falling> leaf,
          const scene::FrameTime& time) {
    constexpr float kGroundY = 0.04f;
    const double landing = (leaf->fromMetres.y - kGroundY) / kFallMetresPerSecond;
    const double seconds = glm::min(time.seconds - leaf->sinceSeconds, landing);
    const float left = kFallMetresPerSecond * static_cast<float>(landing - seconds);
    const auto sway = scene::builtin::sinCosTurns(0.4 * seconds + leaf->phaseTurns);
    scene::Transform place = transform.get();
    place.translation = {leaf->fromMetres.x + 0.25f * static_cast<float>(sway.cos), kGroundY + left,
                         leaf->fromMetres.z + 0.25f * static_cast<float>(sway.sin)};
    const double tilt = 0.1 * sway.sin * glm::min(left, 1.0f);
    place.rotation = turned({0.0f, 1.0f, 0.0f}, leaf->phaseTurns + 0.3 * seconds) *
                     turned({1.0f, 0.0f, 0.0f}, tilt);
    if (place.translation != transform.get().translation ||
        place.rotation != transform.get().rotation)
        *transform = place;
}

/// A blade bent along its middle, of two sides.
void addLeafBlade(assets::Mesh& mesh) {
    for (const float side : {1.0f, -1.0f}) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        for (uint32_t row = 0; row <= 8; ++row) {
            const float t = static_cast<float>(row) / 8.0f;
            const float width =
                0.06f * static_cast<float>(scene::builtin::sinCosTurns(0.5 * t).sin) + 0.002f;
            for (int column = -1; column <= 1; ++column) {
                const float x = width * static_cast<float>(column) * side;
                mesh.positions.emplace_back(x, 0.3f * glm::abs(x) + 0.06f * t * t + 0.002f * side,
                                            0.12f - 0.24f * t);
            }
        }
        addGrid(mesh, first, 3, 9, false);
        smoothNormals(mesh, first);
    }
}

void addCrate(assets::Mesh& mesh) {
    const auto box = [&](const glm::vec3& centre, const glm::vec3& half) {
        scene::builtin::addBox(mesh, scene::builtin::placed(centre), half);
    };
    addBlock(mesh, glm::vec3(-0.27f), glm::vec3(0.27f), 0.02f);
    for (const float x : {-0.27f, 0.27f})
        for (const float z : {-0.27f, 0.27f})
            addBlock(mesh, {x - 0.03f, -0.3f, z - 0.03f}, {x + 0.03f, 0.3f, z + 0.03f});
    for (const float y : {-0.265f, 0.265f})
        for (const float side : {-0.275f, 0.275f}) {
            box({side, y, 0.0f}, {0.02f, 0.03f, 0.24f});
            box({0.0f, y, side}, {0.24f, 0.03f, 0.02f});
        }
}

/// On a plate.
void addStandingLantern(assets::Mesh& mesh) {
    addLanternCage(mesh, glm::mat4(1.0f));
    scene::builtin::addCylinder(mesh, scene::builtin::placed({0.0f, -0.22f, 0.0f}), 0.16f, 0.025f,
                                32);
}

}  // namespace

Stock makeStock(scene::Library& library, const Paints& paints, uint32_t seed) {
    const auto add = [&](const char* name, void (*build)(assets::Mesh&)) {
        assets::Mesh mesh;
        mesh.name = name;
        build(mesh);
        assets::updateBounds(mesh);
        return library.addMesh(std::move(mesh));
    };
    return {seed,
            add("crate", addCrate),
            add("leaf", addLeafBlade),
            add("standing lantern", addStandingLantern),
            paints.wood,
            paints.iron,
            {paints.saffron, paints.crimson, paints.teal, paints.green}};
}

void addVisiting(ecs::Schedule& systems) {
    systems.add("visit", visit);
    systems.add("fall", fall);
}

}  // namespace lampyris::courtyard
