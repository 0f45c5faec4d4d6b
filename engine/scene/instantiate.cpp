#include "scene/instantiate.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/check.h"
#include "core/log.h"
#include "scene/spawn.h"

namespace lampyris::scene {

namespace {

class Instantiation {
 public:
    Instantiation(ecs::World& world, assets::Model model)
        : world_(world),
          model_(std::move(model)),
          meshes_(model_.meshes.size()),
          entities_(model_.nodes.size()),
          drawn_(model_.nodes.size()) {
        auto& library = world_.resource<Library>();
        const auto firstImage = static_cast<int32_t>(library.images().size());
        for (assets::TextureImage& image : model_.images) library.addImage(std::move(image));
        for (assets::Material& material : model_.materials) {
            for (assets::TextureUse* use :
                 {&material.baseColourTexture, &material.metallicRoughnessTexture,
                  &material.emissiveTexture, &material.normalTexture}) {
                if (use->present()) use->image += firstImage;
            }
            materials_.push_back(library.addMaterial(std::move(material)));
        }
    }

    /// Parents before children, without recursion: files may nest as deep as they like.
    void addScene() {
        struct Pending {
            uint32_t node;
            ecs::Entity parent;
        };
        std::vector<Pending> pending;
        const auto push = [&](const std::vector<uint32_t>& nodes, ecs::Entity parent) {
            for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
                pending.push_back({*node, parent});
            }
        };
        push(model_.roots, {});
        while (!pending.empty()) {
            const Pending next = pending.back();
            pending.pop_back();
            push(model_.nodes[next.node].children, addNode(next.node, next.parent));
        }
        for (size_t node = 0; node < drawn_.size(); ++node)
            addSkin(model_.nodes[node], drawn_[node]);
    }

    /// The model's clips, and a player that plays the first.
    void addAnimations(const std::string& name) {
        if (model_.animations.empty()) return;
        auto& library = world_.resource<Library>();
        AnimationPlayer player;
        for (assets::Animation& animation : model_.animations) {
            splitWeights(animation);
            const ClipId clip = library.addClip(std::move(animation));
            if (!player.clip.valid()) player.clip = clip;
        }
        player.targets = std::move(entities_);
        world_.add(addEntity(name, {}, {}), std::move(player));
    }

    [[nodiscard]] size_t directionalLights() const { return directionalLights_; }
    [[nodiscard]] size_t jointsOutside() const { return jointsOutside_; }
    [[nodiscard]] size_t unboundMeshes() const { return unboundMeshes_; }

 private:
    ecs::Entity addNode(uint32_t number, ecs::Entity parent) {
        const assets::ModelNode& node = model_.nodes[number];
        const ecs::Entity entity =
            addEntity(nameOf(node), {node.translation, node.rotation, node.scale}, parent);
        entities_[number] = entity;
        drawn_[number] = addPrimitives(node, entity);
        if (node.camera >= 0) {
            const assets::ModelCamera& camera = model_.cameras[static_cast<size_t>(node.camera)];
            world_.add(entity, Camera{camera.verticalFovRadians, camera.nearMetres});
        }
        if (node.light >= 0) addLight(node, entity);
        return entity;
    }

    ecs::Entity addEntity(std::string name, const Transform& transform, ecs::Entity parent) {
        const ecs::Entity entity = spawn(world_, std::move(name), transform);
        if (parent.valid()) CHECK(ecs::setParent(world_, entity, parent).ok());
        return entity;
    }

    /// A node without a name has its camera's or light's, so that these can be asked for.
    [[nodiscard]] std::string nameOf(const assets::ModelNode& node) const {
        if (!node.name.empty()) return node.name;
        if (node.camera >= 0) return model_.cameras[static_cast<size_t>(node.camera)].name;
        if (node.light >= 0) return model_.lights[static_cast<size_t>(node.light)].name;
        return {};
    }

    /// The entities that show the node's primitives.
    std::vector<ecs::Entity> addPrimitives(const assets::ModelNode& node, ecs::Entity entity) {
        const bool several = node.primitives.size() > 1;
        std::vector<ecs::Entity> drawn;
        for (const assets::ModelPrimitive& primitive : node.primitives) {
            const MeshInstance shown{meshId(primitive.mesh), materials_[primitive.material]};
            drawn.push_back(several ? addEntity(nameOf(node), {}, entity) : entity);
            if (several) world_.add(drawn.back(), MeshPart{});
            world_.add(drawn.back(), shown);
            const assets::Mesh& mesh = meshOf(shown);
            if (!mesh.morphTargets.empty())
                world_.add(drawn.back(),
                           MorphWeights{node.morphWeights.empty() ? mesh.morphWeights
                                                                  : node.morphWeights});
        }
        return drawn;
    }

