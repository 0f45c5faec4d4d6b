// What a million entities cost: ecs_bench prints a line a question. One entity is one item.
#include <benchmark/benchmark.h>

#include <random>

#include "ecs/commands.h"
#include "ecs/schedule.h"

namespace lampyris::ecs {
namespace {

constexpr uint32_t kEntities = 1'000'000;

struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};
struct Velocity {
    float x = 1.0f, y = 1.0f, z = 1.0f;
};
struct Rare {};

void finish(benchmark::State& state) {
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * kEntities);
}

// A world of a million: all with a position, every second with a velocity, every hundredth rare.
World makeWorld() {
    World world;
    for (uint32_t i = 0; i < kEntities; ++i) {
        const Entity e = world.create();
        world.add(e, Position{static_cast<float>(i), 0.0f, 0.0f});
        if (i % 2 == 0) world.add<Velocity>(e);
        if (i % 100 == 0) world.add<Rare>(e);
    }
    return world;
}

void create(benchmark::State& state) {
    while (state.KeepRunning()) {
        World world;
        for (uint32_t i = 0; i < kEntities; ++i) benchmark::DoNotOptimize(world.create());
    }
    finish(state);
}

void add(benchmark::State& state) {
    while (state.KeepRunning()) {
        state.PauseTiming();
        World world;
        std::vector<Entity> entities(kEntities);
        for (Entity& e : entities) e = world.create();
        state.ResumeTiming();
        for (const Entity e : entities) world.add<Position>(e);
    }
    finish(state);
}

void iterateOne(benchmark::State& state) {
    const World world = makeWorld();
    while (state.KeepRunning()) {
        float sum = 0.0f;
        for (const auto& [e, position] : world.view<Position>()) sum += position.x;
        benchmark::DoNotOptimize(sum);
    }
    finish(state);
}

void iterateTwo(benchmark::State& state) {
    const World world = makeWorld();
    while (state.KeepRunning()) {
        float sum = 0.0f;
        world.view<Position, Velocity>().each(
            [&](Entity, const Position& p, const Velocity& v) { sum += p.x * v.x; });
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * kEntities / 2);
}

void runSystem(benchmark::State& state) {
    World world = makeWorld();
    Schedule schedule;
    schedule.add("move", [](Write<Position> p, Read<Velocity> v) { p->x += v->x; });
    while (state.KeepRunning()) schedule.run(world);
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * kEntities / 2);
}

void getAtRandom(benchmark::State& state) {
    const World world = makeWorld();
    std::vector<Entity> entities = world.entities();
    std::shuffle(entities.begin(), entities.end(), std::mt19937(1));
    while (state.KeepRunning()) {
        float sum = 0.0f;
        for (const Entity e : entities) sum += world.get<Position>(e).x;
        benchmark::DoNotOptimize(sum);
    }
    finish(state);
}

void findTenChanges(benchmark::State& state) {
    World world = makeWorld();
    const std::vector<Entity> entities = world.entities();
    while (state.KeepRunning()) {
        const Tick since = world.advance();
        for (uint32_t i = 0; i < 10; ++i)
            world.edit<Position>(entities[i * (kEntities / 10)]).x = 1.0f;
        benchmark::DoNotOptimize(world.changedSince<Position>(since));
    }
}

void removeComponents(benchmark::State& state) {
    while (state.KeepRunning()) {
        state.PauseTiming();
        World world = makeWorld();
        const std::vector<Entity> entities = world.entities();
        state.ResumeTiming();
        for (const Entity e : entities) world.remove<Position>(e);
        state.PauseTiming();
        world = World();
        state.ResumeTiming();
    }
    finish(state);
}

void destroy(benchmark::State& state) {
    while (state.KeepRunning()) {
        state.PauseTiming();
        World world = makeWorld();
        const std::vector<Entity> entities = world.entities();
        state.ResumeTiming();
        for (const Entity e : entities) world.destroy(e);
        state.PauseTiming();
        world = World();
        state.ResumeTiming();
    }
    finish(state);
}

BENCHMARK(create)->Unit(benchmark::kMillisecond);
BENCHMARK(add)->Unit(benchmark::kMillisecond);
BENCHMARK(iterateOne)->Unit(benchmark::kMillisecond);
BENCHMARK(iterateTwo)->Unit(benchmark::kMillisecond);
BENCHMARK(runSystem)->Unit(benchmark::kMillisecond);
BENCHMARK(getAtRandom)->Unit(benchmark::kMillisecond);
BENCHMARK(findTenChanges)->Unit(benchmark::kMicrosecond);
BENCHMARK(removeComponents)->Unit(benchmark::kMillisecond);
BENCHMARK(destroy)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lampyris::ecs

BENCHMARK_MAIN();
