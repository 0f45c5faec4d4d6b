#include "overlay/truth_panel.h"

#include <fmt/format.h>

#include <utility>

#include "overlay/shaders.h"
#include "overlay/words.h"
#include "shared/overlay.h"

namespace lampyris::overlay {
namespace {

constexpr float kPlotHeight = 48.0f;

template <typename Get>
void plot(const char* name, const std::vector<TruthFigures>& figures, const Get& get) {
    std::vector<float> values;
    values.reserve(figures.size());
    for (const TruthFigures& one : figures)
        if (const auto value = get(one)) values.push_back(static_cast<float>(*value));
    const std::string label =
        values.empty() ? std::string(name) : fmt::format("{} {:.4g}", name, values.back());
    ImGui::PlotLines(fmt::format("##{}", name).c_str(), values.data(),
                     static_cast<int>(values.size()), 0, label.c_str(), FLT_MAX, FLT_MAX,
                     {remainingWidth(), kPlotHeight});
}

void row(const char* name, const glm::dvec3& watts) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    for (int i = 0; i < 3; ++i) {
        ImGui::TableNextColumn();
        ImGui::Text("%.2f", watts[i]);
    }
}

void drawEnergy(const photons::EnergyLedger& energy) {
    if (!ImGui::BeginTable("energy", 4, ImGuiTableFlags_RowBg)) return;
    for (const char* name : {"watts", "red", "green", "blue"}) ImGui::TableSetupColumn(name);
    ImGui::TableHeadersRow();
    row("emitted", energy.emitted);
    row("absorbed", energy.absorbed);
    row("escaped", energy.escaped);
    row("in flight", energy.inFlight);
    row("roulette", energy.roulette);
    ImGui::EndTable();
    text(fmt::format("emitted and the rest differ by {:.1e} of it", energy.relativeError()));
}

void warn(const char* what, uint32_t count) {
    if (count > 0) ImGui::TextColored(kAlarm, "%u %s found no room", count, what);
}

void drawOverflow(const photon_gi::FrameReport& report) {
    const shared::FrameCounters& c = report.counters;
    if (!report.valid) ImGui::TextColored(kAlarm, "this frame is not whole: buffers grow");
    warn("photons", c.photonsDropped);
    warn("tile entries", c.pairsDropped);
    warn("grid cells", c.cellsDropped);
    if (report.valid && c.photonsDropped + c.pairsDropped + c.cellsDropped == 0)
        ImGui::TextDisabled("everything found room");
}

}  // namespace

core::Result<TruthPanel> TruthPanel::create(gpu::Device& device) {
    TRY(execute::CopyRing ring, execute::CopyRing::create(device));
    return TruthPanel{std::move(ring)};
}

core::Result<void> TruthPanel::follow(const TruthView& view, const core::DisplayTransform& display,
                                      const gpu::Image& radiance, const graph::ImageDesc& desc) {
    if (!worker_) worker_ = std::make_unique<TruthWorker>();
    const bool sameView = worker_->follow(view);
    const bool sameDisplay =
        display.exposureEv == display_.exposureEv && display.tonemap == display_.tonemap;
    if (!sameDisplay) worker_->forgetFigures();
    display_ = display;
    const bool rested = std::exchange(rests_, false);
    if (rested || !sameView || !sameDisplay) TRY_VOID(dropCopies());
    if (copySteps_ == 0 && !worker_->wantsFrame()) return {};
    return copy(radiance, desc);
}

/// A frame, the next one, and, as these are there by then, what came of each.
core::Result<void> TruthPanel::copy(const gpu::Image& radiance, const graph::ImageDesc& desc) {
    const uint32_t step = copySteps_++;
    if (step < 2) {
        TRY_VOID(ring_.turn(radiance, desc));
        return {};
    }
    TRY(auto copied, ring_.takeOldest());
    if (!copied) return dropCopies();
    if (step == 2) {
        before_ = std::move(*copied);
        return {};
    }
    worker_->measure({std::move(*copied), std::exchange(before_, {}), display_});
    copySteps_ = 0;
    return {};
}

core::Result<void> TruthPanel::dropCopies() {
    copySteps_ = 0;
    before_ = {};
    for (;;) {
        TRY(const auto copied, ring_.takeOldest());
        if (!copied) return {};
    }
}

void TruthPanel::rest() {
    if (worker_) worker_->rest();
    rests_ = true;
}

void TruthPanel::addNode(graph::Frame& frame, const LookChoice& choice) {
    const bool reference = choice.name == kTruthReference;
    if (!on_ || rests_ || !(reference || choice.name == kTruthDifference)) return;
    const TruthState state = worker_->state();
    if (state.pictures != pictures_ || wordsName_ != choice.name) {
        const auto& picture = reference ? state.reference : state.difference;
        words_.resize(picture ? picture->values.size() / 3 : 0);
        for (size_t i = 0; i < words_.size(); ++i)
            words_[i] = 0xff000000u | uint32_t{picture->values[3 * i]} |
                        uint32_t{picture->values[3 * i + 1]} << 8u |
                        uint32_t{picture->values[3 * i + 2]} << 16u;
        if (picture) wordsExtent_ = {picture->width, picture->height};
        pictures_ = state.pictures;
        wordsName_ = choice.name;
    }
    if (words_.empty()) return;
    auto node = frame.compute("overlay/truth", shaders::truth);
    node.storageData(shared::SLOT_TRUTH_WORDS, words_.data(), words_.size() * sizeof(uint32_t));
    (void)node.write(shared::SLOT_TRUTH_SHOWN,
                     frame.image(choice.name, {graph::Format::RGBA8Unorm, wordsExtent_}));
    node.dispatchOver(wordsExtent_);
}

/// What comes when it is ready takes room from the start: a replay's clicks meet the same buttons.
void TruthPanel::drawFigures(LookChoice& choice) {
    for (const auto& [label, name] : {std::pair{"Look at the difference", kTruthDifference},
                                      std::pair{"Look at the reference", kTruthReference}}) {
        if (ImGui::Button(label)) {
            choice = {};
            choice.name = name;
            choice.encode = false;
        }
        ImGui::SameLine();
    }
    ImGui::NewLine();
    const TruthState state = worker_ && !rests_ ? worker_->state() : TruthState{};
    const std::string& error = state.error.empty() ? state.measureError : state.error;
    ImGui::TextColored(kAlarm, "%s", error.empty() ? " " : error.c_str());
    ImGui::Text("reference: %u samples a pixel, %.0f s", state.samples, state.seconds);
    ImGui::Text("its own error: %.3f of the mean", state.relativeError);
    plot("MSE", state.figures, [](const auto& f) { return std::optional{f.mse}; });
    plot("MSSIM", state.figures, [](const auto& f) { return std::optional{f.mssim}; });
    plot("FLIP", state.figures, [](const auto& f) { return std::optional{f.flip}; });
    plot("flicker (luma of 255)", state.figures, [](const auto& f) { return f.change; });
}

void TruthPanel::draw(const FrameSeen& seen, LookChoice& choice, bool* open) {
    ImGui::SetNextWindowPos({870.0f, 30.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({400.0f, 520.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Truth", open)) {
        drawOverflow(seen.report);
        ImGui::Checkbox("render the reference while the view stands still", &on_);
        if (on_) drawFigures(choice);
        ImGui::Separator();
        text(fmt::format("energy of {} paths", seen.report.paths));
        drawEnergy(seen.report.energy);
    }
    ImGui::End();
    if (!*open) on_ = false;  // by its cross
}

}  // namespace lampyris::overlay
