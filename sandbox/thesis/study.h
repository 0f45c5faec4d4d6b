/// \file What the Thesis' four tables share: sizes, contestants, the rows that are finished, files.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench.h"
#include "evaluation/picture.h"
#include "plot/svg.h"
#include "table.h"
#include "thesis/row_store.h"

namespace lampyris::sandbox::thesis {

/// How much is drawn where the call does not say.
struct StudySize {
    graph::Extent size;
    uint32_t frames;           ///< timed, of a row
    uint32_t judged;           ///< of them, the last ones: their errors are measured
    uint32_t samplesPerPixel;  ///< of the reference
    uint32_t warmup = 2;
};

constexpr StudySize kWholeSize{
    {1920, 1080}, 20, 5, 512};  ///< the Thesis' size; it drew 1000 frames
constexpr StudySize kQuickSize{{480, 270}, 3, 2, 256, 1};

/// What errors are measured against.
struct Truth {
    evaluation::Picture picture;
    std::string id;     ///< of its values
    std::string about;  ///< for titles
};

class Study {
 public:
    /// Errors: the device is missing, the folder cannot be written.
    static core::Result<Study> open(const BenchCall& call, const std::string& name,
                                    StudySize quick = kQuickSize);

    /// As the call has it, with cut-off and history off: a row is one frame's worth.
    [[nodiscard]] Contestant contestant(photon_gi::Pipeline pipeline,
                                        const std::string& scene) const;

    /// What a former run kept under these settings, or what `measure` gives, which is then kept.
    core::Result<Row> row(nlohmann::json what, const std::function<core::Result<Row>()>& measure);
    /// A row of all contestants, raced; with errors where there is a truth.
    core::Result<Row> race(std::vector<Contestant>& contestants, const Truth* truth);

    /// Prints a table, and writes it where there is a folder.
    [[nodiscard]] core::Result<void> publish(Table table) const;
    [[nodiscard]] core::Result<void> publishPlot(const std::string& suffix,
                                                 const std::string& svg) const;

    /// "cornell, 480x270, 3 frames on llvmpipe"
    [[nodiscard]] std::string about(const std::string& scene) const;
    [[nodiscard]] const BenchCall& call() const { return call_; }
    [[nodiscard]] const StudySize& size() const { return size_; }
    [[nodiscard]] const nlohmann::json& machine() const { return machine_; }
    /// The scene of tables that have one.
    [[nodiscard]] std::string scene() const {
        return call_.scene.empty() ? "cornell" : call_.scene;
    }

    std::string progress = "frame";  ///< what race() shows that it counts

 private:
    BenchCall call_;
    std::string name_;  ///< of the benchmark, and of its files
    StudySize size_{};
    nlohmann::json machine_;  ///< device, driver and program
    RowStore store_;
};

/// "full, --gather final"
[[nodiscard]] std::string describe(const photon_gi::Settings& settings);

/// The contestants' settings, as rows are kept under.
[[nodiscard]] nlohmann::json settingsOf(const std::vector<Contestant>& contestants);

}  // namespace lampyris::sandbox::thesis
