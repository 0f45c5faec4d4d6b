// What options ask for together and cannot have, and files that cannot be written.
#include <unistd.h>

#include <array>
#include <set>

#include "options.h"

namespace lampyris::sandbox {
namespace {

using photon_gi::Pipeline;

bool endsIn(const std::filesystem::path& path, std::initializer_list<const char*> endings) {
    for (const char* ending : endings)
        if (path.extension() == ending) return true;
    return path.empty();
}

/// Options that were given and would change nothing.
core::Result<void> checkUsed(const Options& o) {
    struct Asked {
        const char* flag;
        bool given;  ///< and not switched off
    };
    const bool off = o.pipeline == Pipeline::Direct;
    const std::array light{Asked{"--photons", o.photons.has_value()},
                           Asked{"--radius", o.radius.has_value()},
                           Asked{"--max-bounces", o.maxBounces.value_or(0) > 0},
                           Asked{"--gather", o.gather.has_value()},
                           Asked{"--gather-divisor", o.gatherDivisor.has_value()}};
    for (const auto& [flag, given] : light)
        if (off && given)
            return core::error("{} is of indirect light; --pipeline direct has none", flag);
    const bool final =
        o.pipeline == Pipeline::Full && o.gather != std::optional{photon_gi::Gather::Tiles};
    const std::array gather{Asked{"--gather-rays", o.gatherRays.has_value()},
                            Asked{"--filter-levels", o.filterLevels.value_or(0) > 0},
                            Asked{"--history", o.history.value_or(0) > 0},
                            Asked{"--guiding", o.guiding.value_or(false)}};
    for (const auto& [flag, given] : gather)
        if (!final && given) return core::error("{} is of full's final gather", flag);
    if (o.guiding.value_or(false) && !o.reseed)
        return core::error("--guiding learns from other paths; --reseed off has always the same");
    const std::array shadows{Asked{"--shadow-divisor", o.shadowDivisor.has_value()},
                             Asked{"--shadow-rays", o.shadowRays.has_value()}};
    for (const auto& [flag, given] : shadows)
        if (o.pipeline == Pipeline::Thesis && given)
            return core::error("{} is of shadows; --pipeline thesis has none", flag);
    return {};
}

}  // namespace

core::Result<void> checkCall(const Options& o) {
    if (o.pipeline == Pipeline::Thesis && o.maxBounces.value_or(1) > 1)
        return core::error("--pipeline thesis has one bounce; --max-bounces {} needs full",
                           *o.maxBounces);
    if (o.pipeline == Pipeline::Thesis && o.gather == photon_gi::Gather::Final)
        return core::error("--pipeline thesis gathers from tiles; --gather final needs full");
    TRY_VOID(checkUsed(o));
    TRY_VOID(checkDistinct({o.output, o.report, o.graph, o.trace}));
    if (!endsIn(o.output, {".png", ".exr"}))
        return core::error("--output {}: the file must end in .png or .exr", o.output.string());
    if (!endsIn(o.graph, {".dot", ".json"}))
        return core::error("--graph {}: the file must end in .dot or .json", o.graph.string());
    if (!endsIn(o.report, {".json"}))
        return core::error("--report {}: the file must end in .json", o.report.string());
    if (!endsIn(o.trace, {".json"}))
        return core::error("--trace {}: the file must end in .json", o.trace.string());
    return {};
}

core::Result<void> checkDistinct(const std::vector<std::filesystem::path>& files) {
    std::set<std::filesystem::path> seen;
    for (const std::filesystem::path& file : files) {
        if (file.empty()) continue;
        std::error_code code;
        const auto absolute = std::filesystem::absolute(file, code);
        const auto whole = std::filesystem::weakly_canonical(absolute, code);
        if (!seen.insert(code ? file : whole).second)
            return core::error("{} is asked for twice, for different things", file.string());
    }
    return {};
}

core::Result<void> checkTarget(const std::filesystem::path& path) {
    if (path.empty()) return {};
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code code;
    if (!std::filesystem::is_directory(folder, code))
        return core::error("{}: there is no folder {}", path.string(), folder.string());
    if (std::filesystem::is_directory(path, code))
        return core::error("{}: is a folder, not a file", path.string());
    if (::access(folder.c_str(), W_OK) != 0)
        return core::error("{}: the folder {} cannot be written", path.string(), folder.string());
    return {};
}

core::Result<void> checkOutputs(const Options& o) {
    for (const auto& path : {o.output, o.report, o.graph, o.trace}) TRY_VOID(checkTarget(path));
    return {};
}

}  // namespace lampyris::sandbox
