#include "results.h"

#include "core/file.h"
#include "core/log.h"
#include "graph/export.h"

namespace lampyris::sandbox {

core::Result<void> writeResults(const Options& o, FrameLoop& loop, const Measured& measured,
                                const execute::ChromeTrace& trace) {
    if (!o.report.empty()) TRY_VOID(core::writeFile(o.report, makeReport(o, loop, measured)));
    if (!o.trace.empty()) TRY_VOID(core::writeFile(o.trace, trace.text()));
    if (!o.graph.empty()) {
        const bool dot = o.graph.extension() == ".dot";
        const auto& [frame, compiled] =
            std::tie(measured.last.declared, measured.last.outcome.graph);
        TRY_VOID(core::writeFile(
            o.graph, dot ? graph::toDot(frame, compiled) : graph::toJson(frame, compiled)));
    }
    const auto messages = loop.device().validationMessages();
    if (!messages.empty())
        core::logWarning("{} validation messages; the first: {}", messages.size(),
                         messages.front());
    return {};
}

}  // namespace lampyris::sandbox
