/// \file Runs systems in an order that follows from what they read and write.
#pragma once

#include <functional>
#include <string>

#include "ecs/system_parameter.h"

namespace lampyris::ecs {

/// Systems that touch the same component or resource, at least one of them writing, keep the order
/// in which they were added; all others are independent. A stage holds systems that are independent
/// of each other and could run in parallel; run() takes them one after another, so that a run is
/// the same every time.
class Schedule {
 public:
    /// `function`: see system.h. Names are unique.
    template <typename F>
    void add(std::string name, F function) {
        insert(std::move(name), std::function{std::move(function)});
    }

    void run(World& world) const;

    /// Names in the order of running, grouped by stage.
    [[nodiscard]] std::vector<std::vector<std::string>> stages() const;
    /// Graphviz: a box a system with what it reads and writes, stages in columns, an arrow a
    /// dependency (none that follows from others) with what it is about.
    [[nodiscard]] std::string toDot() const;

 private:
    struct System {
        std::string name;
        Access access;
        std::function<void(World&)> run;
        size_t stage = 0;
    };

    template <typename... Ps>
    void insert(std::string name, std::function<void(Ps...)> function) {
        System system{std::move(name), {}, {}, 0};
        (detail::Parameter<Ps>::declare(system.access), ...);
        system.run = [function = std::move(function)](World& world) {
            detail::runSystem(world, function);
        };
        insert(std::move(system));
    }
    void insert(System system);
    [[nodiscard]] std::vector<const System*> inStage(size_t stage) const;
    [[nodiscard]] size_t stageCount() const;

    std::vector<System> systems_;  ///< as added
};

}  // namespace lampyris::ecs
