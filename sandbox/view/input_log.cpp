#include "view/input_log.h"

#include <fmt/format.h>

#include <bit>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/file.h"

namespace lampyris::sandbox::view {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 2;
constexpr uint32_t kMostSide = 65535;

template <size_t N>
Json indicesOf(const std::array<bool, N>& flags) {
    Json indices = Json::array();
    for (size_t i = 0; i < N; ++i)
        if (flags[i]) indices.push_back(i);
    return indices;
}

template <size_t N>
std::array<bool, N> flagsOf(const Json& indices) {
    std::array<bool, N> flags{};
    for (const Json& index : indices) flags.at(index.get<size_t>()) = true;
    return flags;
}

Json pairOf(graph::Extent extent) {
    return {extent.width, extent.height};
}

graph::Extent extentOf(const Json& pair) {
    const graph::Extent extent{pair.at(0).get<uint32_t>(), pair.at(1).get<uint32_t>()};
    if (extent.width < 1 || extent.height < 1 || extent.width > kMostSide ||
        extent.height > kMostSide)
        throw std::out_of_range("a size of no picture");
    return extent;
}

/// Numbers come back as the same bits: JSON's shortest text of a double is exact.
Json toJson(const Moment& m) {
    Json typed = Json::array();
    for (const char32_t character : m.input.typed) typed.push_back(uint32_t{character});
    return {{"seconds", m.seconds},
            {"window", pairOf(m.windowSize)},
            {"size", pairOf(m.size)},
            {"held", indicesOf(m.input.held)},
            {"pressed", indicesOf(m.input.pressed)},
            {"buttons", indicesOf(m.input.buttons)},
            {"clicked", indicesOf(m.input.clicked)},
            {"typed", typed},
            {"cursor", {m.input.cursorX, m.input.cursorY}},
            {"moved", {m.input.movedX, m.input.movedY}},
            {"scrolled", m.input.scrolled}};
}

Moment toMoment(const Json& j) {
    Moment m;
    m.seconds = j.at("seconds").get<float>();
    m.windowSize = extentOf(j.at("window"));
    m.size = extentOf(j.at("size"));
    m.input.held = flagsOf<window::kKeyCount>(j.at("held"));
    m.input.pressed = flagsOf<window::kKeyCount>(j.at("pressed"));
    m.input.buttons = flagsOf<3>(j.at("buttons"));
    m.input.clicked = flagsOf<3>(j.at("clicked"));
    for (const Json& character : j.at("typed"))
        m.input.typed += static_cast<char32_t>(character.get<uint32_t>());
    m.input.cursorX = j.at("cursor").at(0).get<double>();
    m.input.cursorY = j.at("cursor").at(1).get<double>();
    m.input.movedX = j.at("moved").at(0).get<double>();
    m.input.movedY = j.at("moved").at(1).get<double>();
    m.input.scrolled = j.at("scrolled").get<double>();
    return m;
}

core::Result<void> checkHead(const std::filesystem::path& path, const Json& head,
                             const InputHead& wanted) {
    if (head.value("lampyris_inputs", 0) != kVersion)
        return core::error("{}: is no log of inputs, or one of another version", path.string());
    for (const auto& [key, now] : {std::pair{"scene", &wanted.scene},
                                   {"camera", &wanted.camera},
                                   {"animation", &wanted.animation}}) {
        const std::string then = head.value(key, *now);  // one written by hand may not say
        if (then != *now)
            return core::error("{}: was recorded with {} '{}', not '{}'", path.string(), key, then,
                               *now);
    }
    return {};
}

}  // namespace

InputRecorder::InputRecorder(const InputHead& head, const std::string& state)
    : text_(Json{{"lampyris_inputs", kVersion},
                 {"scene", head.scene},
                 {"camera", head.camera},
                 {"animation", head.animation},
                 {"state", Json::parse(state)}}
                .dump() +
            "\n") {}

void InputRecorder::add(const Moment& moment) {
    text_ += toJson(moment).dump() + "\n";
}

core::Result<void> InputRecorder::write(const std::filesystem::path& path) const {
    return core::writeFile(path, text_);
}

core::Result<InputLog> readInputLog(const std::filesystem::path& path, const InputHead& head) {
    TRY(const auto bytes, core::readFile(path));
    std::istringstream lines(std::string(bytes.begin(), bytes.end()));
    InputLog log;
    std::string line;
    for (size_t number = 1; std::getline(lines, line); ++number) {
        try {
            const Json json = Json::parse(line);
            if (number > 1) {
                log.moments.push_back(toMoment(json));
                continue;
            }
            TRY_VOID(checkHead(path, json, head));
            log.state = json.value("state", Json::object()).dump();
        } catch (const std::exception& e) {
            return core::error("{}:{}: is no moment of inputs ({})", path.string(), number,
                               e.what());
        }
    }
    if (log.moments.empty()) return core::error("{}: holds no inputs", path.string());
    return log;
}

}  // namespace lampyris::sandbox::view
