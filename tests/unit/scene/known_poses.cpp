// Animated files of others, where they lie beside the repository, against boxes that Blender 3.4.1
// gives the same vertices: imported, an action set, evaluated at fractional frames, z up turned to
// y up. Blender mixes a rotation's numbers where glTF turns evenly: they agree near and halfway
// between keys.
#include <gtest/gtest.h>

#include <filesystem>

#include "scene/extract.h"
#include "scene/load.h"
#include "scene/motion.h"

namespace lampyris::scene {
namespace {

const std::filesystem::path kScenes =
    std::filesystem::path(LAMPYRIS_SOURCE_DIR) / "../shared/scenes";

/// A box that some instance fills.
struct KnownBox {
    const char* file;
    const char* clip;
    double seconds;
    glm::vec3 lower, upper;
};

const std::vector<KnownBox> kBoxes{
    {"Fox/Fox.glb", "Walk", 0.0, {-12.6402, -0.0207176, -95.7646}, {12.545, 76.8578, 68.894}},
    {"Fox/Fox.glb", "Walk", 0.3, {-12.6409, -1.11311, -91.4482}, {12.5445, 75.4747, 69.9818}},
    {"Fox/Fox.glb", "Walk", 0.55, {-12.3695, -0.116008, -96.7584}, {12.8091, 71.977, 70.1671}},
    {"Fox/Fox.glb", "Survey", 0.37, {-23.5352, -0.130901, -85.7078}, {11.5936, 75.358, 62.6181}},
    {"Fox/Fox.glb", "Survey", 1.5, {-11.5958, -0.130741, -83.6924}, {22.0666, 76.8031, 63.5615}},
    {"RiggedSimple/RiggedSimple.gltf", "", 0.5, {-1, -4.57508, -1}, {1.67319, 4.53352, 1}},
    {"RiggedSimple/RiggedSimple.gltf", "", 1.3, {-1, -4.57508, -1}, {2.40204, 4.32548, 1}},
    {"SimpleSkin/SimpleSkin.gltf", "", 0.75, {-1.11521, 0, 0}, {0.538309, 1.8445, 0}},
    {"SimpleSkin/SimpleSkin.gltf", "", 2.2, {-0.900373, 0, 0}, {0.543197, 2.11799, 0}},
    {"SimpleMorph/SimpleMorph.gltf", "", 0.6, {0, 0, 0}, {1.1, 1.1, 0}},
    {"SimpleMorph/SimpleMorph.gltf", "", 1.7, {0, 0, 0}, {1, 2.2, 0}},
    {"SimpleMorph/SimpleMorph.gltf", "", 3.1, {-0.4, 0, 0}, {1, 1.4, 0}},
    {"AnimatedMorphSphere/AnimatedMorphSphere.gltf", "", 0.9, {-1.24695, -1, -1}, {1.24695, 1, 1}},
    {"AnimatedMorphSphere/AnimatedMorphSphere.gltf",
     "",
     2.3,
     {-1.58624, -1, -1.15472},
     {1.58624, 1, 1.09346}},
    {"InterpolationTest/InterpolationTest.glb", "Step Scale", 0.35, {-1, -1, -1}, {1, 1, 1}},
    {"InterpolationTest/InterpolationTest.glb",
     "Linear Scale",
     0.35,
     {-3.88522, -0.588889, -0.588824},
     {-2.70744, 0.588889, 0.588953}},
    {"InterpolationTest/InterpolationTest.glb",
     "Linear Scale",
     1.1,
     {-3.99633, -0.7, -0.699935},
     {-2.59633, 0.7, 0.700065}},
    {"InterpolationTest/InterpolationTest.glb",
     "Linear Rotation",
     0.35,
     {-4.71479, 1.95302, -1},
     {-1.90801, 4.7598, 1}},
    {"InterpolationTest/InterpolationTest.glb", "Step Translation", 1.1, {-1, 5, -1}, {1, 7, 1}},
    {"InterpolationTest/InterpolationTest.glb",
     "Linear Translation",
     0.35,
     {-4.29758, 8.45936, -1},
     {-2.29758, 10.4594, 1}},
    {"InterpolationTest/InterpolationTest.glb",
     "Linear Translation",
     1.1,
     {-4.29758, 7.56, -1},
     {-2.29758, 9.56, 1}},
    {"BoxAnimated/BoxAnimated.gltf",
     "",
     0.8,
     {-0.33504, 1.1128, -0.33504},
     {0.33504, 2.1128, 0.33504}},
    {"BoxAnimated/BoxAnimated.gltf", "", 1.875, {-0.33504, 2.18496, -0.5}, {0.33504, 2.85504, 0.5}},
    {"BoxAnimated/BoxAnimated.gltf",
     "",
     3.0,
     {-0.33504, 0.977238, -0.33504},
     {0.33504, 1.97724, 0.33504}}};

void choose(ecs::World& world, const std::string& clip) {
    const auto& clips = world.resource<Library>().clips();
    for (const auto& [entity, player] : world.view<AnimationPlayer>())
        for (uint32_t i = 0; i < clips.size(); ++i)
            if (clips[i]->name == clip) world.edit<AnimationPlayer>(entity).clip = {i};
}

math::Bounds boxOf(const SceneSnapshot& snapshot, const SnapshotInstance& instance) {
    const assets::Mesh& mesh = *snapshot.meshes[instance.mesh].value;
    math::Bounds box;
    for (const glm::vec3& p :
         posedVertices(mesh, instance.pose ? *instance.pose : Pose{}).positions)
        box.grow(glm::vec3(instance.objectToWorld * glm::vec4(p, 1.0f)));
    return box;
}

class KnownPose : public testing::Test {
 public:
    explicit KnownPose(const KnownBox& known) : known_(known) {}

 private:
    void TestBody() override {
        auto world = readScene((kScenes / known_.file).string());
        ASSERT_TRUE(world.ok()) << world.error().message;
        if (*known_.clip != '\0') choose(*world, known_.clip);
        advanceTo(*world, known_.seconds, 0);
        const SceneSnapshot snapshot = extract(*world, {}, 0);
        float nearest = std::numeric_limits<float>::infinity();
        for (const SnapshotInstance& instance : snapshot.instances) {
            const math::Bounds box = boxOf(snapshot, instance);
            nearest = std::min(nearest, glm::distance(box.lower, known_.lower) +
                                            glm::distance(box.upper, known_.upper));
            // The box that is drawn holds what is drawn.
            EXPECT_TRUE(
                glm::all(glm::lessThanEqual(instance.boundsWorld.lower, box.lower + 1e-4f)));
            EXPECT_TRUE(
                glm::all(glm::greaterThanEqual(instance.boundsWorld.upper, box.upper - 1e-4f)));
        }
        EXPECT_LT(nearest, 2e-3f * glm::distance(known_.lower, known_.upper)) << nearest;
    }
    KnownBox known_;
};

// Registered only where the files are: the tests of a bare clone know nothing of them.
const bool kRegistered = [] {
    for (size_t i = 0; i < kBoxes.size(); ++i) {
        if (!std::filesystem::exists(kScenes / kBoxes[i].file)) continue;
        const std::string name =
            std::filesystem::path(kBoxes[i].file).stem().string() + std::to_string(i);
        // GoogleTest owns what it registers.
        // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks)
        testing::RegisterTest("KnownPose", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                              [i]() -> KnownPose* { return new KnownPose(kBoxes[i]); });
    }
    return true;
}();

}  // namespace
}  // namespace lampyris::scene
