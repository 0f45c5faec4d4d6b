#include "residency/scene_on_gpu.h"

#include <algorithm>

#include "gpu/device.h"
#include "residency/draw_list.h"
#include "residency/emitters.h"
#include "residency/entry_buffer.h"
#include "residency/mesh_streams.h"
#include "residency/texture_images.h"

namespace lampyris::residency {

struct SceneOnGpu::Parts {
    explicit Parts(gpu::Device& on)
        : device(&on),
          meshes(on),
          posed(on),
          textures(on),
          instances(on, "instances"),
          materials(on, "materials"),
          lights(on, "lights"),
          emitters(on, "emitters"),
          emitterTriangles(on, "emitter triangles", sizeof(glm::vec4)) {}

    core::Result<void> updateInstances(const scene::SceneSnapshot& snapshot);
    core::Result<void> updateMaterials(const scene::SceneSnapshot& snapshot);
    core::Result<void> updateLights(const scene::SceneSnapshot& snapshot);
    core::Result<void> updateEmitters(const scene::SceneSnapshot& snapshot);

    gpu::Device* device;
    MeshStreams meshes;
    PosedInstances posed;
    TextureImages textures;
    EntryBuffer<shared::GpuInstance> instances;
    EntryBuffer<shared::GpuMaterial> materials;
    EntryBuffer<shared::GpuLight> lights;
    ResidentBuffer emitters;
    ResidentBuffer emitterTriangles;
    std::vector<uint64_t> emitterSignature{~uint64_t{0}};  ///< of no scene: the first update builds
    std::vector<shared::GpuEmitter> emitterEntries;
    DrawList draws;
    UploadCounts uploaded;
    SceneHandles counts;  ///< only the numbers
    uint64_t geometryVersion = ~uint64_t{0};
    uint64_t materialVersion = ~uint64_t{0};
    uint64_t lightVersion = ~uint64_t{0};
};

core::Result<void> SceneOnGpu::Parts::updateInstances(const scene::SceneSnapshot& snapshot) {
    const auto keyOf = [&](size_t i) {
        const auto& instance = snapshot.instances[i];
        return std::array<uint64_t, 4>{instance.version, instance.entity.bits,
                                       snapshot.meshes[instance.mesh].version,
                                       snapshot.materials[instance.material].version};
    };
    const auto pack = [&](size_t i) {
        const auto& instance = snapshot.instances[i];
        const MeshRange& mesh = meshes.range(snapshot.meshes[instance.mesh].version);
        return packInstance(instance, *snapshot.materials[instance.material].value,
                            posed.rangeOf(instance, mesh));
    };
    TRY(uploaded.instanceBytes, instances.follow(snapshot.instances.size(), keyOf, pack));
    counts.anyMasked = std::any_of(
        snapshot.instances.begin(), snapshot.instances.end(), [&](const auto& instance) {
            return snapshot.materials[instance.material].value->alphaMode ==
                   assets::AlphaMode::Mask;
        });
    counts.anyColours = std::any_of(snapshot.meshes.begin(), snapshot.meshes.end(),
                                    [](const auto& mesh) { return !mesh.value->colours.empty(); });
    counts.anyEmission =
        std::any_of(snapshot.instances.begin(), snapshot.instances.end(),
                    [&](const auto& instance) { return emits(snapshot, instance); });
    counts.instanceCount = static_cast<uint32_t>(snapshot.instances.size());
    return {};
}

core::Result<void> SceneOnGpu::Parts::updateMaterials(const scene::SceneSnapshot& snapshot) {
    const auto keyOf = [&](size_t i) {
        return std::array<uint64_t, 4>{snapshot.materials[i].version, textures.layoutVersion(), 0,
                                       0};
    };
    const auto pack = [&](size_t i) {
        return packMaterial(*snapshot.materials[i].value, textures.layers());
    };
    TRY(uploaded.materialBytes, materials.follow(snapshot.materials.size(), keyOf, pack));
    counts.anyTextures = textures.any();
    counts.anySpecular =
        std::any_of(snapshot.materials.begin(), snapshot.materials.end(), [](const auto& material) {
            return material.value->specularFactor > 0.0f || material.value->metallic > 0.0f;
        });
    counts.materialCount = static_cast<uint32_t>(snapshot.materials.size());
    return {};
}

core::Result<void> SceneOnGpu::Parts::updateLights(const scene::SceneSnapshot& snapshot) {
    const auto keyOf = [&](size_t i) {
        return std::array<uint64_t, 4>{snapshot.lights[i].version, snapshot.lights[i].entity.bits,
                                       0, 0};
    };
    const auto pack = [&](size_t i) { return packLight(snapshot.lights[i]); };
    TRY(uploaded.lightBytes, lights.follow(snapshot.lights.size(), keyOf, pack));
    counts.lightCount = static_cast<uint32_t>(snapshot.lights.size());
    return {};
}

core::Result<void> SceneOnGpu::Parts::updateEmitters(const scene::SceneSnapshot& snapshot) {
    auto signature = residency::emitterSignature(snapshot);
    if (signature == emitterSignature) return {};
    EmitterTable table = buildEmitters(snapshot);
    const auto entries = std::as_bytes(std::span(table.emitters));
    const auto triangles = std::as_bytes(std::span(table.triangles));
    TRY_VOID(emitters.reserve(std::max(entries.size(), sizeof(shared::GpuEmitter))));
    TRY_VOID(emitterTriangles.reserve(std::max(triangles.size(), sizeof(EmitterTriangle))));
    TRY_VOID(emitters.stage(0, entries));
    TRY_VOID(emitterTriangles.stage(0, triangles));
    uploaded.emitterBytes = entries.size() + triangles.size();
    counts.emitterCount = static_cast<uint32_t>(table.emitters.size());
    emitterEntries = std::move(table.emitters);
    emitterSignature = std::move(signature);
    return {};
}

SceneOnGpu::SceneOnGpu(gpu::Device& device) : parts_(std::make_unique<Parts>(device)) {}
SceneOnGpu::~SceneOnGpu() = default;
SceneOnGpu::SceneOnGpu(SceneOnGpu&&) noexcept = default;
SceneOnGpu& SceneOnGpu::operator=(SceneOnGpu&&) noexcept = default;

core::Result<void> SceneOnGpu::update(const scene::SceneSnapshot& snapshot) {
    Parts& p = *parts_;
    p.uploaded = {};
    const bool geometry = snapshot.geometryVersion != p.geometryVersion;
    const bool material = snapshot.materialVersion != p.materialVersion;
    if (geometry) {
        p.posed.place(snapshot, p.meshes);
        TRY(p.uploaded.geometryBytes, p.meshes.follow(snapshot));
        TRY(p.uploaded.poseBytes, p.posed.load(snapshot, p.meshes));
    } else {
        p.posed.settle();
    }
    if (material) {
        TRY(p.uploaded.textureBytes, p.textures.follow(snapshot));
        TRY_VOID(p.updateMaterials(snapshot));
    }
    if (geometry || material) {
        TRY_VOID(p.updateInstances(snapshot));
        TRY_VOID(p.updateEmitters(snapshot));
        p.draws.follow(snapshot, p.meshes, p.posed);
    } else {
        p.draws.settle(snapshot);
    }
    if (snapshot.lightVersion != p.lightVersion) TRY_VOID(p.updateLights(snapshot));
    p.geometryVersion = snapshot.geometryVersion;
    p.materialVersion = snapshot.materialVersion;
    p.lightVersion = snapshot.lightVersion;
    return {};
}

SceneHandles SceneOnGpu::import(graph::Frame& frame) {
    Parts& p = *parts_;
    const auto stream = [&](MeshStreams::Stream which) {
        return p.meshes.buffer(which).import(frame, "upload meshes");
    };
    SceneHandles handles = p.counts;
    handles.instances = p.instances.import(frame, "upload instances");
    handles.materials = p.materials.import(frame, "upload materials");
    handles.lights = p.lights.import(frame, "upload lights");
    handles.emitters = p.emitters.import(frame, "upload emitters");
    handles.emitterTriangles = p.emitterTriangles.import(frame, "upload emitter triangles");
    handles.indices = stream(MeshStreams::Indices);
    handles.positions = stream(MeshStreams::Positions);
    handles.normals = stream(MeshStreams::Normals);
    handles.tangents = stream(MeshStreams::Tangents);
    handles.texcoords = stream(MeshStreams::Texcoords);
    handles.colours = stream(MeshStreams::Colours);
    p.posed.import(frame, handles);
    handles.colourTextures = p.textures.importColour(frame);
    handles.dataTextures = p.textures.importData(frame);
    return handles;
}

const std::vector<DrawItem>& SceneOnGpu::draws() const {
    return parts_->draws.items();
}
const std::vector<PosedInstance>& SceneOnGpu::posed() const {
    return parts_->posed.list();
}
const std::vector<shared::GpuEmitter>& SceneOnGpu::emitters() const {
    return parts_->emitterEntries;
}

uint32_t SceneOnGpu::lightCount() const {
    return parts_->counts.lightCount;
}
const UploadCounts& SceneOnGpu::lastUpload() const {
    return parts_->uploaded;
}
gpu::Device& SceneOnGpu::device() const {
    return *parts_->device;
}

uint64_t SceneOnGpu::deviceBytes() const {
    const Parts& p = *parts_;
    return p.meshes.bytes() + p.posed.bytes() + p.textures.bytes() + p.instances.bytes() +
           p.materials.bytes() + p.lights.bytes() + p.emitters.bytes() + p.emitterTriangles.bytes();
}

void bindMaterials(graph::ComputeNode& node, const SceneHandles& scene) {
    constexpr auto kLinear = graph::Filtering::Linear;
    constexpr auto kRepeat = graph::Addressing::Repeat;
    node.read(shared::SLOT_INSTANCES, scene.instances)
        .read(shared::SLOT_MATERIALS, scene.materials)
        .texels(shared::SLOT_INDICES, scene.indices, graph::Format::R32Uint)
        .texels(shared::SLOT_TEXCOORDS, scene.texcoords, graph::Format::RGBA32Float)
        .texels(shared::SLOT_COLOURS, scene.colours, graph::Format::RGBA32Float)
        .sample(shared::SLOT_COLOUR_TEXTURES, scene.colourTextures, kLinear, kRepeat)
        .sample(shared::SLOT_DATA_TEXTURES, scene.dataTextures, kLinear, kRepeat)
        .specialise(shared::SPEC_SCENE_TEXTURES, scene.anyTextures ? 1 : 0)
        .specialise(shared::SPEC_SCENE_COLOURS, scene.anyColours ? 1 : 0)
        .specialise(shared::SPEC_SCENE_EMISSION, scene.anyEmission ? 1 : 0);
}

void bindEmitters(graph::ComputeNode& node, const SceneHandles& scene) {
    node.read(shared::SLOT_EMITTERS, scene.emitters)
        .texels(shared::SLOT_EMITTER_TRIANGLES, scene.emitterTriangles, graph::Format::RGBA32Float);
}

}  // namespace lampyris::residency
