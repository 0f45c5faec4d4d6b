// The folder list is the architecture: every #include and every CMake link follows an arrow of the
// list.
#include <gtest/gtest.h>

#include <cctype>
#include <ostream>

#include "unit/house/house.h"
#include "unit/house/source_tree.h"

namespace lampyris::house {
namespace {

using Lines = std::vector<std::string>;

TEST(Includes, OfAllSourcesFollowTheArrows) {
    const Lines files = filesBelow(
        {"engine", "modules", "shaders/shared", "shaders/embed", "sandbox"}, {".h", ".cpp"});
    ASSERT_GT(files.size(), 30u);
    for (const std::string& file : files)
        for (const std::string& violation : cppViolations(file, textOf(file)))
            ADD_FAILURE() << violation;
}

TEST(Includes, OfAllShadersFollowTheArrows) {
    const Lines files = filesBelow({"shaders"}, {".comp", ".vert", ".frag", ".glsl"});
    ASSERT_GT(files.size(), 10u);
    for (const std::string& file : files)
        for (const std::string& violation : glslViolations(file, textOf(file)))
            ADD_FAILURE() << violation;
}

TEST(Links, OfEachFolderAreItsArrow) {
    size_t folders = 0;
    for (const std::string& file :
         filesBelow({"engine", "modules", "sandbox/courtyard"}, {"CMakeLists.txt"}))
        for (const auto& [name, linked] : linkedFolders(textOf(file))) {
            ++folders;
            std::set<std::string> expected = arrows().at(name);
            if (name == "overlay") expected = linked;  // "modules" is any of them
            EXPECT_EQ(linked, expected) << file;
        }
    EXPECT_GE(folders, 10u);
}

TEST(Includes, AreReadFromEveryKindOfLine) {
    const auto found = includesOf(
        "#include <a.h>\n  #  include \"b/c.h\" // why\n// #include \"no.h\"\nint x;\n#define X\n");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, "a.h");
    EXPECT_FALSE(found[0].quoted);
    EXPECT_EQ(found[1].name, "b/c.h");
    EXPECT_TRUE(found[1].quoted);
    EXPECT_EQ(found[1].line, 2);
}

TEST(Includes, KnowTheFolderOfAFile) {
    EXPECT_EQ(folderOf("engine/scene/systems/a.cpp"), "scene");
    EXPECT_EQ(folderOf("modules/accel/a.h"), "accel");
    EXPECT_EQ(folderOf("shaders/shared/a.h"), "shared");
    EXPECT_EQ(folderOf("sandbox/courtyard/a.h"), "courtyard");
    EXPECT_EQ(folderOf("sandbox/plot/a.h"), "sandbox");
    EXPECT_EQ(folderOf("engine/a.h"), "");
    EXPECT_EQ(folderOf("other/a.h"), "");
}

TEST(Includes, AnArrowOpensWhatItsTargetOpensSaveGpu) {
    EXPECT_EQ(opened("core"), (std::set<std::string>{"core", "shared"}));
    EXPECT_TRUE(opened("photon_gi").contains("scene"));
    EXPECT_TRUE(opened("photon_gi").contains("execute"));
    EXPECT_FALSE(opened("photon_gi").contains("gpu"));
    EXPECT_FALSE(opened("photons").contains("deferred"));
    EXPECT_FALSE(opened("accel").contains("gpu"));
    EXPECT_TRUE(opened("residency").contains("gpu"));
    EXPECT_FALSE(opened("evaluation").contains("math"));
    EXPECT_TRUE(opened("overlay").contains("photon_gi"));
    EXPECT_TRUE(opened("sandbox").contains("overlay"));
}

struct Planted {
    const char* path;
    const char* include;
    bool allowed;
};

// Becomes part of the test's name, so only what a name may hold.
void PrintTo(const Planted& planted, std::ostream* out) {
    for (const char c : std::string(planted.path) + " includes " + planted.include)
        *out << (std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_');
}

class PlantedIncludes : public testing::TestWithParam<Planted> {};

TEST_P(PlantedIncludes, AreJudged) {
    const Planted& planted = GetParam();
    const std::string path = planted.path;
    const std::string text = std::string("#include ") + planted.include + "\n";
    const bool glsl = path.ends_with(".comp") || path.ends_with(".glsl");
    const Lines found = glsl ? glslViolations(path, text) : cppViolations(path, text);
    EXPECT_EQ(found.empty(), planted.allowed) << (found.empty() ? "nothing found" : found[0]);
}

INSTANTIATE_TEST_SUITE_P(
    Forbidden, PlantedIncludes,
    testing::Values(Planted{"engine/graph/a.cpp", "\"gpu/device.h\"", false},
                    Planted{"engine/graph/a.cpp", "\"photons/photon_trace.h\"", false},
                    Planted{"engine/ecs/a.h", "\"math/glm.h\"", false},
                    Planted{"engine/ecs/a.h", "<glm/glm.hpp>", false},
                    Planted{"engine/scene/a.h", "\"graph/frame.h\"", false},
                    Planted{"engine/graph/a.h", "<vulkan/vulkan.h>", false},
                    Planted{"modules/photons/a.cpp", "\"gpu/buffer.h\"", false},
                    Planted{"modules/photons/a.cpp", "\"deferred/gbuffer.h\"", false},
                    Planted{"modules/photons/a.cpp", "<embree3/rtcore.h>", false},
                    Planted{"modules/reference/a.cpp", "\"accel/bvh.h\"", false},
                    Planted{"modules/evaluation/a.cpp", "\"scene/snapshot.h\"", false},
                    Planted{"modules/photon_gi/a.cpp", "<imgui.h>", false},
                    Planted{"engine/scene/a.cpp", "<tiny_gltf.h>", false},
                    Planted{"engine/gpu/a.cpp", "<GLFW/glfw3.h>", false},
                    Planted{"engine/gpu/a.cpp", "<spirv_cross/spirv_cross_c.h>", false},
                    Planted{"engine/execute/a.cpp", "<glslang/Public/ShaderLang.h>", false},
                    Planted{"modules/photon_gi/a.cpp", "\"shader_reload/compile_shader.h\"", false},
                    Planted{"engine/core/a.cpp", "<boost/any.hpp>", false},
                    Planted{"engine/core/a.cpp", "<volk.h>", false},
                    Planted{"engine/core/a.cpp", "\"utils/helpers.h\"", false},
                    Planted{"engine/core/a.cpp", "\"../gpu/device.h\"", false},
                    Planted{"engine/misc/a.cpp", "<vector>", false},
                    Planted{"shaders/shared/a.h", "\"scene/components.h\"", false},
                    Planted{"shaders/lib/a.glsl", "\"photons/a.glsl\"", false},
                    Planted{"shaders/photons/a.comp", "\"deferred/a.glsl\"", false}));

INSTANTIATE_TEST_SUITE_P(
    Allowed, PlantedIncludes,
    testing::Values(Planted{"engine/scene/systems/a.cpp", "\"core/result.h\"", true},
                    Planted{"engine/scene/a.h", "<glm/glm.hpp>", true},
                    Planted{"engine/execute/a.cpp", "<vulkan/vulkan.h>", true},
                    Planted{"engine/core/a.cpp", "<unistd.h>", true},
                    Planted{"engine/core/a.cpp", "<string_view>", true},
                    Planted{"modules/accel/a.cpp", "<embree3/rtcore.h>", true},
                    Planted{"modules/photon_gi/a.cpp", "\"accel/bvh.h\"", true},
                    Planted{"modules/photons/a.cpp", "\"shared/photon.h\"", true},
                    Planted{"sandbox/a.cpp", "\"courtyard/player.h\"", true},
                    Planted{"sandbox/courtyard/a.cpp", "\"courtyard/player.h\"", true},
                    Planted{"sandbox/courtyard/a.cpp", "\"scene/builtin/shapes.h\"", true},
                    Planted{"sandbox/a.cpp", "\"options.h\"", true},
                    Planted{"shaders/photon_gi/a.comp", "\"photons/a.glsl\"", true},
                    Planted{"shaders/photon_gi/a.comp", "\"lib/rng.glsl\"", true},
                    Planted{"shaders/lib/a.glsl", "\"shared/bvh.h\"", true}));

TEST(Links, AreReadFromCMake) {
    const auto found = linkedFolders(
        "lampyris_folder(a ROOM engine\n SOURCES a.cpp\n FOLDERS core math LIBRARIES x)\n"
        "lampyris_folder(b ROOM engine)");
    EXPECT_EQ(found.at("a"), (std::set<std::string>{"core", "math"}));
    EXPECT_TRUE(found.at("b").empty());
}

}  // namespace
}  // namespace lampyris::house
