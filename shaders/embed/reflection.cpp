#include "embed/reflection.h"

#include <spirv_cross/spirv_cross_c.h>

#include <algorithm>
#include <memory>

namespace lampyris::embed {
namespace {

using core::Result;

struct ContextDestroyer {
    void operator()(spvc_context context) const { spvc_context_destroy(context); }
};

struct Module {
    std::unique_ptr<spvc_context_s, ContextDestroyer> context;
    spvc_compiler compiler = nullptr;
    spvc_resources resources = nullptr;

    [[nodiscard]] core::Error failure() const {
        return core::error("{}", spvc_context_get_last_error_string(context.get()));
    }
    [[nodiscard]] std::span<const spvc_reflected_resource> list(spvc_resource_type type) const {
        const spvc_reflected_resource* first = nullptr;
        size_t count = 0;
        spvc_resources_get_resource_list_for_type(resources, type, &first, &count);
        return {first, count};
    }
    [[nodiscard]] uint32_t decoration(uint32_t id, SpvDecoration which) const {
        return spvc_compiler_get_decoration(compiler, id, which);
    }
    [[nodiscard]] bool has(uint32_t id, SpvDecoration which) const {
        return spvc_compiler_has_decoration(compiler, id, which) != SPVC_FALSE;
    }
};

Result<Module> open(std::span<const uint32_t> words) {
    Module module;
    spvc_context context = nullptr;
    if (spvc_context_create(&context) != SPVC_SUCCESS)
        return core::error("spirv-cross cannot start");
    module.context.reset(context);
    spvc_parsed_ir ir = nullptr;
    if (spvc_context_parse_spirv(context, words.data(), words.size(), &ir) != SPVC_SUCCESS ||
        spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir,
                                     SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                     &module.compiler) != SPVC_SUCCESS ||
        spvc_compiler_create_shader_resources(module.compiler, &module.resources) != SPVC_SUCCESS)
        return module.failure();
    return module;
}

std::string nameOf(const Module& module, const spvc_reflected_resource& resource) {
    // A block may have no instance name: then its type's name is what the author knows it by.
    const std::string instance = spvc_compiler_get_name(module.compiler, resource.id);
    return instance.empty() ? resource.name : instance;
}

bool isTexelBuffer(const Module& module, const spvc_reflected_resource& resource) {
    const spvc_type type = spvc_compiler_get_type_handle(module.compiler, resource.type_id);
    return spvc_type_get_image_dimension(type) == SpvDimBuffer;
}

const char* kindOf(const Module& module, spvc_resource_type type,
                   const spvc_reflected_resource& resource) {
    switch (type) {
        case SPVC_RESOURCE_TYPE_STORAGE_BUFFER:
            return "StorageBuffer";
        case SPVC_RESOURCE_TYPE_UNIFORM_BUFFER:
            return "UniformBuffer";
        case SPVC_RESOURCE_TYPE_STORAGE_IMAGE:
            return isTexelBuffer(module, resource) ? "StorageTexelBuffer" : "StorageImage";
        default:
            return isTexelBuffer(module, resource) ? "UniformTexelBuffer" : "SampledImage";
    }
}

/// readonly and writeonly may stand on the variable or on every member of its block.
void readAccess(const Module& module, spvc_resource_type type,
                const spvc_reflected_resource& resource, Slot& slot) {
    if (type != SPVC_RESOURCE_TYPE_STORAGE_BUFFER && type != SPVC_RESOURCE_TYPE_STORAGE_IMAGE)
        return;
    slot.writes = !module.has(resource.id, SpvDecorationNonWritable);
    slot.reads = !module.has(resource.id, SpvDecorationNonReadable);
    if (type != SPVC_RESOURCE_TYPE_STORAGE_BUFFER) return;
    const SpvDecoration* first = nullptr;
    size_t count = 0;
    if (spvc_compiler_get_buffer_block_decorations(module.compiler, resource.id, &first, &count) !=
        SPVC_SUCCESS)
        return;
    for (const SpvDecoration decoration : std::span{first, count}) {
        if (decoration == SpvDecorationNonWritable) slot.writes = false;
        if (decoration == SpvDecorationNonReadable) slot.reads = false;
    }
}

Result<Slot> readSlot(const Module& module, spvc_resource_type type,
                      const spvc_reflected_resource& resource) {
    Slot slot;
    slot.name = nameOf(module, resource);
    slot.slot = module.decoration(resource.id, SpvDecorationBinding);
    if (module.decoration(resource.id, SpvDecorationDescriptorSet) != 0)
        return core::error("{}: only set 0 is used", slot.name);
    const spvc_type handle = spvc_compiler_get_type_handle(module.compiler, resource.type_id);
    if (spvc_type_get_num_array_dimensions(handle) != 0)
        return core::error("{}: an array of resources needs bindless descriptors; use layers",
                           slot.name);
    slot.kind = kindOf(module, type, resource);
    readAccess(module, type, resource, slot);
    return slot;
}

Result<std::vector<Slot>> readSlots(const Module& module) {
    for (const spvc_resource_type type :
         {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, SPVC_RESOURCE_TYPE_SUBPASS_INPUT})
        for (const auto& resource : module.list(type))
            return core::error("{}: use a combined sampler", nameOf(module, resource));
    std::vector<Slot> slots;
    for (const spvc_resource_type type :
         {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER,
          SPVC_RESOURCE_TYPE_STORAGE_IMAGE, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE,
          SPVC_RESOURCE_TYPE_SEPARATE_IMAGE})
        for (const auto& resource : module.list(type)) {
            // spirv-cross files a samplerBuffer under "separate image"; a texture2D is none of
            // ours.
            if (type == SPVC_RESOURCE_TYPE_SEPARATE_IMAGE && !isTexelBuffer(module, resource))
                return core::error("{}: use a combined sampler", nameOf(module, resource));
            TRY(Slot slot, readSlot(module, type, resource));
            slots.push_back(std::move(slot));
        }
    std::sort(slots.begin(), slots.end(),
              [](const Slot& a, const Slot& b) { return a.slot < b.slot; });
    const auto twin = std::adjacent_find(
        slots.begin(), slots.end(), [](const Slot& a, const Slot& b) { return a.slot == b.slot; });
    if (twin != slots.end())
        return core::error("{} and {}: both in slot {}", twin->name, (twin + 1)->name, twin->slot);
    return slots;
}

std::string scalarOf(spvc_basetype type) {
    switch (type) {
        case SPVC_BASETYPE_FP32:
            return "float";
        case SPVC_BASETYPE_INT32:
            return "int";
        case SPVC_BASETYPE_UINT32:
            return "uint";
        default:
            return fmt::format("type{}", static_cast<int>(type));
    }
}

uint32_t elementsOf(const Module& module, spvc_type type, uint32_t dimension) {
    const SpvId size = spvc_type_get_array_dimension(type, dimension);
    if (spvc_type_array_dimension_is_literal(type, dimension) != SPVC_FALSE) return size;
    const spvc_constant constant = spvc_compiler_get_constant_handle(module.compiler, size);
    return constant == nullptr ? 1u : spvc_constant_get_scalar_u32(constant, 0, 0);
}

std::string typeName(const Module& module, spvc_type type) {
    const spvc_basetype base = spvc_type_get_basetype(type);
    const uint32_t size = spvc_type_get_vector_size(type);
    const uint32_t columns = spvc_type_get_columns(type);
    std::string text = scalarOf(base);
    if (columns > 1)
        text = fmt::format("mat{}x{} of {}", columns, size, text);
    else if (size > 1)
        text = fmt::format("{}vec{}",
                           base == SPVC_BASETYPE_FP32 ? "" : std::string(1, text.front()), size);
    for (uint32_t i = spvc_type_get_num_array_dimensions(type); i-- > 0;)
        text += fmt::format("[{}]", elementsOf(module, type, i));
    return text;
}

std::vector<StageValue> readStage(const Module& module, spvc_resource_type which) {
    std::vector<StageValue> values;
    for (const auto& resource : module.list(which))
        values.push_back({nameOf(module, resource),
                          module.decoration(resource.id, SpvDecorationLocation),
                          typeName(module, spvc_compiler_get_type_handle(module.compiler,
                                                                         resource.type_id))});
    return values;
}

struct Room {
    uint64_t bytes = 0;
    uint64_t alignment = 4;
};

uint64_t roundUp(uint64_t bytes, uint64_t alignment) {
    return (bytes + alignment - 1) / alignment * alignment;
}

/// As in std430: drivers need no more.
Room roomOf(const Module& module, spvc_type type) {
    Room room;
    if (spvc_type_get_basetype(type) == SPVC_BASETYPE_STRUCT) {
        for (uint32_t i = 0; i < spvc_type_get_num_member_types(type); ++i) {
            const Room member =
                roomOf(module, spvc_compiler_get_type_handle(module.compiler,
                                                             spvc_type_get_member_type(type, i)));
            room.bytes = roundUp(room.bytes, member.alignment) + member.bytes;
            room.alignment = std::max(room.alignment, member.alignment);
        }
    } else {
        const uint32_t size = spvc_type_get_vector_size(type);
        const uint64_t scalar = std::max(spvc_type_get_bit_width(type) / 8, 4u);
        room.alignment = scalar * (size == 3 ? 4 : size);
        room.bytes = scalar * size;
        if (const uint32_t columns = spvc_type_get_columns(type); columns > 1)
            room.bytes = room.alignment * columns;
    }
    for (uint32_t i = 0; i < spvc_type_get_num_array_dimensions(type); ++i)
        room.bytes = roundUp(room.bytes, room.alignment) * elementsOf(module, type, i);
    return room;
}

/// spirv-cross lists no variables of a workgroup; the words have been parsed, so their lengths are
/// right.
uint64_t readSharedBytes(const Module& module, std::span<const uint32_t> words) {
    constexpr size_t kHeaderWords = 5;
    uint64_t bytes = 0;
    for (size_t i = kHeaderWords; i + 3 < words.size(); i += std::max(words[i] >> 16, 1u))
        if ((words[i] & 0xffffu) == SpvOpVariable && words[i + 3] == SpvStorageClassWorkgroup) {
            const Room room =
                roomOf(module, spvc_compiler_get_type_handle(module.compiler, words[i + 1]));
            bytes = roundUp(bytes, room.alignment) + room.bytes;
        }
    return bytes;
}

}  // namespace

