#include "view/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/log.h"
#include "display.h"
#include "fly_camera.h"
#include "scene/place_deformed.h"
#include "scene/registration.h"
#include "steer_player.h"
#include "view/given_options.h"
#include "view/screenshot.h"

namespace lampyris::sandbox::view {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float kSecondsAcross = 8.0f;  // [chosen] to fly from one end of the scene to the other
constexpr float kMostAcross = 1e4f;     // metres; what lies farther does not make the flight faster
constexpr float kFast = 4.0f;           // with Shift
constexpr float kLongestStep = 0.25f;   // seconds; a slow frame throws nobody out of the scene
constexpr double kIdleSeconds = 0.1;
constexpr double kTimestep = 1.0 / 60.0;  // seconds a frame, where --timestep does not say
// [measured] courtyard at 1280x720 takes 5 s a frame on lavapipe with 2 cores, a sixteenth 0.6 s.
constexpr float kCpuRenderScale = 0.25f;
constexpr float kMostTimeScale = 32.0f;
constexpr float kLeastTimeScale = 1.0f / kMostTimeScale;
constexpr double kClickPixels = 4.0;  // a drag shorter than that is a click

bool isFinite(const glm::mat4& matrix) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(matrix[i / 4][i % 4])) return false;
    return true;
}

graph::Extent scaled(graph::Extent size, float scale) {
    const auto side = [scale](uint32_t pixels) {
        return std::max(1u, static_cast<uint32_t>(std::lround(static_cast<float>(pixels) * scale)));
    };
    return {side(size.width), side(size.height)};
}

/// The picture as large as the window, for what is drawn over it.
graph::Image addEnlarged(graph::Frame& frame, graph::Image shown, graph::Extent size) {
    if (frame.desc(shown).extent == size) return shown;
    auto node = frame.transfer("overlay/enlarge");
    return node.blit(shown, frame.image("window", {frame.desc(shown).format, size}));
}

InputHead viewedBy(const ViewOptions& options) {
    return {options.scene, options.camera, options.animation};
}

}  // namespace

Viewer::Viewer(const ViewOptions& options, window::Window& window, FrameLoop& loop,
               window::Presenter& presenter, ShaderWatch& shaders)
    : options_(options),
      window_(window),
      loop_(loop),
      presenter_(presenter),
      shaders_(shaders),
      budget_(settingsOf(options), options.budgetMilliseconds),
      budgetMilliseconds_(options.budgetMilliseconds),
      defaults_(settingsOf(options)),
      timestep_(options.timestep.value_or(kTimestep)),
      startSeconds_(options.time),
      lastPoll_(Clock::now()) {
    scene::registerComponents(registry_);
}

core::Result<void> Viewer::prepare() {
    state_.settings = defaults_;
    state_.display = options_.display;
    state_.overlay = options_.overlay;
    state_.renderScale = firstRenderScale();
    if (!options_.settings.empty()) TRY_VOID(readState(options_.settings, state_));
    overrideBy(options_, state_);
    photon_gi::mend(state_.settings);
    if (!options_.replay.empty()) {
        TRY(InputLog log, readInputLog(options_.replay, viewedBy(options_)));
        const auto parsed = parseState(log.state, state_);
        if (!parsed.ok())
            return core::error("{}:1: {}", options_.replay.string(), parsed.error().message);
        defaults_ = state_.defaults.value_or(defaults_);  // one written by hand may not say
        timestep_ = state_.timestep.value_or(timestep_);
        startSeconds_ = state_.startSeconds.value_or(startSeconds_);
        replayed_ = std::move(log.moments);
    }
    if (!state_.cameraToWorld) state_.cameraToWorld = loop_.request.camera.cameraToWorld;
    if (!options_.record.empty()) {
        ViewState begun = state_;
        begun.timestep = timestep_;
        begun.startSeconds = startSeconds_;
        begun.defaults = defaults_;
        recorder_.emplace(viewedBy(options_), stateText(begun));
    }
    budget_.asked = state_.settings;
    loop_.request.camera.cameraToWorld = *state_.cameraToWorld;
    play_.timeScale = state_.timeScale;
    play_.walks = state_.walks;
    play_.renderScale = state_.renderScale;
    if (!options_.flicker.empty()) {
        TRY(flicker::Watch watch, flicker::Watch::create(loop_.device()));
        watch_.emplace(std::move(watch));
    }
    const overlay::Clipboard clipboard{
        [this](const std::string& text) { window_.setClipboard(text); },
        [this] { return repeatable() ? std::string{} : window_.clipboard(); }};
    TRY(overlay::Overlay made, overlay::Overlay::create(loop_.device(), clipboard));
    overlay_.emplace(std::move(made));
    overlay_->show(state_.overlay);
    TRY(overlay::Panels panels, overlay::Panels::create(loop_.device(), registry_));
    panels_.emplace(std::move(panels));
    panels_->open = state_.panels;
    if (state_.fullScreen && replayed_.empty()) window_.setFullScreen(true);
    return {};
}

