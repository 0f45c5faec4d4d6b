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
    return reflection;
}

}  // namespace lampyris::embed
