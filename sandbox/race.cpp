#include "race.h"

#include "progress.h"

namespace lampyris::sandbox {
namespace {

core::Result<void> prepare(Contestant& contestant) {
    TRY(FrameLoop* const loop, loopOf(contestant));
    loop->request.settings = settingsOf(contestant.options);
    contestant.size = loop->request.size;
    contestant.device = loop->device().info().name;
    contestant.series = {};
    contestant.photonsStored.clear();
    contestant.pictures.clear();
    return {};
}

core::Result<void> drawFrame(Contestant& contestant, uint32_t frameNumber,
                             const RaceLength& length) {
    const uint32_t total = length.warmup + length.frames;
    const bool keep = frameNumber + length.pictures >= total;
    TRY(LoopFrame frame, contestant.loop->draw(frameNumber, keep));
    contestant.report = frame.outcome.report;
    if (frameNumber < length.warmup) return {};
    contestant.series.add(frame.outcome.statistics);
    contestant.photonsStored.push_back(frame.outcome.report.counters.photonsStored);
    if (keep) contestant.pictures.push_back(std::move(frame.outcome.image));
    return {};
}

}  // namespace

core::Result<FrameLoop*> loopOf(Contestant& contestant) {
    if (!contestant.loop) {
        TRY(contestant.loop, FrameLoop::open(contestant.options));
    }
    return contestant.loop.get();
}

core::Result<void> race(std::vector<Contestant>& contestants, const RaceLength& length) {
    for (Contestant& contestant : contestants) TRY_VOID(prepare(contestant));
    Progress progress{length.what, length.warmup + length.frames};
    for (uint32_t i = 0; i < length.warmup + length.frames; ++i) {
        progress.show(i);
        for (Contestant& contestant : contestants) TRY_VOID(drawFrame(contestant, i, length));
    }
    return {};
}

}  // namespace lampyris::sandbox