core::Result<void> Viewer::run() {
    TRY_VOID(prepare());
    window_.whenDisplayIsLost([this] {
        const auto kept = keep();
        if (!kept.ok()) core::logError("{}", kept.error().message);
    });
    loop_.seconds = startSeconds_;
    auto drawn = drawAll();
    window_.whenDisplayIsLost({});
    const auto kept = keep();
    if (!drawn.ok()) return drawn;
    return kept.ok() ? finish() : kept;
}

core::Result<void> Viewer::drawAll() {
    for (uint64_t i = 0; !window_.shouldClose() && !isLast(i);) {
        const auto moment = nextMoment();
        if (!moment) {
            window_.waitForEvents(kIdleSeconds);
            rate_.interrupt();
            continue;
        }
        if (recorder_) recorder_->add(*moment);
        takeKeys(*moment);
        drawPanels(*moment);
        window_.setEscapeCloses(!overlay_->typing());
        const bool turns = useMouse(*moment);
        moveCamera(*moment, turns);
        meetWishes();
        TRY_VOID(draw(*moment, i));
        if (i >= options_.warmup.value_or(0)) rate_.add(Clock::now());
        loop_.seconds += sceneStep();
        play_.step = false;
        ++i;
    }
    return {};
}

double Viewer::sceneStep() const {
    if (play_.paused && !play_.step) return 0.0;
    return static_cast<double>(play_.timeScale) * timestep_;
}

core::Result<void> Viewer::keep() {
    const auto recorded = recorder_ ? recorder_->write(options_.record) : core::Result<void>{};
    const auto kept = keepSettings();
    return recorded.ok() ? kept : recorded;
}

core::Result<void> Viewer::keepSettings() {
    if (options_.settings.empty() || !replayed_.empty()) return {};  // a replay is not the user's
    if (!lastDrawn_.asked()) return {};  // nobody has seen what would be written
    state_.settings = *lastDrawn_.asked();
    state_.panels = panels_->open;
    state_.overlay = overlay_->visible();
    state_.cameraToWorld = loop_.request.camera.cameraToWorld;
    state_.timeScale = play_.timeScale;
    state_.walks = play_.walks;
    state_.renderScale = play_.renderScale;
    state_.fullScreen = window_.fullScreen();
    if (windowedSize_) state_.size = windowedSize_;
    return writeState(options_.settings, state_);
}

core::Result<void> Viewer::finish() {
    if (rate_.frames() > 0) fmt::print("{}\n", rate_.summary());
    if (overlay_->visible())
        fmt::print("overlay: {:.2f} ms of CPU time a frame\n",
                   panels_->timing.overlayMilliseconds());
    if (watch_) {
        TRY_VOID(watch_->finish(options_.flicker));
        fmt::print("{}\n", watch_->summary());
    }
    return measured_.series.frames() > 0 ? writeResults(options_, loop_, measured_, trace_)
                                         : core::Result<void>{};
}

float Viewer::firstRenderScale() const {
    const bool cpu = loop_.device().info().kind == "cpu";
    return cpu && !options_.size ? kCpuRenderScale : 1.0f;
}

bool Viewer::isLast(uint64_t frame) const {
    if (!replayed_.empty() && nextReplayed_ == replayed_.size()) return true;
    return options_.frames && frame >= uint64_t{*options_.frames} + options_.warmup.value_or(0);
}

bool Viewer::wantsMeasurements() const {
    return !options_.report.empty() || !options_.graph.empty() || !options_.trace.empty();
}

