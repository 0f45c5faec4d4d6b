#include "view/settings_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/file.h"
#include "overlay/setting_list.h"

namespace lampyris::sandbox::view {
namespace {

using Json = nlohmann::ordered_json;
using overlay::SettingInfo;
using photon_gi::Settings;

/// "max bounces" as "max_bounces".
std::string keyOf(const char* name) {
    std::string key(name);
    std::replace_if(
        key.begin(), key.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
    return key;
}

struct Panel {
    const char* name;
    bool overlay::OpenPanels::*open;
};
constexpr std::array kPanels{Panel{"timing", &overlay::OpenPanels::timing},
                             Panel{"graph", &overlay::OpenPanels::graph},
                             Panel{"photons", &overlay::OpenPanels::light},
                             Panel{"truth", &overlay::OpenPanels::truth},
                             Panel{"scene", &overlay::OpenPanels::scene},
                             Panel{"settings", &overlay::OpenPanels::settings},
                             Panel{"shaders", &overlay::OpenPanels::shaders}};

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument(what);
}

template <size_t N>
size_t choiceOf(const Json& value, const std::array<const char*, N>& names,
                const std::string& key) {
    const auto word = value.get<std::string>();
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) refuse(fmt::format("{}: there is no '{}'", key, word));
    return static_cast<size_t>(found - names.begin());
}

double numberOf(const Json& value, double least, double most, const std::string& key) {
    if (!value.is_number()) refuse(fmt::format("{}: is no number", key));
    const double number = value.get<double>();
    if (!(number >= least && number <= most))
        refuse(fmt::format("{}: {} is not from {} to {}", key, number, least, most));
    return number;
}

struct Writer {
    const Settings& s;
    template <typename T>
    Json operator()(T Settings::*field) const {
        if constexpr (std::is_enum_v<T>)
            return name(s.*field);
        else
            return s.*field;
    }
};

struct Reader {
    Settings& s;
    const SettingInfo& info;
    const Json& value;
    const std::string& key;
    void operator()(uint32_t Settings::*field) const {
        const double number = numberOf(value, info.least, info.most, key);
        if (number != std::floor(number))
            refuse(fmt::format("{}: {} is no whole number", key, number));
        s.*field = static_cast<uint32_t>(number);
    }
    void operator()(float Settings::*field) const {
        // The ends are written as the floats nearest to them.
        const double least = std::min(info.least, double{static_cast<float>(info.least)});
        const double most = std::max(info.most, double{static_cast<float>(info.most)});
        s.*field = static_cast<float>(numberOf(value, least, most, key));
    }
    void operator()(bool Settings::*field) const { s.*field = value.get<bool>(); }
    void operator()(photon_gi::Pipeline Settings::*field) const {
        s.*field =
            static_cast<photon_gi::Pipeline>(choiceOf(value, photon_gi::kPipelineNames, key));
    }
    void operator()(photon_gi::Gather Settings::*field) const {
        s.*field = static_cast<photon_gi::Gather>(choiceOf(value, photon_gi::kGatherNames, key));
    }
    void operator()(photon_gi::Retrace Settings::*field) const {
        s.*field = static_cast<photon_gi::Retrace>(choiceOf(value, photon_gi::kRetraceNames, key));
    }
};

void readSettings(const Json& json, Settings& settings) {
    for (const auto& [key, value] : json.items()) {
        const auto list = overlay::settingList();
        const auto info =
            std::find_if(list.begin(), list.end(),
                         [&, k = key](const SettingInfo& i) { return keyOf(i.name) == k; });
        if (info == list.end()) refuse(fmt::format("settings.{}: there is no such setting", key));
        const std::string path = "settings." + key;
        std::visit(Reader{settings, *info, value, path}, info->field);
    }
}

void readPanels(const Json& json, overlay::OpenPanels& panels) {
    for (const Panel& panel : kPanels)
        if (json.contains(panel.name)) panels.*panel.open = json.at(panel.name).get<bool>();
}

glm::mat4 matrixOf(const Json& json) {
    if (!json.is_array() || json.size() != 16) refuse("camera_to_world: is no list of 16 numbers");
    glm::mat4 matrix;
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = static_cast<float>(
            numberOf(json[static_cast<size_t>(i)], -1e9, 1e9, "camera_to_world"));
    const glm::mat3 axes(matrix);
    const glm::mat3 gram = glm::transpose(axes) * axes - glm::mat3(1.0f);
    for (int i = 0; i < 9; ++i)
        if (std::abs(gram[i / 3][i % 3]) > 1e-3f) refuse("camera_to_world: is not rigid");
    return matrix;
}

void read(const Json& json, ViewState& state) {
    if (json.contains("settings")) readSettings(json["settings"], state.settings);
    if (json.contains("panels")) readPanels(json["panels"], state.panels);
    if (json.contains("exposure"))
        state.display.exposureEv =
            static_cast<float>(numberOf(json["exposure"], -100, 100, "exposure"));
    if (json.contains("tonemap"))
        state.display.tonemap =
            static_cast<core::Tonemap>(choiceOf(json["tonemap"], core::kTonemapNames, "tonemap"));
    if (json.contains("overlay")) state.overlay = json["overlay"].get<bool>();
    if (json.contains("full_screen")) state.fullScreen = json["full_screen"].get<bool>();
    if (json.contains("walks")) state.walks = json["walks"].get<bool>();
    if (json.contains("time_scale"))
        state.timeScale = static_cast<float>(numberOf(json["time_scale"], -100, 100, "time_scale"));
    if (json.contains("render_scale"))
        state.renderScale = static_cast<float>(
            numberOf(json["render_scale"], kLeastRenderScale, 1.0, "render_scale"));
    if (json.contains("timestep")) state.timestep = numberOf(json["timestep"], 0, 1e6, "timestep");
    if (json.contains("start_seconds"))
        state.startSeconds = numberOf(json["start_seconds"], -1e6, 1e6, "start_seconds");
    if (json.contains("camera_to_world")) state.cameraToWorld = matrixOf(json["camera_to_world"]);
    if (json.contains("size")) {
        const auto side = [&](size_t i) {
            return static_cast<uint32_t>(numberOf(json["size"].at(i), 1, 65535, "size"));
        };
        state.size = graph::Extent{side(0), side(1)};
    }
}

}  // namespace