    [[nodiscard]] const assets::Mesh& meshOf(const MeshInstance& shown) const {
        return *world_.resource<Library>().meshes()[shown.mesh.value].value;
    }

    /// After all nodes have their entities.
    void addSkin(const assets::ModelNode& node, const std::vector<ecs::Entity>& drawn) {
        if (node.skin < 0 || drawn.empty()) return;
        const assets::ModelSkin& from = model_.skins[static_cast<size_t>(node.skin)];
        Skin skin{{}, from.inverseBindMatrices};
        for (const uint32_t joint : from.joints) skin.joints.push_back(entities_[joint]);
        for (const ecs::Entity entity : drawn) {
            if (meshOf(world_.get<MeshInstance>(entity)).joints.empty()) {
                ++unboundMeshes_;
                continue;
            }
            for (const ecs::Entity joint : skin.joints) jointsOutside_ += joint.valid() ? 0 : 1;
            world_.add(entity, skin);
        }
    }

    /// A node's weights are those of each of its primitives. Where these are entities of their own,
    /// they become targets behind the nodes.
    void splitWeights(assets::Animation& animation) {
        const size_t channels = animation.channels.size();
        for (size_t i = 0; i < channels; ++i) {
            assets::AnimationChannel channel = animation.channels[i];
            if (channel.property != assets::AnimatedProperty::Weights) continue;
            const std::vector<ecs::Entity>& parts = drawn_[channel.node];
            for (size_t part = 0; parts.size() > 1 && part < parts.size(); ++part) {
                channel.node = static_cast<uint32_t>(entities_.size());
                entities_.push_back(parts[part]);
                animation.channels.push_back(channel);
            }
        }
    }

    /// Meshes that no node of the scene shows stay out of the library.
    MeshId meshId(uint32_t mesh) {
        if (!meshes_[mesh].valid()) {
            meshes_[mesh] = world_.resource<Library>().addMesh(std::move(model_.meshes[mesh]));
        }
        return meshes_[mesh];
    }

    void addLight(const assets::ModelNode& node, ecs::Entity entity) {
        const assets::ModelLight& light = model_.lights[static_cast<size_t>(node.light)];
        if (light.type == assets::LightType::Directional) {
            ++directionalLights_;
            return;
        }
        SphereLight sphere{.radiusMetres = node.lightRadiusMetres.value_or(light.radiusMetres),
                           .powerWatts = 4.0f * math::kPi * light.intensity * light.colour};
        if (light.type == assets::LightType::Spot) {
            sphere.cosOuterCone = std::cos(light.outerConeRadians);
            sphere.cosInnerCone = std::max(sphere.cosOuterCone, std::cos(light.innerConeRadians));
        }
        world_.add(entity, sphere);
    }

    ecs::World& world_;
    assets::Model model_;
    std::vector<MeshId> meshes_;
    std::vector<MaterialId> materials_;
    std::vector<ecs::Entity> entities_;            ///< by node; none outside the scene
    std::vector<std::vector<ecs::Entity>> drawn_;  ///< by node
    size_t directionalLights_ = 0;
    size_t jointsOutside_ = 0;
    size_t unboundMeshes_ = 0;
};

}  // namespace

void instantiate(ecs::World& world, assets::Model model, const std::string& scene) {
    Instantiation instantiation(world, std::move(model));
    instantiation.addScene();
    instantiation.addAnimations(std::filesystem::path(scene).stem().string());
    if (instantiation.directionalLights() > 0) {
        core::logWarning("{}: directional lights are not supported; {} left out", scene,
                         instantiation.directionalLights());
    }
    if (instantiation.jointsOutside() > 0)
        core::logWarning("{}: {} joints are not in the scene, and stand still", scene,
                         instantiation.jointsOutside());
    if (instantiation.unboundMeshes() > 0)
        core::logWarning("{}: {} meshes have a skin but no joints, and do not follow it", scene,
                         instantiation.unboundMeshes());
}

}  // namespace lampyris::scene
