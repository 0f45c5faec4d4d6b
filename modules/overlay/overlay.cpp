#include "overlay/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "overlay/feed_input.h"
#include "overlay/panel_node.h"

namespace lampyris::overlay {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float kDoubleClickSeconds = 0.3f;  // [chosen] as Dear ImGui
constexpr float kLeastStep = 1e-4f;          // seconds: ImGui takes no frame of no length

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void chooseStyle() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 4.0f;
    style.FrameRounding = 3.0f;
    style.ItemSpacing = {6.0f, 3.0f};
    style.Colors[ImGuiCol_WindowBg].w = 0.86f;
}

}  // namespace

/// ImGui keeps a pointer to the clipboard: its address must stay.
struct Overlay::State {
    ImGuiContext* context = nullptr;
    gpu::Image font;
    Clipboard clipboard;
    std::string pasted;  ///< what the last paste was given
    bool visible = true;
    bool open = false;   ///< between begin() and end()
    bool drawn = false;  ///< between end() and addNode()
    Clock::time_point begun;
    double milliseconds = 0.0;      ///< of this frame, up to now
    double lastMilliseconds = 0.0;  ///< of the whole frame before

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (context != nullptr) ImGui::DestroyContext(context);
    }
};

Overlay::Overlay(std::unique_ptr<State> state) : state_(std::move(state)) {}
Overlay::Overlay(Overlay&&) noexcept = default;
Overlay::~Overlay() = default;

core::Result<Overlay> Overlay::create(gpu::Device& device, Clipboard clipboard) {
    auto state = std::make_unique<State>();
    state->clipboard = std::move(clipboard);
    state->context = ImGui::CreateContext();
    ImGui::SetCurrentContext(state->context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // where windows lie is the program's to keep
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    mapKeys(io);
    io.ClipboardUserData = state.get();
    io.SetClipboardTextFn = [](void* user, const char* text) {
        const auto& self = *static_cast<State*>(user);
        if (self.clipboard.set) self.clipboard.set(text);
    };
    io.GetClipboardTextFn = [](void* user) -> const char* {
        auto& self = *static_cast<State*>(user);
        self.pasted = self.clipboard.get ? self.clipboard.get() : std::string{};
        return self.pasted.c_str();
    };
    chooseStyle();
    TRY(state->font, makeFont(device));
    return Overlay{std::move(state)};
}

bool Overlay::visible() const {
    return state_->visible;
}

void Overlay::show(bool visible) {
    state_->visible = visible;
    if (!visible) state_->milliseconds = state_->lastMilliseconds = 0.0;
}

void Overlay::begin(const window::Input& input, graph::Extent windowSize, graph::Extent pictureSize,
                    double seconds) {
    if (!state_->visible) return;
    state_->lastMilliseconds = std::exchange(state_->milliseconds, 0.0);
    state_->begun = Clock::now();
    ImGui::SetCurrentContext(state_->context);
    if (state_->open) ImGui::EndFrame();  // the frame before was never drawn
    ImGuiIO& io = ImGui::GetIO();
    const auto width = static_cast<float>(pictureSize.width);
    const auto height = static_cast<float>(pictureSize.height);
    io.DisplaySize = {width, height};
    io.DeltaTime = std::max(static_cast<float>(seconds), kLeastStep);
    // Two presses lie at least two frames apart.
    io.MouseDoubleClickTime = std::max(kDoubleClickSeconds, 2.5f * io.DeltaTime);
    feedInput(io, input, width / static_cast<float>(std::max(windowSize.width, 1u)),
              height / static_cast<float>(std::max(windowSize.height, 1u)));
    ImGui::NewFrame();
    state_->open = true;
}

void Overlay::end() {
    if (!state_->open) return;
    ImGui::SetCurrentContext(state_->context);
    ImGui::Render();
    state_->open = false;
    state_->drawn = true;
    state_->milliseconds += millisecondsSince(state_->begun);
}

bool Overlay::wantsMouse() const {
    ImGui::SetCurrentContext(state_->context);
    return state_->visible && ImGui::GetIO().WantCaptureMouse;
}

bool Overlay::typing() const {
    ImGui::SetCurrentContext(state_->context);
    return state_->visible && ImGui::GetIO().WantTextInput;
}

graph::Image Overlay::addNode(graph::Frame& frame, graph::Image shown, graph::Image picture) {
    end();
    if (!std::exchange(state_->drawn, false)) return shown;
    const Counted counted = count();
    ImGui::SetCurrentContext(state_->context);
    return addPanels(frame, *ImGui::GetDrawData(), state_->font, picture, shown);
}

Overlay::Counted::Counted(double& milliseconds)
    : milliseconds_(milliseconds), begun_(Clock::now()) {}

Overlay::Counted::~Counted() {
    milliseconds_ += millisecondsSince(begun_);
}

Overlay::Counted Overlay::count() {
    return Counted{state_->milliseconds};
}

double Overlay::cpuMilliseconds() const {
    return state_->lastMilliseconds;
}

}  // namespace lampyris::overlay
