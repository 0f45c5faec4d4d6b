// A struct of shaders/shared/ must lie in memory as SPIR-V says: the C++ table and the shader are
// both made from the headers, so a new struct is tested as soon as it is there.
#include "unit/shaders/shared_layout.h"

#include <gtest/gtest.h>
#include <spirv_cross/spirv_cross_c.h>

#include <map>

#include "shared_layout/shaders.h"

namespace lampyris {
namespace {

class SharedLayout : public ::testing::Test {
 protected:
    void SetUp() override {
        const auto words = shared_layout::shaders::sharedLayout.words;
        spvc_parsed_ir ir = nullptr;
        spvc_resources resources = nullptr;
        ASSERT_EQ(spvc_context_create(&context_), SPVC_SUCCESS);
        ASSERT_EQ(spvc_context_parse_spirv(context_, words.data(), words.size(), &ir),
                  SPVC_SUCCESS);
        ASSERT_EQ(spvc_context_create_compiler(context_, SPVC_BACKEND_NONE, ir,
                                               SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_),
                  SPVC_SUCCESS);
        ASSERT_EQ(spvc_compiler_create_shader_resources(compiler_, &resources), SPVC_SUCCESS);
        for (const auto type :
             {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER}) {
            const spvc_reflected_resource* first = nullptr;
            size_t count = 0;
            ASSERT_EQ(spvc_resources_get_resource_list_for_type(resources, type, &first, &count),
                      SPVC_SUCCESS);
            for (size_t i = 0; i < count; ++i) blocks_[first[i].name] = first[i].base_type_id;
        }
    }
    void TearDown() override { spvc_context_destroy(context_); }

    spvc_type typeOf(spvc_type_id id) { return spvc_compiler_get_type_handle(compiler_, id); }

    /// The struct inside the block "Storage…" or "Uniform…".
    spvc_type_id structIn(const std::string& block) {
        EXPECT_TRUE(blocks_.contains(block)) << block;
        return spvc_type_get_base_type_id(
            typeOf(spvc_type_get_member_type(typeOf(blocks_[block]), 0)));
    }
    std::map<std::string, size_t> offsetsOf(spvc_type_id id) {
        std::map<std::string, size_t> offsets;
        const spvc_type type = typeOf(id);
        for (unsigned i = 0; i < spvc_type_get_num_member_types(type); ++i) {
            unsigned offset = 0;
            EXPECT_EQ(spvc_compiler_type_struct_member_offset(compiler_, type, i, &offset),
                      SPVC_SUCCESS);
            offsets[spvc_compiler_get_member_name(compiler_, id, i)] = offset;
        }
        return offsets;
    }
    static std::map<std::string, size_t> offsetsOf(const test::SharedStruct& one) {
        std::map<std::string, size_t> offsets;
        for (const test::SharedMember& member : one.members) offsets[member.name] = member.offset;
        return offsets;
    }

    spvc_context context_ = nullptr;
    spvc_compiler compiler_ = nullptr;
    std::map<std::string, spvc_type_id> blocks_;
};

TEST_F(SharedLayout, FindsTheStructs) {
    EXPECT_GE(test::sharedStructs().size(), 10u);
    for (const test::SharedStruct& one : test::sharedStructs())
        EXPECT_FALSE(one.members.empty()) << one.name;
}

TEST_F(SharedLayout, OffsetsInStorageBuffersAreThoseOfCpp) {
    for (const test::SharedStruct& one : test::sharedStructs())
        EXPECT_EQ(offsetsOf(structIn("Storage" + one.name)), offsetsOf(one)) << one.name;
}

TEST_F(SharedLayout, OffsetsInUniformBuffersAreThoseOfCpp) {
    for (const test::SharedStruct& one : test::sharedStructs())
        EXPECT_EQ(offsetsOf(structIn("Uniform" + one.name)), offsetsOf(one)) << one.name;
}

TEST_F(SharedLayout, ArraysHaveTheStrideOfCpp) {
    for (const test::SharedStruct& one : test::sharedStructs()) {
        unsigned stride = 0;
        ASSERT_EQ(spvc_compiler_type_struct_member_array_stride(
                      compiler_, typeOf(blocks_["Storage" + one.name]), 0, &stride),
                  SPVC_SUCCESS);
        EXPECT_EQ(stride, one.bytes) << one.name;
    }
}

}  // namespace
}  // namespace lampyris
