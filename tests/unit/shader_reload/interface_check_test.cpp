// New words must fit where the old ones stand: between the stages, and on the device.
#include "shader_reload/interface_check.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "shader_reload/compile_shader.h"
#include "unit/core/scratch_folder.h"

namespace lampyris::shader_reload {
namespace {

const std::string kVertex =
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 0) out vec4 colour;\n"
    "layout(location = 1) out vec2 uv;\n"
    "void main() { colour = vec4(1.0); uv = position.xy; gl_Position = vec4(position, 1.0); }\n";
const std::string kFragment =
    "layout(location = 0) in vec4 colour;\n"
    "layout(location = 1) in vec2 uv;\n"
    "layout(location = 0) out vec4 shown;\n"
    "void main() { shown = colour * uv.x; }\n";
const std::string kCompute =
    "layout(local_size_x = 1) in;\n"
    "layout(set = 0, binding = 0) buffer Out { uint value; } target;\n"
    "shared uint values[4];\n"
    "void main() { values[0] = 1u; target.value = values[0]; }\n";

class InterfaceCheck : public testing::Test {
 protected:
    std::vector<uint32_t> compile(const std::string& file, const std::string& text) {
        EXPECT_TRUE(core::writeFile(folder_ / file, "#version 460\n" + text).ok());
        auto words = compileShader({folder_ / "", file});
        EXPECT_TRUE(words.ok()) << (words.ok() ? "" : words.error().message);
        return words.ok() ? std::move(words).value() : std::vector<uint32_t>{};
    }
    /// What is said of `text` with each of `from` as `to`, in the place of `text`.
    std::string said(const std::string& file, const std::string& text, const std::string& from,
                     const std::string& to) {
        const auto words = compile(file, text);
        graph::Shader built;
        built.words = words;
        built.source = file;
        const graph::ShaderSlot slot{"target", 0, graph::SlotKind::StorageBuffer, true, true};
        if (file.ends_with(".comp")) built.slots = {&slot, 1};
        std::string edited = text;
        for (size_t i = edited.find(from); i != std::string::npos;
             i = edited.find(from, i + to.size()))
            edited.replace(i, from.size(), to);
        EXPECT_NE(edited, text);
        const auto result = checkInterface(built, compile(file, edited));
        return result.ok() ? "" : result.error().message;
    }

    core::ScratchFolder folder_;
};

TEST_F(InterfaceCheck, AnotherBodyGoesIn) {
    EXPECT_EQ(said("a.vert", kVertex, "vec4(1.0)", "vec4(0.5)"), "");
    EXPECT_EQ(said("a.frag", kFragment, "* uv.x", "+ uv.x"), "");
    EXPECT_EQ(said("a.frag", kFragment, "colour", "tint"), "") << "under another name";
    EXPECT_EQ(said("a.comp", kCompute, "1u", "2u"), "");
}

TEST_F(InterfaceCheck, AnInputMayGo) {
    EXPECT_EQ(said("a.frag", kFragment, "* uv.x", "* 2.0"), "");
    EXPECT_EQ(said("a.frag",
                   "layout(location = 1) in vec2 uv;\n"
                   "layout(location = 0) out vec4 shown;\n"
                   "void main() { shown = vec4(uv, 0, 1); }\n",
                   "layout(location = 1) in vec2 uv;", "const vec2 uv = vec2(0.5);"),
              "");
}

TEST_F(InterfaceCheck, WhatNothingGivesIsRefused) {
    EXPECT_EQ(said("a.vert", kVertex, "layout(location = 0) in", "layout(location = 3) in"),
              "a.vert: input 3 (position) is new; nothing gives it");
    EXPECT_EQ(said("a.frag", kFragment, "layout(location = 1) in", "layout(location = 2) in"),
              "a.frag: input 2 (uv) is new; nothing gives it");
    EXPECT_EQ(said("a.frag", kFragment, "vec2 uv", "vec3 uv"),
              "a.frag: input 1 (uv): vec3 and vec2 differ");
}

TEST_F(InterfaceCheck, WhatIsTakenMustBeHandedOnAsItWas) {
    EXPECT_EQ(said("a.vert", kVertex, "layout(location = 1) out", "layout(location = 2) out"),
              "a.vert: output 2 (uv) is new; nothing takes it");
    EXPECT_EQ(said("a.vert", kVertex, "layout(location = 1) out vec2 uv;", "vec2 uv;"),
              "a.vert: output 1 (uv) is gone; the program takes it");
    EXPECT_EQ(said("a.frag", kFragment, "out vec4 shown;\nvoid main() { shown = colour * uv.x; }",
                   "out uvec4 shown;\nvoid main() { shown = uvec4(colour * uv.x); }"),
              "a.frag: output 0 (shown): uvec4 and vec4 differ");
}

TEST_F(InterfaceCheck, WhatNotEveryDeviceHasIsRefused) {
    EXPECT_EQ(said("a.comp", kCompute, "values[4]", "values[4096]"), "");
    EXPECT_EQ(said("a.comp", kCompute, "values[4]", "values[4097]"),
              "a.comp: its workgroup shares 16388 bytes; 16384 are sure to be there");
    const std::string pairs =
        "struct Pair { vec3 a; uint b; };\nshared Pair pairs[PAIRS];\n"
        "void main() { pairs[0] = Pair(vec3(1.0), 1u); ";
    EXPECT_EQ(said("a.comp", kCompute, "void main() {", "const uint PAIRS = 1000u;\n" + pairs), "");
    EXPECT_EQ(said("a.comp", kCompute, "void main() {", "const uint PAIRS = 1100u;\n" + pairs),
              "a.comp: its workgroup shares 17616 bytes; 16384 are sure to be there");
    EXPECT_EQ(said("a.comp", kCompute, "values[0];", "uint(double(values[0]));"),
              "a.comp: it needs SPIR-V's capability 10; the program did not ask for it");
}

TEST_F(InterfaceCheck, WhatSharedMoreMayGoOnToDoSo) {
    EXPECT_EQ(said("a.comp",
                   "layout(local_size_x = 1) in;\n"
                   "layout(set = 0, binding = 0) buffer Out { uint value; } target;\n"
                   "shared uint values[8192];\n"
                   "void main() { values[0] = 1u; target.value = values[0]; }\n",
                   "1u", "2u"),
              "");
}

}  // namespace
}  // namespace lampyris::shader_reload
