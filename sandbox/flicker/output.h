/// \file What is made of the rows: a table, a map, a plot, files for programs.
#pragma once

#include <string>
#include <vector>

#include "core/display.h"
#include "flicker/measure.h"
#include "table.h"

namespace lampyris::sandbox::flicker {

[[nodiscard]] Table tableOf(const Call& call, const std::vector<Row>& rows);

/// Heat maps of the standard deviation over time, a row each from left to right.
[[nodiscard]] core::DisplayImage mapOf(const std::vector<Row>& rows);

/// "row,sequence,frame,value": still and frozen [F3], moving and floor [F4], off, on and moved
/// [F5].
[[nodiscard]] std::string csvOf(const std::vector<Row>& rows);

/// The same over time, as SVG.
[[nodiscard]] std::string plotOf(const std::vector<Row>& rows);

/// All figures as JSON.
[[nodiscard]] std::string reportOf(const Call& call, const std::vector<Row>& rows);

}  // namespace lampyris::sandbox::flicker
