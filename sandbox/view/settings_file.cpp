#include "view/settings_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/file.h"
#include "math/rigid.h"
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

/// For an error's line: the value as it stands in the file, or how it begins.
std::string shown(const Json& value) {
    constexpr size_t kMost = 40;
    const std::string text = value.dump(-1, ' ', true);  // in ASCII, so that it may be cut anywhere
    return text.size() > kMost ? text.substr(0, kMost) + "…" : text;
}

bool flagOf(const Json& value, const std::string& key) {
    if (!value.is_boolean()) refuse(fmt::format("{}: {} is not true or false", key, shown(value)));
    return value.get<bool>();
}

void checkObject(const Json& value, const std::string& key) {
    if (!value.is_object()) refuse(fmt::format("{}: {} is no object", key, shown(value)));
}

template <size_t N>
size_t choiceOf(const Json& value, const std::array<const char*, N>& names,
                const std::string& key) {
    if (!value.is_string()) refuse(fmt::format("{}: {} is no word", key, shown(value)));
    const auto word = value.get<std::string>();
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) refuse(fmt::format("{}: there is no '{}'", key, word));
    return static_cast<size_t>(found - names.begin());
}

double numberOf(const Json& value, double least, double most, const std::string& key) {
    if (!value.is_number()) refuse(fmt::format("{}: {} is no number", key, shown(value)));
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
    void operator()(bool Settings::*field) const { s.*field = flagOf(value, key); }
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

void readSettings(const Json& json, const std::string& group, Settings& settings) {
    checkObject(json, group);
    for (const auto& [key, value] : json.items()) {
        const auto list = overlay::settingList();
        const auto info =
            std::find_if(list.begin(), list.end(),
                         [&, k = key](const SettingInfo& i) { return keyOf(i.name) == k; });
        const std::string path = fmt::format("{}.{}", group, key);
        if (info == list.end()) refuse(fmt::format("{}: there is no such setting", path));
        std::visit(Reader{settings, *info, value, path}, info->field);
    }
}

void readPanels(const Json& json, overlay::OpenPanels& panels) {
    checkObject(json, "panels");
    for (const auto& [key, value] : json.items()) {
        const auto panel = std::find_if(kPanels.begin(), kPanels.end(),
                                        [&, k = key](const Panel& p) { return p.name == k; });
        if (panel == kPanels.end()) refuse(fmt::format("panels.{}: there is no such panel", key));
        panels.*panel->open = flagOf(value, "panels." + key);
    }
}

glm::mat4 matrixOf(const Json& json) {
    if (!json.is_array() || json.size() != 16)
        refuse(fmt::format("camera_to_world: {} is no list of 16 numbers", shown(json)));
    glm::mat4 matrix;
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = static_cast<float>(
            numberOf(json[static_cast<size_t>(i)], -1e9, 1e9, "camera_to_world"));
    const glm::mat3 axes(matrix);
    const glm::mat3 gram = glm::transpose(axes) * axes - glm::mat3(1.0f);
    float off = 0.0f;
    for (int i = 0; i < 9; ++i) off = std::max(off, std::abs(gram[i / 3][i % 3]));
    if (!(off <= 1e-3f) || glm::determinant(axes) < 0.0f) refuse("camera_to_world: is not rigid");
    // What a run wrote is nearer than that, and comes back to the bit.
    if (off <= 1e-5f) return matrix;
    return math::rigidPart(matrix);
}

graph::Extent sizeOf(const Json& json) {
    if (!json.is_array() || json.size() != 2)
        refuse(fmt::format("size: {} is no list of 2 numbers", shown(json)));
    const auto side = [&](size_t i) {
        const double number = numberOf(json[i], 1, 65535, "size");
        if (number != std::floor(number))
            refuse(fmt::format("size: {} is no whole number", number));
        return static_cast<uint32_t>(number);
    };
    return {side(0), side(1)};
}

struct Value {
    const char* key;
    void (*read)(const Json& value, const std::string& key, ViewState& state);
};
using Key = const std::string&;
constexpr std::array kValues{
    Value{"settings", [](const Json& v, Key k, ViewState& s) { readSettings(v, k, s.settings); }},
    Value{"defaults",
          [](const Json& v, Key k, ViewState& s) { readSettings(v, k, s.defaults.emplace()); }},
    Value{"panels", [](const Json& v, Key, ViewState& s) { readPanels(v, s.panels); }},
    Value{"exposure",
          [](const Json& v, Key k, ViewState& s) {
              s.display.exposureEv = static_cast<float>(numberOf(v, -100, 100, k));
          }},
    Value{"tonemap",
          [](const Json& v, Key k, ViewState& s) {
              s.display.tonemap = static_cast<core::Tonemap>(choiceOf(v, core::kTonemapNames, k));
          }},
    Value{"overlay", [](const Json& v, Key k, ViewState& s) { s.overlay = flagOf(v, k); }},
    Value{"full_screen", [](const Json& v, Key k, ViewState& s) { s.fullScreen = flagOf(v, k); }},
    Value{"walks", [](const Json& v, Key k, ViewState& s) { s.walks = flagOf(v, k); }},
    Value{"time_scale",
          [](const Json& v, Key k, ViewState& s) {
              s.timeScale = static_cast<float>(numberOf(v, -100, 100, k));
          }},
    Value{"render_scale",
          [](const Json& v, Key k, ViewState& s) {
              s.renderScale = static_cast<float>(numberOf(v, kLeastRenderScale, 1.0, k));
          }},
    Value{"timestep",
          [](const Json& v, Key k, ViewState& s) { s.timestep = numberOf(v, 0, 1e6, k); }},
    Value{"start_seconds",
          [](const Json& v, Key k, ViewState& s) { s.startSeconds = numberOf(v, -1e6, 1e6, k); }},
    Value{"camera_to_world",
          [](const Json& v, Key, ViewState& s) { s.cameraToWorld = matrixOf(v); }},
    Value{"size", [](const Json& v, Key, ViewState& s) { s.size = sizeOf(v); }}};

void read(const Json& json, ViewState& state) {
    if (!json.is_object()) refuse(fmt::format("{} is no object of settings", shown(json)));
    for (const auto& [key, value] : json.items()) {
        const auto found = std::find_if(kValues.begin(), kValues.end(),
                                        [&, k = key](const Value& v) { return v.key == k; });
        if (found == kValues.end()) refuse(fmt::format("{}: there is no such key", key));
        found->read(value, key, state);
    }
}

Json jsonOf(const Settings& settings) {
    Json json;
    for (const SettingInfo& info : overlay::settingList())
        json[keyOf(info.name)] = std::visit(Writer{settings}, info.field);
    return json;
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
    Json panels;
    for (const Panel& panel : kPanels) panels[panel.name] = state.panels.*panel.open;
    Json json{{"settings", jsonOf(state.settings)},
              {"exposure", state.display.exposureEv},
              {"tonemap", core::name(state.display.tonemap)},
              {"panels", panels},
              {"overlay", state.overlay},
              {"full_screen", state.fullScreen},
              {"walks", state.walks},
              {"time_scale", state.timeScale},
              {"render_scale", state.renderScale}};
    if (state.defaults) json["defaults"] = jsonOf(*state.defaults);
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
