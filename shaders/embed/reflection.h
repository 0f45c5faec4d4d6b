/// \file What a compiled shader says of itself: the bindings of set 0, workgroup size, push
/// constants, what passes between stages, what it asks of the device.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"

namespace lampyris::embed {

/// One binding of set 0. `kind` is an enumerator of graph::SlotKind, as text.
struct Slot {
    std::string name;
    uint32_t slot = 0;
    std::string kind;
    bool reads = true;
    bool writes = false;
};

/// What a stage takes from the one before or hands on, built-in values left out.
struct StageValue {
    std::string name;
    uint32_t location = 0;
    std::string type;  ///< as GLSL has it: "vec3"
};

struct Reflection {
    std::vector<Slot> slots;  ///< in ascending order
    std::array<uint32_t, 3> workgroupSize{1, 1, 1};
    uint32_t pushConstantBytes = 0;
    std::vector<StageValue> inputs, outputs;
    std::vector<uint32_t> capabilities;  ///< of SPIR-V, declared
    uint64_t sharedBytes = 0;            ///< of a workgroup, arrays as their constants stand
};

/// Reads SPIR-V words. An error for what the engine does not bind: another set, arrays of
/// resources, separate samplers, two resources in one slot.
core::Result<Reflection> reflect(std::span<const uint32_t> words);

}  // namespace lampyris::embed