Result<Reflection> reflect(std::span<const uint32_t> words) {
    TRY(const Module module, open(words));
    Reflection reflection;
    TRY(reflection.slots, readSlots(module));
    for (const auto& block : module.list(SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
        size_t bytes = 0;
        const spvc_type type = spvc_compiler_get_type_handle(module.compiler, block.base_type_id);
        if (spvc_compiler_get_declared_struct_size(module.compiler, type, &bytes) != SPVC_SUCCESS)
            return module.failure();
        reflection.pushConstantBytes = static_cast<uint32_t>(bytes);
    }
    if (spvc_compiler_get_execution_model(module.compiler) == SpvExecutionModelGLCompute)
        for (uint32_t axis = 0; axis < 3; ++axis)
            reflection.workgroupSize[axis] = spvc_compiler_get_execution_mode_argument_by_index(
                module.compiler, SpvExecutionModeLocalSize, axis);
    reflection.inputs = readStage(module, SPVC_RESOURCE_TYPE_STAGE_INPUT);
    reflection.outputs = readStage(module, SPVC_RESOURCE_TYPE_STAGE_OUTPUT);
    const SpvCapability* capabilities = nullptr;
    size_t count = 0;
    if (spvc_compiler_get_declared_capabilities(module.compiler, &capabilities, &count) !=
        SPVC_SUCCESS)
        return module.failure();
    reflection.capabilities.assign(capabilities, capabilities + count);
    reflection.sharedBytes = readSharedBytes(module, words);
    return reflection;
}

}  // namespace lampyris::embed