std::optional<Moment> Viewer::nextMoment() {
    window_.poll();
    if (!replayed_.empty()) return replayed_[nextReplayed_++];
    const VkExtent2D size = window_.framebufferSize();
    if (size.width == 0 || size.height == 0) return std::nullopt;
    noteWindowedSize({size.width, size.height});
    const auto now = Clock::now();
    const std::chrono::duration<float> passed = now - std::exchange(lastPoll_, now);
    const VkExtent2D units = window_.size();
    return Moment{window_.input(),
                  std::min(passed.count(), kLongestStep),
                  {std::max(units.width, 1u), std::max(units.height, 1u)},
                  {size.width, size.height}};
}

void Viewer::noteWindowedSize(graph::Extent size) {
    if (window_.fullScreen()) {
        fullScreenSize_ = size;
    } else if (size != fullScreenSize_) {  // which it may still have for a while
        windowedSize_ = size;
        fullScreenSize_.reset();
    }
}

void Viewer::takeKeys(const Moment& moment) {
    const window::Input& in = moment.input;
    if (in.wasPressed(window::kKeyF1)) overlay_->show(!overlay_->visible());
    if (in.wasPressed(window::kKeyF1 + 10) && replayed_.empty())
        window_.setFullScreen(!window_.fullScreen());
    if (in.wasPressed(window::kKeyF1 + 11)) {
        play_.screenshot = true;
        withOverlay_ = in.shift();
    }
    if (overlay_->typing()) return;
    if (in.wasPressed(' ')) play_.paused = !play_.paused;
    if (in.wasPressed('.')) play_.step = play_.paused;
    const float fast = std::abs(play_.timeScale);
    if (in.wasPressed('[') && fast > kLeastTimeScale) play_.timeScale *= 0.5f;
    if (in.wasPressed(']') && fast < kMostTimeScale)
        play_.timeScale = fast < kLeastTimeScale ? std::copysign(kLeastTimeScale, play_.timeScale)
                                                 : 2.0f * play_.timeScale;
    if (in.wasPressed('C')) play_.walks = !play_.walks;
    if (in.wasPressed('1')) play_.handles = overlay::HandleKind::Move;
    if (in.wasPressed('2')) play_.handles = overlay::HandleKind::Rotate;
    if (in.wasPressed('3')) play_.handles = overlay::HandleKind::Scale;
    if (in.wasPressed('L')) play_.spawnLight = true;
    if (in.wasPressed('B')) play_.spawnBox = true;
    if (in.wasPressed(window::kKeyDelete)) play_.deleteSelected = true;
}

void Viewer::drawPanels(const Moment& moment) {
    handlesHot_ = false;
    edit_.reset();
    overlay_->begin(moment.input, moment.windowSize, moment.size, moment.seconds);
    if (!overlay_->visible() || !last_) return overlay_->end();
    const overlay::FrameSeen seen{last_->outcome.statistics,
                                  last_->declared,
                                  last_->outcome.graph,
                                  last_->outcome.report,
                                  loop_.renderer().accel().counts(),
                                  loop_.snapshot(),
                                  loop_.request.size,
                                  overlay_->cpuMilliseconds()};
    const overlay::Editable edits{loop_.world(),  selected_,
                                  budget_.asked,  defaults_,
                                  state_.display, repeatable() ? nullptr : &budgetMilliseconds_,
                                  budget_.state()};
    const ecs::Entity edited = selected_;
    const Movable before = movableOf(loop_.world(), edited);
    const auto shaders = shaders_.status();
    panels_->draw(seen, loop_.renderer().paths(), edits, shaders, &play_);
    if (loop_.world().alive(selected_)) {
        handles_.kind = play_.handles;
        handlesHot_ = handles_.draw(loop_.world(), selected_, loop_.request.camera, moment.size);
    }
    overlay_->end();
    edit_ = Edit{edited, before, movableOf(loop_.world(), edited)};
}

