/// \file All panels together, with a menu bar to open them: what a game calls between
/// Overlay::begin() and Overlay::addNode().
#pragma once

#include <string>
#include <vector>

#include "overlay/graph_panel.h"
#include "overlay/image_panel.h"
#include "overlay/light_panel.h"
#include "overlay/play_bar.h"
#include "overlay/scene_panel.h"
#include "overlay/settings_panel.h"
#include "overlay/shader_panel.h"
#include "overlay/timing_panel.h"
#include "overlay/truth_panel.h"

namespace lampyris::overlay {

/// What the panels may change.
struct Editable {
    ecs::World& world;
    ecs::Entity& selected;
    photon_gi::Settings& settings;
    const photon_gi::Settings& defaults;
    core::DisplayTransform& display;
    std::optional<double>* budgetMilliseconds = nullptr;  ///< of indirect light; null: not offered
    std::optional<photon_gi::BudgetState> budget{};       ///< where there is one
};

/// Which panels are open.
struct OpenPanels {
    bool timing = true;
    bool graph = false;
    bool light = false;
    bool truth = false;
    bool scene = false;
    bool settings = false;
    bool shaders = false;
};

class Panels {
 public:
    /// \param registry  of the components that the scene panel edits; must outlive this
    static core::Result<Panels> create(gpu::Device& device, const ecs::Registry& registry);

    /// Draws what is open.
    /// \param shaders  those that are followed, see shader_reload::ShaderReloader
    /// \param play  shown in the menu bar; null: none
    void draw(const FrameSeen& seen, const photons::PathSplit& paths, const Editable& edits,
              std::span<const shader_reload::ShaderStatus> shaders = {},
              PlayControls* play = nullptr);

    OpenPanels open;
    MarkChoice marks;
    ImageLook look;
    TimingPanel timing;
    TruthPanel truth;

 private:
    Panels(ImageLook imageLook, TruthPanel truthPanel, const ecs::Registry& registry)
        : look(std::move(imageLook)), truth(std::move(truthPanel)), scene_(registry) {}
    void drawMenu(const FrameSeen& seen, std::span<const shader_reload::ShaderStatus> shaders,
                  PlayControls* play);

    GraphPanel graph_;
    ScenePanel scene_;
};

}  // namespace lampyris::overlay
