/// \file Finished rows of a benchmark, kept in a file, so that a run that was stopped can be taken
/// up again. A line a row: JSON of the settings that it was measured with, and its figures.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/result.h"
#include "thesis/figures.h"

namespace lampyris::sandbox::thesis {

class RowStore {
 public:
    /// Keeps rows in memory alone.
    RowStore() = default;
    /// Reads what the file holds; lines that are cut or damaged are as if they were not there, and
    /// are measured again. Error: the file cannot be written.
    static core::Result<RowStore> open(const std::filesystem::path& file);

    /// The row of just these settings, or null. It lives until the next keep().
    [[nodiscard]] const Row* find(const nlohmann::json& settings) const;
    /// Error: the file cannot be written; the rows before are not touched.
    core::Result<void> keep(const nlohmann::json& settings, Row row);

    [[nodiscard]] size_t rows() const { return rows_.size(); }

 private:
    std::map<std::string, Row> rows_;  ///< by the settings' text
    std::filesystem::path file_;
    bool cut_ = false;  ///< the file's last line has no end
};

}  // namespace lampyris::sandbox::thesis