/// A click picks, a drag turns the camera; both only where neither panels nor handles lie.
bool Viewer::useMouse(const Moment& moment) {
    const window::Input& in = moment.input;
    const bool dragged = dragsCamera_;  // up to here, also where the button went up now
    if (in.clicked[0] && !overlay_->wantsMouse() && !handlesHot_) {
        dragsCamera_ = true;
        draggedPixels_ = 0.0;
    } else if (dragsCamera_) {
        draggedPixels_ += std::abs(in.movedX) + std::abs(in.movedY);
    }
    if (!dragsCamera_ || in.buttons[0]) return dragged;
    dragsCamera_ = false;
    if (draggedPixels_ > kClickPixels) return dragged;
    const double scale =
        static_cast<double>(moment.size.width) / static_cast<double>(moment.windowSize.width);
    selected_ =
        scene::wholeOf(loop_.world(), pick(loop_.snapshot(), loop_.request.camera, moment.size,
                                           in.cursorX * scale, in.cursorY * scale));
    return dragged;
}

void Viewer::moveCamera(const Moment& moment, bool turns) {
    loop_.request.size = scaled(moment.size, play_.renderScale);
    window::Input input = moment.input;
    input.buttons[0] = turns;
    if (overlay_->typing()) input.held.fill(false);
    auto& camera = loop_.request.camera;
    glm::mat4 moved = camera.cameraToWorld;
    if (play_.walks) {
        moved = walk_.walk(moved, input, loop_.snapshot(), moment.seconds);
    } else {
        const float across = glm::length(loop_.snapshot().boundsWorld.extent());
        if (across > 0.0f) metresAcross_ = std::min(across, kMostAcross);
        const float pace = metresAcross_ / kSecondsAcross * (input.shift() ? kFast : 1.0f);
        moved = fly(moved, input, pace, moment.seconds);
    }
    if (isFinite(moved)) camera.cameraToWorld = moved;
    // Whoever looks is free of the game's time; who is in it is not.
    const auto seconds = static_cast<float>(std::abs(sceneStep()));
    steerPlayer(loop_.world(), camera.cameraToWorld, input, seconds);
}

void Viewer::meetWishes() {
    if (std::exchange(play_.spawnLight, false))
        selected_ = spawnLightAhead(loop_.world(), loop_.snapshot(), loop_.request.camera);
    if (std::exchange(play_.spawnBox, false))
        selected_ = spawnBoxAhead(loop_.world(), loop_.snapshot(), loop_.request.camera);
    if (std::exchange(play_.deleteSelected, false) && loop_.world().alive(selected_))
        loop_.world().destroy(std::exchange(selected_, {}));
}

core::Result<void> Viewer::draw(const Moment& moment, uint64_t number) {
    const bool saves = std::exchange(play_.screenshot, false);
    graph::Image shown;
    graph::Image plain;     // without the overlay
    graph::Image radiance;  // for the truth panel
    const auto addNodes = [&](graph::Frame& frame, const photon_gi::DrawnFrame& drawn) {
        shown = addDisplay(frame, drawn.radiance, state_.display);
        plain = shown;
        if ((saves && !withOverlay_) || watch_) {
            auto node = frame.transfer("screenshot");
            plain = node.copy(shown, frame.image("screenshot", frame.desc(shown)));
            frame.output(plain);
            frame.publish("screenshot", plain);
        }
        graph::Image picture;
        if (overlay_->visible()) {
            const auto counted = overlay_->count();
            if (panels_->truth.on()) {
                // What is shown again lies in a history image, which is not copied from.
                auto node = frame.transfer("overlay/truth_copy");
                radiance = node.copy(drawn.radiance,
                                     frame.image("truth copy", frame.desc(drawn.radiance)));
                frame.output(radiance);
            }
            shown = overlay::addMarks(frame, drawn.insides, panels_->marks, shown);
            panels_->truth.addNode(frame, panels_->look.choice);
            shown = addEnlarged(frame, shown, moment.size);
            picture = panels_->look.addNode(frame);
        }
        shown = overlay_->addNode(frame, shown, picture);
        if (saves && withOverlay_) frame.publish("screenshot", shown);
        frame.output(shown);
    };
    // What looks into the frame needs one that is drawn, not one that is shown again.
    loop_.request.finalAlone =
        !(overlay_->visible() && (panels_->marks.any() || !panels_->look.choice.name.empty()));
    if (!repeatable()) shaders_.update(loop_);
    budget_.setMilliseconds(budgetMilliseconds_);
    budget_.choose(loop_);
    TRY_VOID(follow());
    auto drawn = loop_.tryDraw(number, saves ? std::string("screenshot") : std::string{}, addNodes);
    if (!drawn.ok()) {
        play_.screenshot = saves;
        return goBack(drawn.error());
    }
    LoopFrame frame = std::move(*drawn);
    budget_.learn(frame);
    const bool whole = frame.outcome.report.valid;
    if (whole) lastDrawn_.drew(budget_.asked, loop_.request.settings);
    if (saves && whole) saveScreenshot(frame, number);
    if (saves && !whole) play_.screenshot = true;  // the next one
    if (watch_ && whole)
        TRY_VOID(
            watch_->follow(loop_, loop_.executor().outputImage(plain), frame.declared.desc(plain)));
    if (whole && radiance.valid()) {
        const auto counted = overlay_->count();
        const graph::Extent size = loop_.request.size;
        const overlay::TruthView view{loop_.snapshot(), loop_.request.camera, size.width,
                                      size.height, loop_.request.settings.maxBounces};
        TRY_VOID(panels_->truth.follow(view, state_.display, loop_.executor().outputImage(radiance),
                                       frame.declared.desc(radiance)));
    }
    if (!radiance.valid()) panels_->truth.rest();
    TRY_VOID(present(frame, shown));
    if (overlay_->visible() && whole) {
        const auto counted = overlay_->count();
        // By the settings that are asked for: what a budget does to them is a part of the series.
        panels_->timing.add(frame.outcome.statistics, overlay_->cpuMilliseconds(),
                            {budget_.asked, loop_.request.size});
    }
    if (whole && number >= options_.warmup.value_or(0) && wantsMeasurements()) {
        trace_.add(frame.outcome.statistics);
        measured_.add(frame);
    }
    last_ = std::move(frame);
    return {};
}

