#include "thesis/row_store.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "core/file.h"

namespace lampyris::sandbox::thesis {
namespace {

using Json = nlohmann::json;

core::Result<void> append(const std::filesystem::path& file, const std::string& text) {
    std::FILE* opened = std::fopen(file.c_str(), "ab");
    if (opened == nullptr)
        return core::error("{}: cannot write: {}", file.string(), std::strerror(errno));
    const bool wrote = std::fwrite(text.data(), 1, text.size(), opened) == text.size();
    const bool closed = std::fclose(opened) == 0;
    if (wrote && closed) return {};
    return core::error("{}: cannot write: {}", file.string(), std::strerror(errno));
}

Json toJson(const Row& row) {
    Json all = Json::object();
    for (const auto& [contestant, figures] : row) {
        Json& json = all[contestant] = Json::object();
        for (const auto& [name, spread] : figures) json[name] = {spread.mean, spread.stddev};
    }
    return all;
}

std::optional<Spread> spreadFrom(const Json& json) {
    if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number())
        return std::nullopt;
    return Spread{json[0].get<double>(), json[1].get<double>()};
}

std::optional<Row> rowFrom(const Json& json) {
    if (!json.is_object() || json.empty()) return std::nullopt;
    Row row;
    for (const auto& [contestant, figures] : json.items()) {
        if (!figures.is_object()) return std::nullopt;
        for (const auto& [name, values] : figures.items()) {
            const auto spread = spreadFrom(values);
            if (!spread) return std::nullopt;
            row[contestant][name] = *spread;
        }
    }
    return row;
}

}  // namespace

core::Result<RowStore> RowStore::open(const std::filesystem::path& file) {
    RowStore store;
    store.file_ = file;
    TRY_VOID(append(file, ""));
    TRY(const auto bytes, core::readFile(file));
    store.cut_ = !bytes.empty() && bytes.back() != '\n';
    std::istringstream lines(std::string(bytes.begin(), bytes.end()));
    for (std::string line; std::getline(lines, line);) {
        const Json json = Json::parse(line, nullptr, false);
        if (!json.is_object() || !json.contains("settings") || !json.contains("row")) continue;
        if (auto row = rowFrom(json["row"])) store.rows_[json["settings"].dump()] = *std::move(row);
    }
    return store;
}

const Row* RowStore::find(const Json& settings) const {
    const auto found = rows_.find(settings.dump());
    return found == rows_.end() ? nullptr : &found->second;
}

core::Result<void> RowStore::keep(const Json& settings, Row row) {
    if (!file_.empty()) {
        const Json line{{"settings", settings}, {"row", toJson(row)}};
        TRY_VOID(append(file_, (cut_ ? "\n" : "") + line.dump() + "\n"));
        cut_ = false;
    }
    rows_[settings.dump()] = std::move(row);
    return {};
}

}  // namespace lampyris::sandbox::thesis
