#include "ecs/schedule.h"

#include <gtest/gtest.h>

namespace lampyris::ecs {
namespace {

struct Position {
    float x = 0.0f;
};
struct Velocity {
    float x = 0.0f;
};
struct Frozen {};
struct FrameTime {
    float seconds = 0.0f;
};
struct Counter {
    int value = 0;
};

void move(Write<Position> position, Read<Velocity> velocity, Without<Frozen>, FrameTime time) {
    position->x += velocity->x * time.seconds;
}

class ScheduleTest : public testing::Test {
 protected:
    Entity make(float x, float velocity) {
        const Entity e = world.create();
        world.add(e, Position{x});
        world.add(e, Velocity{velocity});
        return e;
    }
    World world;
    Schedule schedule;
};

TEST_F(ScheduleTest, CallsASystemForEachEntityThatMatches) {
    world.setResource(FrameTime{0.5f});
    const Entity a = make(1.0f, 2.0f);
    const Entity b = make(1.0f, 2.0f);
    world.add<Frozen>(b);
    const Entity bare = world.create();
    world.add(bare, Position{9.0f});
    const Tick since = world.advance();
    schedule.add("move", move);
    schedule.run(world);
    EXPECT_EQ(world.get<Position>(a).x, 2.0f);
    EXPECT_EQ(world.get<Position>(b).x, 1.0f);
    EXPECT_EQ(world.get<Position>(bare).x, 9.0f);
    EXPECT_EQ(world.changedSince<Position>(since), std::vector<Entity>{a});
}

TEST_F(ScheduleTest, WithoutEntityParametersASystemRunsOnce) {
    make(0.0f, 0.0f);
    make(0.0f, 0.0f);
    world.setResource(Counter{});
    world.setResource(FrameTime{2.0f});
    schedule.add("count", [](Counter& counter, const FrameTime& time) {
        counter.value += int(time.seconds);
    });
    schedule.add("look", [](const World& w, Counter& counter) {
        counter.value += 10 * int(w.entityCount());
    });
    schedule.run(world);
    EXPECT_EQ(world.resource<Counter>().value, 22);
}

TEST_F(ScheduleTest, GivesEntityAndWithWithoutValues) {
    const Entity a = make(1.0f, 0.0f);
    make(2.0f, 0.0f);
    world.add<Frozen>(a);
    std::vector<Entity> seen;
    schedule.add("see", [&](Entity e, With<Frozen, Position>) { seen.push_back(e); });
    schedule.run(world);
    EXPECT_EQ(seen, std::vector<Entity>{a});
}

TEST_F(ScheduleTest, AWriteThatOnlyLooksIsNoChange) {
    const Entity a = make(1.0f, 0.0f);
    const Entity b = make(5.0f, 0.0f);
    const Tick since = world.advance();
    schedule.add("clamp", [](Write<Position> position) {
        if (position.get().x > 2.0f) position->x = 2.0f;
    });
    schedule.run(world);
    EXPECT_FALSE(world.changedSince<Position>(a, since));
    EXPECT_TRUE(world.changedSince<Position>(b, since));
}

TEST_F(ScheduleTest, TellsObserversOnceWhenTheSystemIsDone) {
    make(1.0f, 1.0f);
    make(2.0f, 1.0f);
    world.setResource(FrameTime{1.0f});
    std::vector<float> told;
    const Connection connection = world.onChange<Position>([&](World& w, Entity e) {
        told.push_back(w.get<Position>(e).x);
        w.destroy(e);
    });
    schedule.add("twice", [](Write<Position> position) {
        position->x += 1.0f;
        (*position).x += 1.0f;
    });
    schedule.run(world);
    EXPECT_EQ(told, (std::vector<float>{3.0f, 4.0f}));
    EXPECT_EQ(world.entityCount(), 0u);
}

TEST_F(ScheduleTest, AppliesCommandsWhenTheSystemIsDone) {
    make(1.0f, 0.0f);
    make(2.0f, 0.0f);
    size_t during = 0;
    schedule.add("split", [&](Entity e, Read<Position> position, Commands& commands) {
        const NewEntity half = commands.create();
        commands.add(half, Position{position->x / 2});
        commands.destroy(e);
        during = world.entityCount();
    });
    schedule.run(world);
    EXPECT_EQ(during, 2u);
    EXPECT_EQ(world.entityCount(), 2u);
    EXPECT_EQ(world.count<Velocity>(), 0u);
    EXPECT_EQ(world.count<Position>(), 2u);
}

void writesPosition(Write<Position>) {}
void readsPosition(Read<Position>) {}
void writesVelocity(Write<Velocity>) {}
void readsBoth(Read<Position>, Read<Velocity>) {}
void everything(World&) {}

TEST(ScheduleOrder, PutsIndependentSystemsInOneStage) {
    Schedule schedule;
    schedule.add("write position", writesPosition);
    schedule.add("read position", readsPosition);
    schedule.add("write velocity", writesVelocity);
    schedule.add("read both", readsBoth);
    schedule.add("write position again", writesPosition);
    const std::vector<std::vector<std::string>> expected = {{"write position", "write velocity"},
                                                            {"read position", "read both"},
                                                            {"write position again"}};
    EXPECT_EQ(schedule.stages(), expected);
}

TEST(ScheduleOrder, RunsConflictingSystemsAsTheyWereAdded) {
    World world;
    world.setResource(Counter{});
    Schedule schedule;
    std::vector<int> ran;
    schedule.add("a", [&](Counter& counter) { ran.push_back(counter.value++); });
    schedule.add("b", [&](const Counter& counter) { ran.push_back(10 * counter.value); });
    schedule.add("c", [&](Counter& counter) { ran.push_back(100 * counter.value); });
    schedule.run(world);
    EXPECT_EQ(ran, (std::vector<int>{0, 10, 100}));
}

TEST(ScheduleOrder, AWorldSystemStandsAlone) {
    Schedule schedule;
    schedule.add("a", readsPosition);
    schedule.add("all", everything);
    schedule.add("b", readsPosition);
    schedule.add("spectator", [](const World&) {});
    schedule.add("spawner", [](Read<Velocity>, Commands&) {});
    const std::vector<std::vector<std::string>> expected = {
        {"a"}, {"all"}, {"b", "spectator"}, {"spawner"}};
    EXPECT_EQ(schedule.stages(), expected);
}

TEST(ScheduleOrder, FiltersCountAsReads) {
    Schedule schedule;
    schedule.add("a", [](Read<Velocity>, With<Position>) {});
    schedule.add("b", [](Read<Velocity>, Without<Position>) {});
    schedule.add("c", writesPosition);
    EXPECT_EQ(schedule.stages().size(), 2u);
}

TEST(ScheduleOrderDeath, NamesAreUnique) {
    Schedule schedule;
    schedule.add("a", readsPosition);
    EXPECT_DEATH(schedule.add("a", readsPosition), "a != a");
}

TEST(ScheduleDot, DrawsSystemsStagesAndWhatOrdersThem) {
    Schedule schedule;
    schedule.add("move", move);
    schedule.add("say \"hi\"", readsPosition);
    schedule.add("reset", writesPosition);
    EXPECT_EQ(schedule.toDot(), R"(digraph systems {
  rankdir=LR;
  node [shape=box];
  "move" [label="move\nreads FrameTime, Frozen, Velocity\nwrites Position"];
  "say \"hi\"" [label="say \"hi\"\nreads Position"];
  "reset" [label="reset\nwrites Position"];
  { rank=same; "move"; }
  { rank=same; "say \"hi\""; }
  { rank=same; "reset"; }
  "move" -> "say \"hi\"" [label="Position"];
  "say \"hi\"" -> "reset" [label="Position"];
}
)");
}

}  // namespace
}  // namespace lampyris::ecs
