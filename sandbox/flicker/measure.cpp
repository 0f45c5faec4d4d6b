#include "flicker/measure.h"

#include "evaluation/mssim.h"
#include "flicker/film.h"
#include "flicker/light_change.h"
#include "progress.h"

namespace lampyris::sandbox::flicker {
namespace {

using evaluation::Lag;

core::Result<Still> watch(Film& film, const Call& call, Truths& truths) {
    TRY_VOID(film.skip(call.warmup()));
    evaluation::FlickerMeter meter;
    for (uint32_t i = 0; i < call.stillFrames(); ++i) {
        TRY(const core::DisplayImage frame, film.next());
        TRY_VOID(meter.add(frame));
    }
    Still still{meter.result(), meter.changes(), 0.0};
    TRY(const evaluation::Picture* const truth, truths.still());
    const auto average = evaluation::fromDisplay("the mean frame", still.flicker.average);
    TRY(const auto mssim, evaluation::mssim(average, *truth));
    still.mssim = mssim.value;
    return still;
}

/// From the frame before the change to the last that its lag looks at.
core::Result<std::optional<Lag>> follow(Film& film, const auto& change) {
    evaluation::LagMeter meter;
    TRY(core::DisplayImage frame, film.next());
    TRY_VOID(meter.add(frame));
    change();
    while (!meter.complete()) {
        TRY(frame, film.next());
        TRY_VOID(meter.add(frame));
    }
    return meter.result();
}

core::Result<void> measureLags(Film& film, Row& row) {
    FrameLoop& loop = film.loop();
    const auto light = strongestLight(loop.snapshot());
    if (!light) return {};
    const auto power = [&](const glm::vec3& watts) {
        return [&loop, &light, watts] { setPower(loop.world(), light->entity, watts); };
    };
    TRY(row.lags[0], follow(film, power(glm::vec3(0.0f))));
    const bool wentOff = isOff(*light, loop.snapshot());
    TRY(row.lags[1], follow(film, power(light->powerWatts)));
    if (!wentOff) row.lags[0] = row.lags[1] = std::nullopt;  // a system sets it in each frame
    TRY(row.lags[2],
        follow(film, [&] { moveInwards(loop.world(), *light, loop.snapshot().boundsWorld); }));
    if (!hasMoved(*light, loop.snapshot())) row.lags[2].reset();
    return {};
}

core::Result<void> measureMoving(const Options& options, const Call& call, Truths& truths,
                                 Row& row) {
    TRY(const MovingTruth* const truth, truths.moving());
    if (truth == nullptr) return {};
    Options moving = options;
    moving.size = call.movingSize();
    moving.timestep = call.timestep();
    TRY(Film film, Film::open(moving));
    TRY_VOID(film.skip(call.warmup()));
    std::vector<core::DisplayImage> frames;
    for (uint32_t i = 0; i < call.movingFrames(); ++i) {
        TRY(core::DisplayImage frame, film.next());
        frames.push_back(std::move(frame));
    }
    TRY(row.moving, evaluation::dynamicFlicker(frames, truth->frames));
    row.floor = truth->floor;
    return {};
}

}  // namespace

core::Result<Row> measureRow(const std::string& name, const Options& options, const Call& call,
                             Truths& truths) {
    Row row;
    row.name = name;
    row.options = options;
    Options still = options;
    still.size = call.stillSize();
    still.timestep = 0.0;
    TRY(Film film, Film::open(still));
    row.device = film.loop().device().info().name;
    TRY(row.still, watch(film, call, truths));
    TRY_VOID(measureLags(film, row));
    Options frozen = still;
    frozen.reseed = false;
    TRY(Film same, Film::open(frozen));
    TRY(row.frozen, watch(same, call, truths));
    TRY_VOID(measureMoving(options, call, truths, row));
    return row;
}

}  // namespace lampyris::sandbox::flicker
