#include "embed/reflection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reflected/shaders.h"

namespace lampyris {
namespace {

using graph::SlotKind;
namespace shaders = reflected::shaders;

const graph::ShaderSlot& slot(const graph::Shader& shader, uint32_t number) {
    const auto found = std::find_if(shader.slots.begin(), shader.slots.end(),
                                    [&](const graph::ShaderSlot& s) { return s.slot == number; });
    EXPECT_NE(found, shader.slots.end()) << "slot " << number;
    return *found;
}

void expectSlot(uint32_t number, std::string_view name, SlotKind kind, bool reads, bool writes) {
    const graph::ShaderSlot& found = slot(shaders::everySlot, number);
    EXPECT_EQ(found.name, name);
    EXPECT_EQ(found.kind, kind) << name;
    EXPECT_EQ(found.reads, reads) << name;
    EXPECT_EQ(found.writes, writes) << name;
}

TEST(Reflection, FindsEverySlotWithWhatItDoes) {
    ASSERT_EQ(shaders::everySlot.slots.size(), 10u);
    expectSlot(0, "inputs", SlotKind::StorageBuffer, true, false);
    expectSlot(1, "Plain", SlotKind::StorageBuffer, true, true);
    expectSlot(2, "outputs", SlotKind::StorageBuffer, false, true);
    expectSlot(3, "mixed", SlotKind::StorageBuffer, true, true);
    expectSlot(4, "texels", SlotKind::UniformTexelBuffer, true, false);
    expectSlot(5, "storedTexels", SlotKind::StorageTexelBuffer, false, true);
    expectSlot(6, "layers", SlotKind::SampledImage, true, false);
    expectSlot(7, "readImage", SlotKind::StorageImage, true, false);
    expectSlot(8, "updatedImage", SlotKind::StorageImage, true, true);
    expectSlot(9, "params", SlotKind::UniformBuffer, true, false);
}

TEST(Reflection, FindsSizes) {
    EXPECT_EQ(shaders::everySlot.name, "reflected/every_slot.comp");
    EXPECT_EQ(shaders::everySlot.workgroupSize, (std::array<uint32_t, 3>{16, 4, 1}));
    EXPECT_EQ(shaders::everySlot.pushConstantBytes, 20u);
}

TEST(Reflection, VariantsAreCompiledWithTheirDefinitions) {
    EXPECT_EQ(shaders::variant.slots.size(), 9u);
    EXPECT_EQ(shaders::variant.slots.front().slot, 1u);
}

/// The shader's words with every decoration of one kind given another value.
std::vector<uint32_t> redecorated(uint32_t decoration, uint32_t value) {
    constexpr uint32_t kOpDecorate = 71;
    std::vector<uint32_t> words(shaders::everySlot.words.begin(), shaders::everySlot.words.end());
    for (size_t i = 5; i < words.size(); i += words[i] >> 16)
        if ((words[i] & 0xffffu) == kOpDecorate && words[i + 2] == decoration) words[i + 3] = value;
    return words;
}

TEST(Reflection, RefusesOtherSets) {
    constexpr uint32_t kDescriptorSet = 34;
    const auto refused = embed::reflect(redecorated(kDescriptorSet, 1));
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("set 0"), std::string::npos);
}

TEST(Reflection, RefusesTwoResourcesInOneSlot) {
    constexpr uint32_t kBinding = 33;
    const auto refused = embed::reflect(redecorated(kBinding, 5));
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("slot 5"), std::string::npos);
}

TEST(Reflection, RefusesWhatIsNoShader) {
    const std::vector<uint32_t> nonsense(64, 7);
    EXPECT_FALSE(embed::reflect(nonsense).ok());
    EXPECT_FALSE(embed::reflect({}).ok());
}

}  // namespace
}  // namespace lampyris
