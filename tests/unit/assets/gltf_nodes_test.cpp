#include <gtest/gtest.h>

#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

TEST(GltfNodes, TransformsAreReadAndRotationsMadeUnit) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"][0].update({{"name", "door"},
                                     {"translation", {1, 2, 3}},
                                     {"rotation", {0, 2, 0, 0}},
                                     {"scale", {4, 5, 6}}});
    const assets::ModelNode node = builder.model().nodes.at(0);
    EXPECT_EQ(node.name, "door");
    EXPECT_EQ(node.translation, glm::vec3(1, 2, 3));
    EXPECT_EQ(node.rotation, glm::quat(0, 0, 1, 0));
    EXPECT_EQ(node.scale, glm::vec3(4, 5, 6));
}

TEST(GltfNodes, AMatrixIsTakenApart) {
    GltfBuilder builder = GltfBuilder::triangle();
    // A quarter turn about z, scaled by 2 and 3 before it.
    builder.json["nodes"][0]["matrix"] = {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
    const assets::ModelNode node = builder.model().nodes.at(0);
    EXPECT_EQ(node.translation, glm::vec3(7, 8, 9));
    EXPECT_EQ(node.scale, glm::vec3(2, 3, 1));
    EXPECT_LT(glm::distance(node.rotation * glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)), 1e-6f);
}

TEST(GltfNodes, AShearedMatrixIsAWarning) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_EQ(logOf([&] { EXPECT_TRUE(builder.load()); }),
              "warning: test.gltf: /nodes/0/matrix: shears, and is drawn without that\n");
}

TEST(GltfNodes, ParentsAndChildrenAgree) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.push("nodes", Json::object());
    builder.json["nodes"][0]["children"] = {1};
    const assets::Model model = builder.model();
    EXPECT_EQ(model.nodes.at(0).children, std::vector<uint32_t>{1});
    EXPECT_EQ(model.nodes.at(1).parent, 0);
    EXPECT_EQ(model.nodes.at(0).parent, -1);
    EXPECT_EQ(model.roots, std::vector<uint32_t>{0});
}

TEST(GltfNodes, TheDefaultSceneGivesTheRoots) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addMesh({{"attributes", {{"POSITION", 0}}}});
    builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    EXPECT_EQ(builder.model().roots, std::vector<uint32_t>{0});
    builder.json["scene"] = 1;
    EXPECT_EQ(builder.model().roots, std::vector<uint32_t>{1});
    builder.json.erase("scene");
    builder.json.erase("scenes");
    EXPECT_EQ(builder.model().roots, (std::vector<uint32_t>{0, 1}));
}

TEST(GltfNodes, ASceneWithoutAMeshIsAnError) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.push("nodes", Json::object());
    builder.json["scenes"][0]["nodes"] = {1};
    EXPECT_EQ(builder.error(), "test.gltf: has no mesh in its default scene");
}

TEST(GltfNodes, CamerasInPerspectiveAreKept) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.push("cameras",
                 {{"type", "orthographic"},
                  {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}});
    builder.push("cameras", {{"name", "eye"},
                             {"type", "perspective"},
                             {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}});
    builder.push("nodes", {{"camera", 0}});
    builder.push("nodes", {{"camera", 1}});
    const assets::Model model = builder.model();
    ASSERT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(model.cameras[0].name, "eye");
    EXPECT_EQ(model.cameras[0].verticalFovRadians, 0.5f);
    EXPECT_EQ(model.cameras[0].nearMetres, 0.25f);
    EXPECT_EQ(model.nodes.at(1).camera, -1);
    EXPECT_EQ(model.nodes.at(2).camera, 0);
}

GltfBuilder withLight(const Json& light, const Json& extras) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    builder.push("nodes",
                 {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"extras", extras}});
    return builder;
}

TEST(GltfNodes, LightsHaveARadiusOfTheirOwnOrTheirNodes) {
    const Json point = {
        {"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 3}, {"extras", {{"radius", 0.4}}}};
    const assets::Model model = withLight(point, {{"radius", 0.2}}).model();
    const assets::ModelLight light = model.lights.at(0);
    EXPECT_EQ(light.type, assets::LightType::Point);
    EXPECT_EQ(light.colour, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(light.intensity, 3.0f);
    EXPECT_EQ(light.radiusMetres, 0.4f);
    EXPECT_EQ(model.nodes.at(1).light, 0);
    EXPECT_EQ(model.nodes.at(1).lightRadiusMetres, 0.2f);
    const assets::Model plain = withLight({{"type", "point"}}, Json()).model();
    EXPECT_EQ(plain.lights.at(0).radiusMetres, 0.05f);
    EXPECT_FALSE(plain.nodes.at(1).lightRadiusMetres.has_value());
}

TEST(GltfNodes, ARadiusThatIsNoneIsAWarning) {
    for (const Json& radius : {Json(0), Json(-1), Json("wide"), Json(1e39)}) {
        const GltfBuilder builder = withLight({{"type", "point"}}, {{"radius", radius}});
        EXPECT_EQ(
            logOf([&] { EXPECT_TRUE(builder.load()); }),
            "warning: test.gltf: /nodes/1/extras/radius: is no length above 0 and is left out\n");
    }
}

TEST(GltfNodes, SpotsHaveTheirInnerConeInTheOuter) {
    const Json spot = {{"type", "spot"},
                       {"spot", {{"innerConeAngle", 0.9}, {"outerConeAngle", 0.5}}}};
    const assets::ModelLight light = withLight(spot, Json()).model().lights.at(0);
    EXPECT_EQ(light.type, assets::LightType::Spot);
    EXPECT_EQ(light.outerConeRadians, 0.5f);
    EXPECT_LT(light.innerConeRadians, 0.5f);
}

TEST(GltfNodes, MorphWeightsMustFitTheMesh) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    builder.json["nodes"][0]["weights"] = {0.5};
    EXPECT_EQ(builder.model().nodes.at(0).morphWeights, std::vector<float>{0.5f});
    builder.json["nodes"][0]["weights"] = {0.5, 0.5};
    assets::Model model;
    EXPECT_NE(
        logOf([&] { model = builder.model(); }).find("/nodes/0/weights: are 2 for a mesh of 1"),
        std::string::npos);
    EXPECT_TRUE(model.nodes.at(0).morphWeights.empty());
}

}  // namespace
}  // namespace lampyris::test