core::Result<void> Viewer::follow() {
    if (followedSeconds_ == loop_.seconds) {
        if (play_.message == undoneMessage_) play_.message.clear();
        return loop_.followEdits();
    }
    TRY_VOID(loop_.follow());
    followedSeconds_ = loop_.seconds;
    if (!edit_ || !loop_.world().alive(edit_->entity)) return {};
    if (undone(edit_->before, edit_->after, movableOf(loop_.world(), edit_->entity)))
        play_.message = undoneMessage_ =
            nameOf(loop_.world(), edit_->entity) + " is moved by its animation; pause to edit it";
    return {};
}

core::Result<void> Viewer::goBack(const core::Error& error) {
    if (!loop_.device().waitIdle().ok()) return error;  // it is lost
    const auto instead = lastDrawn_.insteadOf(budget_.asked, loop_.request.settings);
    if (!instead) return error;
    core::logWarning("{}; back to the last settings that drew", error.message);
    budget_.asked = *instead;
    return loop_.beginAnew();
}

core::Result<void> Viewer::present(const LoopFrame& frame, graph::Image shown) {
    window_.setTitle(title(frame.outcome));
    TRY(const window::Presented presented, presenter_.present(loop_.executor().outputImage(shown)));
    if (presented == window::Presented::Closed) window_.requestClose();
    if (presented == window::Presented::Skipped) window_.waitForEvents(kIdleSeconds);
    // The next frame may make its images anew while this one is still being shown.
    return loop_.device().waitIdle();
}

void Viewer::saveScreenshot(const LoopFrame& frame, uint64_t number) {
    const std::filesystem::path folder =
        options_.screenshots.empty() ? std::filesystem::path(".") : options_.screenshots;
    const auto wanted = folder / fmt::format("lampyris_{:06}.png", number);
    const auto path = replayed_.empty() ? freePath(wanted) : wanted;
    const auto written = writeScreenshot(path, frame.outcome.image);
    withOverlay_ = false;
    play_.message = written.ok() ? "saved " + path.string() : written.error().message;
    if (!written.ok()) core::logWarning("{}", written.error().message);
}

std::string Viewer::title(const photon_gi::Renderer::Outcome& outcome) const {
    if (outcome.report.valid)
        return fmt::format("lampyris: {}, {:.1f} ms{}", options_.scene,
                           outcome.statistics.gpuMilliseconds, budget_.text());
    const shared::FrameCounters& counters = outcome.report.counters;
    return fmt::format(
        "lampyris: INVALID FRAME, {} photons, {} tile entries and {} grid cells dropped, {} in a "
        "tile",
        counters.photonsDropped, counters.pairsDropped, counters.cellsDropped, counters.mostInTile);
}

}  // namespace lampyris::sandbox::view
