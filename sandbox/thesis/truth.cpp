#include "thesis/truth.h"

#include <algorithm>
#include <array>

#include "camera_choice.h"
#include "core/image_io.h"
#include "core/log.h"
#include "evaluation/mse.h"
#include "evaluation/mssim.h"
#include "progress.h"
#include "reference/reference.h"
#include "scene/extract.h"
#include "scene/load.h"
#include "thesis/content_id.h"

namespace lampyris::sandbox::thesis {
namespace {

using Json = nlohmann::json;
using Halves = std::array<core::Image, 2>;

core::Result<Truth> truthOf(const core::Image& image, const std::string& name,
                            const std::string& about, const Study& study) {
    const graph::Extent size = study.size().size;
    if (image.width != size.width || image.height != size.height)
        return core::error("{}: is {}x{}, the frames are {}x{}", name, image.width, image.height,
                           size.width, size.height);
    TRY(auto picture, evaluation::fromLinear(name, image, study.call().options.display));
    return Truth{std::move(picture), idOf(image), about};
}

uint32_t samplesOfHalf(const Study& study) {
    return std::max(study.size().samplesPerPixel / 2, 1u);
}

/// All that the rendered picture hangs on.
Json wishOf(const Study& study, const std::string& scene) {
    const Options& o = study.call().options;
    const graph::Extent size = study.size().size;
    return {{"scene", scene},
            {"size", {size.width, size.height}},
            {"seed", o.seed},
            {"camera", o.camera},
            {"time", o.time},
            {"spp", samplesOfHalf(study)},
            {"exposure", o.display.exposureEv},
            {"tonemap", static_cast<int>(o.display.tonemap)},
            {"program", study.machine()["program"]}};
}

core::Result<Halves> renderHalves(const Study& study, const std::string& scene) {
    TRY(const ecs::World world, scene::loadScene(scene));
    const scene::SceneSnapshot snapshot = scene::extract(world, {}, 0);
    const Options& o = study.call().options;
    TRY(const scene::SnapshotCamera camera, chooseCamera(snapshot, o.camera));
    Halves halves;
    for (size_t i = 0; i < halves.size(); ++i) {
        reference::Settings settings;
        settings.width = study.size().size.width;
        settings.height = study.size().size.height;
        settings.samplesPerPixel = samplesOfHalf(study);
        settings.smoothIndirect = true;
        settings.seed = 2 * o.seed + static_cast<uint32_t>(i);
        Progress progress{fmt::format("reference {}/2, percent", i + 1), 100};
        TRY(auto rendered,
            reference::render(snapshot, camera, settings, [&](uint64_t done, uint64_t total) {
                progress.show(100 * done / total);
                return true;
            }));
        core::releaseLog();
        halves[i] = std::move(rendered.final);
    }
    return halves;
}

core::Result<Row> compareHalves(const Halves& halves, const Study& study) {
    const core::DisplayTransform& display = study.call().options.display;
    TRY(const auto one, evaluation::fromLinear("reference", halves[0], display));
    TRY(const auto other, evaluation::fromLinear("reference", halves[1], display));
    TRY(const auto mse, evaluation::mse(one, other));
    TRY(const auto mssim, evaluation::mssim(one, other));
    return Row{{"halves", {{"MSE", {mse.value, 0.0}}, {"MSSIM", {mssim.value, 0.0}}}}};
}

core::Image meanOf(Halves halves) {
    core::Image mean = std::move(halves[0]);
    for (size_t i = 0; i < mean.values.size(); ++i)
        mean.values[i] = 0.5f * (mean.values[i] + halves[1].values[i]);
    return mean;
}

std::string aboutOf(const Row& row, const Study& study) {
    const Figures& halves = row.at("halves");
    return fmt::format(
        "the CPU reference, {} samples a pixel; its two halves differ by MSE {:.3g}, MSSIM {:.4f}",
        2 * samplesOfHalf(study), halves.at("MSE").mean, halves.at("MSSIM").mean);
}

}  // namespace

core::Result<Truth> findTruth(const Study& study, const std::string& scene) {
    const std::filesystem::path& given = study.call().reference;
    if (!given.empty()) {
        TRY(const core::Image image, core::readExr(given));
        return truthOf(image, given.string(), given.filename().string(), study);
    }
    const Json wish = wishOf(study, scene);
    const std::filesystem::path& out = study.call().out;
    const auto file =
        out / fmt::format("reference-{}-{}.exr", std::filesystem::path(scene).stem().string(),
                          idOf(wish.dump()));
    RowStore store;
    if (!out.empty()) {
        TRY(store, RowStore::open(out / "references.rows.jsonl"));
    }
    if (const Row* kept = store.find(wish)) {
        const auto image = core::readExr(file);
        if (image.ok()) return truthOf(*image, file.string(), aboutOf(*kept, study), study);
    }
    TRY(Halves halves, renderHalves(study, scene));
    TRY(const Row row, compareHalves(halves, study));
    const core::Image image = meanOf(std::move(halves));
    if (!out.empty()) TRY_VOID(core::writeExr(file, image));
    TRY_VOID(store.keep(wish, row));
    return truthOf(image, "the reference", aboutOf(row, study), study);
}

}  // namespace lampyris::sandbox::thesis