core::Result<void> parseState(std::string_view text, ViewState& state) {
    ViewState changed = state;
    try {
        read(Json::parse(text), changed);
    } catch (const std::exception& e) {
        return core::error("{}", e.what());
    }
    state = changed;
    return {};
}

core::Result<void> readState(const std::filesystem::path& path, ViewState& state) {
    std::error_code code;
    if (!std::filesystem::exists(path, code)) return {};
    TRY(const auto bytes, core::readFile(path));
    const auto parsed = parseState(std::string(bytes.begin(), bytes.end()), state);
    if (!parsed.ok()) return core::error("{}: {}", path.string(), parsed.error().message);
    return {};
}

std::string stateText(const ViewState& state) {
    Json settings;
    for (const SettingInfo& info : overlay::settingList())
        settings[keyOf(info.name)] = std::visit(Writer{state.settings}, info.field);
    Json panels;
    for (const Panel& panel : kPanels) panels[panel.name] = state.panels.*panel.open;
    Json json{{"settings", settings},
              {"exposure", state.display.exposureEv},
              {"tonemap", core::name(state.display.tonemap)},
              {"panels", panels},
              {"overlay", state.overlay},
              {"full_screen", state.fullScreen},
              {"walks", state.walks},
              {"time_scale", state.timeScale},
              {"render_scale", state.renderScale}};
    if (state.timestep) json["timestep"] = *state.timestep;
    if (state.startSeconds) json["start_seconds"] = *state.startSeconds;
    if (state.size) json["size"] = {state.size->width, state.size->height};
    if (state.cameraToWorld) {
        json["camera_to_world"] = Json::array();
        for (int i = 0; i < 16; ++i)
            json["camera_to_world"].push_back((*state.cameraToWorld)[i / 4][i % 4]);
    }
    return json.dump(2) + "\n";
}

core::Result<void> writeState(const std::filesystem::path& path, const ViewState& state) {
    return core::writeFile(path, stateText(state));
}

}  // namespace lampyris::sandbox::view
