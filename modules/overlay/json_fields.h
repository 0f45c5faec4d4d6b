/// \file A component's JSON as fields to edit: numbers, vectors, words, switches, lists.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace lampyris::overlay {

/// One field for every value in it. True where the user changed one; kinds stay as they were.
bool editFields(nlohmann::json& value);

}  // namespace lampyris::overlay
