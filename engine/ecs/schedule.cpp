#include "ecs/schedule.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/check.h"

namespace lampyris::ecs {
namespace {

void addShared(const std::vector<TypeUse>& a, const std::vector<TypeUse>& b,
               std::set<std::string_view>& shared) {
    for (const TypeUse& one : a)
        for (const TypeUse& other : b)
            if (one.type == other.type) shared.insert(one.name);
}

bool touchesAnything(const Access& access) {
    return access.readsAll || access.writesAll || !access.reads.empty() || !access.writes.empty();
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string list(const char* verb, const std::vector<TypeUse>& uses, const char* everything) {
    std::set<std::string_view> names;
    for (const TypeUse& use : uses) names.insert(use.name);
    if (everything != nullptr) names = {everything};
    return names.empty()
               ? ""
               : fmt::format("\\n{} {}", verb, escaped(fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

std::vector<std::string_view> conflicts(const Access& a, const Access& b) {
    std::set<std::string_view> shared;
    addShared(a.writes, b.writes, shared);
    addShared(a.writes, b.reads, shared);
    addShared(a.reads, b.writes, shared);
    const auto writes = [](const Access& access) {
        return access.writesAll || !access.writes.empty();
    };
    const bool world = (a.writesAll && touchesAnything(b)) || (b.writesAll && touchesAnything(a)) ||
                       (a.readsAll && writes(b)) || (b.readsAll && writes(a));
    if (world) shared.insert("World");
    return {shared.begin(), shared.end()};
}

void Schedule::insert(System system) {
    for (const System& earlier : systems_) {
        CHECK(earlier.name != system.name);
        if (!conflicts(earlier.access, system.access).empty())
            system.stage = std::max(system.stage, earlier.stage + 1);
    }
    systems_.push_back(std::move(system));
}

size_t Schedule::stageCount() const {
    size_t count = 0;
    for (const System& system : systems_) count = std::max(count, system.stage + 1);
    return count;
}

std::vector<const Schedule::System*> Schedule::inStage(size_t stage) const {
    std::vector<const System*> found;
    for (const System& system : systems_)
        if (system.stage == stage) found.push_back(&system);
    return found;
}

void Schedule::run(World& world) const {
    for (size_t stage = 0; stage < stageCount(); ++stage)
        for (const System* system : inStage(stage)) system->run(world);
}

std::vector<std::vector<std::string>> Schedule::stages() const {
    std::vector<std::vector<std::string>> names(stageCount());
    for (const System& system : systems_) names[system.stage].push_back(system.name);
    return names;
}

std::string Schedule::toDot() const {
    std::string dot = "digraph systems {\n  rankdir=LR;\n  node [shape=box];\n";
    for (const System& system : systems_)
        dot += fmt::format(
            "  \"{0}\" [label=\"{0}{1}{2}\"];\n", escaped(system.name),
            list("reads", system.access.reads, system.access.readsAll ? "World" : nullptr),
            list("writes", system.access.writes, system.access.writesAll ? "World" : nullptr));
    for (size_t stage = 0; stage < stageCount(); ++stage) {
        dot += "  { rank=same;";
        for (const System* system : inStage(stage))
            dot += fmt::format(" \"{}\";", escaped(system->name));
        dot += " }\n";
    }
    const size_t count = systems_.size();
    std::vector<std::vector<bool>> before(count, std::vector<bool>(count, false));
    for (size_t later = 0; later < count; ++later) {
        // Nearest first: what is already known to come before needs no arrow of its own.
        for (size_t earlier = later; earlier-- > 0;) {
            const auto about = conflicts(systems_[earlier].access, systems_[later].access);
            if (about.empty() || before[earlier][later]) continue;
            for (size_t i = 0; i <= earlier; ++i)
                if (i == earlier || before[i][earlier]) before[i][later] = true;
            dot += fmt::format("  \"{}\" -> \"{}\" [label=\"{}\"];\n",
                               escaped(systems_[earlier].name), escaped(systems_[later].name),
                               escaped(fmt::format("{}", fmt::join(about, ", "))));
        }
    }
    return dot + "}\n";
}

}  // namespace lampyris::ecs
