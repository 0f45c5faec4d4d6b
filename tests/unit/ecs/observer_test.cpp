#include "ecs/observer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "ecs/world.h"

namespace lampyris::ecs {
namespace {

struct Light {
    int power = 0;
};
struct Dirty {};
struct Bounds {};

class Observers : public testing::Test {
 protected:
    Entity make(int power) {
        const Entity e = world.create();
        world.add(e, Light{power});
        return e;
    }
    World world;
    std::string log;
};

TEST_F(Observers, HearOfAddChangeAndRemove) {
    const Connection add = world.onAdd<Light>(
        [&](World& w, Entity e) { log += fmt::format("+{}", w.get<Light>(e).power); });
    const Connection change = world.onChange<Light>(
        [&](World& w, Entity e) { log += fmt::format("~{}", w.get<Light>(e).power); });
    const Connection remove = world.onRemove<Light>(
        [&](World&, Entity, const Light& light) { log += fmt::format("-{}", light.power); });
    const Entity e = make(1);
    world.edit<Light>(e, [](Light& light) { light.power = 2; });
    world.set(e, Light{3});
    world.remove<Light>(e);
    world.remove<Light>(e);
    world.set(e, Light{4});
    world.destroy(e);
    EXPECT_EQ(log, "+1~2~3-3+4-4");
}

TEST_F(Observers, EditWithoutAFunctionTellsBeforeTheWrite) {
    const Entity e = make(1);
    const Connection change = world.onChange<Light>(
        [&](World& w, Entity c) { log += std::to_string(w.get<Light>(c).power); });
    world.edit<Light>(e).power = 2;
    EXPECT_EQ(log, "1");
    EXPECT_EQ(world.get<Light>(e).power, 2);
}

TEST_F(Observers, AreForgottenWithTheirConnection) {
    {
        const Connection connection = world.onAdd<Light>([&](World&, Entity) { log += "a"; });
        make(1);
    }
    make(2);
    std::optional<Connection> kept = world.onAdd<Light>([&](World&, Entity) { log += "b"; });
    make(3);
    EXPECT_TRUE(kept->connected());
    kept->disconnect();
    EXPECT_FALSE(kept->connected());
    make(4);
    EXPECT_EQ(log, "ab");
}

TEST_F(Observers, MayOutliveTheWorld) {
    Connection connection;
    {
        World brief;
        connection = brief.onAdd<Light>([](World&, Entity) {});
    }
    EXPECT_TRUE(connection.connected());
}

TEST_F(Observers, ARemovalIsOverWhenItIsTold) {
    const Connection remove = world.onRemove<Light>([&](World& w, Entity e) {
        EXPECT_FALSE(w.has<Light>(e));
        EXPECT_FALSE(w.remove<Light>(e));
        log += w.alive(e) ? "alive" : "dead";
    });
    world.remove<Light>(make(1));
    world.destroy(make(2));
    EXPECT_EQ(log, "alivedead");
}

TEST_F(Observers, MayAddAndRemoveOtherComponents) {
    const Connection add = world.onAdd<Light>([](World& w, Entity e) { w.add<Bounds>(e); });
    const Connection change = world.onChange<Light>([](World& w, Entity e) { w.set(e, Dirty{}); });
    const Connection remove =
        world.onRemove<Light>([](World& w, Entity e) { w.remove<Bounds>(e); });
    const Entity e = make(1);
    EXPECT_TRUE(world.has<Bounds>(e));
    world.edit<Light>(e).power = 2;
    EXPECT_TRUE(world.has<Dirty>(e));
    world.remove<Light>(e);
    EXPECT_FALSE(world.has<Bounds>(e));
}

TEST_F(Observers, MayCreateEntitiesOfTheSameKind) {
    const Connection echo = world.onAdd<Light>([](World& w, Entity e) {
        const int power = w.get<Light>(e).power;
        if (power > 0) w.add(w.create(), Light{power - 1});
    });
    const Entity e = make(200);
    EXPECT_EQ(world.count<Light>(), 201u);
    EXPECT_EQ(world.get<Light>(e).power, 200);
}

TEST_F(Observers, MayTakeTheNewComponentAwayAgain) {
    const Connection veto = world.onAdd<Light>([](World& w, Entity e) {
        if (w.get<Light>(e).power < 0) w.remove<Light>(e);
    });
    const Connection second = world.onAdd<Light>([&](World&, Entity) { log += "told"; });
    const Entity e = world.create();
    world.set(e, Light{-1});
    EXPECT_FALSE(world.has<Light>(e));
    EXPECT_EQ(log, "") << "what is gone is not announced";
}

TEST_F(Observers, MayDestroyTheEntityThatTheyAreToldOf) {
    const Connection change = world.onChange<Light>([](World& w, Entity e) { w.destroy(e); });
    const Entity e = make(1);
    world.set(e, Light{2});
    EXPECT_FALSE(world.alive(e));
}

TEST_F(Observers, MayDestroyOthersDuringADestruction) {
    const Entity a = make(1);
    const Entity b = make(2);
    const Connection remove = world.onRemove<Light>([&](World& w, Entity) { w.destroy(b); });
    world.destroy(a);
    EXPECT_EQ(world.entityCount(), 0u);
}

TEST_F(Observers, MayConnectAndDisconnectWhileTheyAreTold) {
    std::vector<Connection> late;
    Connection self;
    Connection victim;
    self = world.onAdd<Light>([&](World& w, Entity) {
        log += "self ";
        for (int i = 0; i < 20; ++i)
            late.push_back(w.onAdd<Light>([&](World&, Entity) { log += "."; }));
        victim.disconnect();
        self.disconnect();
    });
    victim = world.onAdd<Light>([&](World&, Entity) { log += "victim "; });
    const Connection last = world.onAdd<Light>([&](World&, Entity) { log += "last "; });
    make(1);
    EXPECT_EQ(log, "self last ");
    log.clear();
    late.resize(2);
    make(2);
    EXPECT_EQ(log, "last ..");
}

}  // namespace
}  // namespace lampyris::ecs
