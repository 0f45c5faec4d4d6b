#include "thesis/study.h"

#include <algorithm>

#include "core/file.h"
#include "report.h"
#include "thesis/content_id.h"

namespace lampyris::sandbox::thesis {
namespace {

using Json = nlohmann::json;
using photon_gi::Pipeline;

core::Result<Json> machineOf(const Options& options) {
    TRY(const auto device, gpu::Device::create({options.device, options.validation, false}));
    TRY(const std::string program, programId());
    return Json{
        {"device", device->info().name}, {"driver", device->info().driver}, {"program", program}};
}

}  // namespace

core::Result<Study> Study::open(const BenchCall& call, const std::string& name, StudySize quick) {
    Study study;
    study.call_ = call;
    study.name_ = name;
    study.size_ = call.quick ? quick : kWholeSize;
    StudySize& size = study.size_;
    size.size = call.options.size.value_or(size.size);
    size.frames = call.options.frames.value_or(size.frames);
    size.warmup = call.options.warmup.value_or(size.warmup);
    size.judged = std::min(size.judged, size.frames);
    size.samplesPerPixel = call.samplesPerPixel.value_or(size.samplesPerPixel);
    study.call_.options.size = size.size;
    TRY(study.machine_, machineOf(call.options));
    if (!call.out.empty()) {
        TRY(study.store_, RowStore::open(call.out / (name + ".rows.jsonl")));
    }
    return study;
}

Contestant Study::contestant(Pipeline pipeline, const std::string& scene) const {
    Contestant c{name(pipeline), call_.options};
    c.options.scene = scene;
    c.options.pipeline = pipeline;
    c.options.lightCutoff = 0.0f;
    c.options.history = 0;
    c.options.guiding = false;
    if (pipeline == Pipeline::Thesis)
        c.options.maxBounces = std::min(call_.options.maxBounces.value_or(1), 1u);
    return c;
}

core::Result<Row> Study::row(Json what, const std::function<core::Result<Row>()>& measure) {
    const Json settings{{"machine", machine_}, {"what", std::move(what)}};
    if (const Row* kept = store_.find(settings)) return *kept;
    TRY(Row row, measure());
    TRY_VOID(store_.keep(settings, row));
    return row;
}

core::Result<Row> Study::race(std::vector<Contestant>& contestants, const Truth* truth) {
    const Json what{{"race", settingsOf(contestants)},
                    {"frames", size_.frames},
                    {"warmup", size_.warmup},
                    {"judged", truth != nullptr ? size_.judged : 0},
                    {"truth", truth != nullptr ? truth->id : ""}};
    return row(what, [&]() -> core::Result<Row> {
        const uint32_t judged = truth != nullptr ? size_.judged : 0;
        TRY_VOID(sandbox::race(contestants, {size_.warmup, size_.frames, judged, progress}));
        Row row;
        for (Contestant& c : contestants) {
            Figures& figures = row[c.name] = costsOf(c);
            if (truth == nullptr) continue;
            TRY(Figures errors, errorsOf(c.pictures, truth->picture, c.options.display));
            figures.merge(errors);
        }
        return row;
    });
}

core::Result<void> Study::publish(Table table) const {
    table.name = table.name.empty() ? name_ : name_ + "-" + table.name;
    return sandbox::publish(table, call_.out);
}

core::Result<void> Study::publishPlot(const std::string& suffix, const std::string& svg) const {
    if (call_.out.empty()) return {};
    return core::writeFile(call_.out / fmt::format("{}-{}.svg", name_, suffix), svg);
}

std::string Study::about(const std::string& scene) const {
    return fmt::format("{}, {}x{}, {} frames on {}", scene, size_.size.width, size_.size.height,
                       size_.frames, machine_["device"].get<std::string>());
}

std::string describe(const photon_gi::Settings& settings) {
    if (settings.pipeline != Pipeline::Full) return name(settings.pipeline);
    return fmt::format("{}, --gather {}", name(settings.pipeline), name(settings.gather));
}

Json settingsOf(const std::vector<Contestant>& contestants) {
    Json all = Json::array();
    for (const Contestant& c : contestants) {
        const graph::Extent size = sizeOf(c.options);
        all.push_back({{"name", c.name},
                       {"scene", c.options.scene},
                       {"pipeline", name(c.options.pipeline)},
                       {"size", {size.width, size.height}},
                       {"settings", Json(settingsJson(c.options))}});
    }
    return all;
}

}  // namespace lampyris::sandbox::thesis
