#include "ecs/registry.h"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>

namespace lampyris::ecs {
namespace {

using nlohmann::json;

struct Place {
    float x = 0.0f;
    float y = 0.0f;
};
void to_json(json& out, const Place& place) {
    out = json{{"x", place.x}, {"y", place.y}};
}
void from_json(const json& in, Place& place) {
    in.at("x").get_to(place.x);
    in.at("y").get_to(place.y);
}

struct Target {
    Entity entity;
};
struct Percent {
    int value = 0;
};
struct Secret {};

Registry makeRegistry() {
    Registry registry;
    registry.add<Place>("Place");
    registry.add<Target>(
        "Target",
        [](const Target& t, const SavedEntities& saved) { return saved.reference(t.entity); },
        [](const json& in, const LoadedEntities& loaded) -> core::Result<Target> {
            TRY(const Entity e, loaded.entity(in));
            return Target{e};
        });
    registry.add<Percent>(
        "Percent", [](const Percent& p) { return json(p.value); },
        [](const json& in) -> core::Result<Percent> {
            const int value = in.get<int>();
            if (value < 0 || value > 100) return core::error("{} is no percentage", value);
            return Percent{value};
        });
    return registry;
}

// The text of a world around these entities.
std::string worldOf(const std::string& entities) {
    return R"({"format": "lampyris world", "version": 1, "entities": )" + entities + "}";
}

TEST(Registry, BringsAWorldBackThroughItsText) {
    const Registry registry = makeRegistry();
    World world;
    world.destroy(world.create());  // so that handles and places in the file differ
    const Entity late = world.create();
    const Entity root = world.create();
    const Entity second = world.create();
    ASSERT_TRUE(setParent(world, second, root).ok());
    ASSERT_TRUE(setParent(world, late, root).ok());
    world.add(root, Place{0.1f, 1e30f});
    world.add(late, Target{second});
    world.add(second, Target{root});
    world.add(second, Percent{7});
    world.add(root, Secret{});

    const std::string text = saveWorld(world, registry);
    auto loaded = loadWorld(text, registry);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    const World& copy = *loaded;
    ASSERT_EQ(copy.entityCount(), 3u);
    const std::vector<Entity> order = parentsFirst(copy);
    EXPECT_EQ(copy.get<Place>(order[0]).x, 0.1f);
    EXPECT_EQ(copy.get<Place>(order[0]).y, 1e30f);
    EXPECT_EQ(childrenOf(copy, order[0]).size(), 2u);
    EXPECT_EQ(copy.get<Percent>(order[1]).value, 7) << "siblings keep their order";
    EXPECT_EQ(copy.get<Target>(order[1]).entity, order[0]);
    EXPECT_EQ(copy.get<Target>(order[2]).entity, order[1]);
    EXPECT_EQ(copy.count<Secret>(), 0u) << "not registered, so not saved";
    EXPECT_EQ(saveWorld(copy, registry), text);
}

TEST(Registry, SavesAReferenceToTheDeadAsNone) {
    const Registry registry = makeRegistry();
    World world;
    const Entity gone = world.create();
    const Entity e = world.create();
    world.add(e, Target{gone});
    world.destroy(gone);
    const auto loaded = loadWorld(saveWorld(world, registry), registry);
    ASSERT_TRUE(loaded.ok());
    EXPECT_FALSE(loaded->get<Target>(loaded->entities()[0]).entity.valid());
}

TEST(Registry, LoadsAnEmptyWorld) {
    const Registry registry = makeRegistry();
    const auto loaded = loadWorld(saveWorld(World(), registry), registry);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(loaded->entityCount(), 0u);
}

TEST(RegistryDeath, KnowsANameOnlyOnce) {
    Registry registry = makeRegistry();
    EXPECT_DEATH(registry.add<Place>("Place"), "find\\(entry.name\\)");
}

TEST(Registry, SurvivesDeepNesting) {
    const auto loaded = loadWorld(std::string(1'000'000, '['), makeRegistry());
    ASSERT_FALSE(loaded.ok());
    EXPECT_NE(loaded.error().message.find("column 1000001"), std::string::npos)
        << loaded.error().message;
    EXPECT_FALSE(
        loadWorld(std::string(100'000, '[') + std::string(100'000, ']'), makeRegistry()).ok());
}

struct BadWorld {
    std::string text;
    std::string message;  // a part of the error
};

// Becomes part of the test's name, so only what a name may hold.
void PrintTo(const BadWorld& world, std::ostream* out) {
    for (const char c : world.message + world.text.substr(world.text.rfind(':') + 1))
        *out << (std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_');
}

class BadWorlds : public testing::TestWithParam<BadWorld> {};

TEST_P(BadWorlds, AreErrorsThatNameThePlace) {
    const auto loaded = loadWorld(GetParam().text, makeRegistry());
    ASSERT_FALSE(loaded.ok()) << GetParam().text;
    EXPECT_EQ(loaded.error().message.rfind("world: ", 0), 0u) << loaded.error().message;
    EXPECT_NE(loaded.error().message.find(GetParam().message), std::string::npos)
        << loaded.error().message;
    EXPECT_EQ(loaded.error().message.find("json.exception"), std::string::npos)
        << loaded.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    All, BadWorlds,
    testing::Values(
        BadWorld{"", "line 1, column 1"}, BadWorld{"{\"format\":\n oops}", "line 2, column 2"},
        BadWorld{"\xff\xfe", "line 1"}, BadWorld{"[]", "\"format\""},
        BadWorld{"{\"format\": 3}", "\"format\""},
        BadWorld{R"({"format": "lampyris world", "version": 2})", "version 2 is not 1"},
        BadWorld{R"({"format": "lampyris world", "version": 1})", "no list \"entities\""},
        BadWorld{worldOf("{}"), "no list \"entities\""},
        BadWorld{worldOf("[3]"), "entity 0: not an object"},
        BadWorld{worldOf(R"([{}, {"componets": {}}])"), "entity 1: unexpected \"componets\""},
        BadWorld{worldOf(R"([{"components": []}])"), "entity 0: unexpected \"components\""},
        BadWorld{worldOf(R"([{"components": {"Ghost": 1}}])"),
                 "entity 0: unknown component \"Ghost\""},
        BadWorld{worldOf(R"([{}, {"components": {"Place": {"x": 1}}}])"),
                 "entity 1: component \"Place\": key 'y'"},
        BadWorld{worldOf(R"([{"components": {"Place": null}}])"), "component \"Place\""},
        BadWorld{worldOf(R"([{"components": {"Percent": 101}}])"),
                 "component \"Percent\": 101 is no percentage"},
        BadWorld{worldOf(R"([{"components": {"Target": 1}}])"),
                 "component \"Target\": 1 names none of the 1 entities"},
        BadWorld{worldOf(R"([{"parent": 1}])"), "entity 0: 1 names none of the 1 entities"},
        BadWorld{worldOf(R"([{"parent": -1}])"), "entity 0: -1 names none"},
        BadWorld{worldOf(R"([{"parent": "0"}])"), "entity 0: \"0\" names none"},
        BadWorld{worldOf(R"([{"parent": 0}])"), "its own ancestor"},
        BadWorld{worldOf(R"([{"parent": 1}, {"parent": 2}, {"parent": 0}])"), "entity 2: "}));

}  // namespace
}  // namespace lampyris::ecs
