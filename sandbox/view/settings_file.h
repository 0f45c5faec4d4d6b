/// \file What `view --settings FILE.json` reads at its start, and writes back at its end.
#pragma once

#include <filesystem>
#include <optional>

#include "core/display.h"
#include "core/result.h"
#include "graph/resource.h"
#include "math/glm.h"
#include "overlay/panels.h"
#include "photon_gi/settings.h"

namespace lampyris::sandbox::view {

constexpr double kLeastRenderScale = 0.05;

struct ViewState {
    photon_gi::Settings settings;
    core::DisplayTransform display;
    overlay::OpenPanels panels;
    bool overlay = true;
    bool fullScreen = false;
    std::optional<graph::Extent> size;  ///< of the window
    std::optional<glm::mat4> cameraToWorld;
    float timeScale = 1.0f;
    float renderScale = 1.0f;  ///< picture pixels a window pixel, an axis
    bool walks = false;
    // Of a record: seconds a frame and of the first, and what the panels' default buttons set.
    std::optional<double> timestep, startSeconds;
    std::optional<photon_gi::Settings> defaults;
};

/// Reads what the file names into `state`, and leaves the rest as it is; a file that is not there
/// names nothing. Errors name the file and the key that is unknown, or its value that is wrong, and
/// change nothing.
core::Result<void> readState(const std::filesystem::path& path, ViewState& state);
core::Result<void> writeState(const std::filesystem::path& path, const ViewState& state);

/// The same as text, and back; errors name the value.
[[nodiscard]] std::string stateText(const ViewState& state);
core::Result<void> parseState(std::string_view text, ViewState& state);

}  // namespace lampyris::sandbox::view
