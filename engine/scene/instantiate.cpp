#include "scene/instantiate.h"

#include <algorithm>
#include <cmath>
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
        : world_(world), model_(std::move(model)), meshes_(model_.meshes.size()) {
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
            const ecs::Entity entity = addNode(model_.nodes[next.node], next.parent);
            push(model_.nodes[next.node].children, entity);
        }
    }

    [[nodiscard]] size_t directionalLights() const { return directionalLights_; }

 private:
    ecs::Entity addNode(const assets::ModelNode& node, ecs::Entity parent) {
        const ecs::Entity entity =
            addEntity(nameOf(node), {node.translation, node.rotation, node.scale}, parent);
        addPrimitives(node, entity);
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

    void addPrimitives(const assets::ModelNode& node, ecs::Entity entity) {
        const bool several = node.primitives.size() > 1;
        for (const assets::ModelPrimitive& primitive : node.primitives) {
            const MeshInstance drawn{meshId(primitive.mesh), materials_[primitive.material]};
            world_.add(several ? addEntity(nameOf(node), {}, entity) : entity, drawn);
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
    size_t directionalLights_ = 0;
};

}  // namespace

void instantiate(ecs::World& world, assets::Model model, const std::string& scene) {
    if (!model.animations.empty() || !model.skins.empty())
        core::logWarning("{}: animations and skins are not played; it is drawn at rest", scene);
    Instantiation instantiation(world, std::move(model));
    instantiation.addScene();
    if (instantiation.directionalLights() > 0) {
        core::logWarning("{}: directional lights are not supported; {} left out", scene,
                         instantiation.directionalLights());
    }
}

}  // namespace lampyris::scene
