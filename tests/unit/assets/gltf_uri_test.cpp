#include "assets/gltf_uri.h"

#include <gtest/gtest.h>

#include "assets/gltf.h"

namespace lampyris::assets {
namespace {

TEST(GltfUri, NamesInTheFolderAndBelowAreRead) {
    EXPECT_EQ(parseUri("a.bin")->path, "a.bin");
    EXPECT_EQ(parseUri("sub/a%20b.bin")->path, "sub/a b.bin");
    EXPECT_EQ(parseUri("..a/b..c")->path, "..a/b..c");
    EXPECT_TRUE(parseUri("data:application/octet-stream;base64,AAAA")->isData);
}

TEST(GltfUri, WhatLeavesTheFolderIsRefused) {
    for (const char* uri : {"/etc/passwd", "../a.bin", "a/../../b", "%2e%2e/a.bin", "%2Fetc/passwd",
                            "http://host/a.bin", "file:///etc/passwd", "C:/a.bin", "..\\a.bin", "",
                            "a%00b", "a%2", "a%zz"})
        EXPECT_FALSE(parseUri(uri)) << uri;
}

TEST(GltfUri, Base64OfAnyLengthAndKind) {
    const std::vector<uint8_t> bytes = {0, 255, 16, 32};
    for (size_t length = 0; length <= 4; ++length) {
        const char* texts[] = {"", "AA==", "AP8=", "AP8Q", "AP8QIA=="};
        const auto read = readUri(std::string("data:any/kind;base64,") + texts[length], {});
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(*read,
                  std::vector<uint8_t>(bytes.begin(), bytes.begin() + static_cast<long>(length)));
    }
    EXPECT_FALSE(readUri("data:text/plain,hello", {}));
    EXPECT_FALSE(readUri("data:;base64,A*==", {}));
}

TEST(GltfUri, OnlyPlainFilesAreRead) {
    EXPECT_EQ(readUri("a.bin", {}).error().message, "a.bin lies beside a file that has no folder");
    EXPECT_NE(readUri("tests", std::filesystem::path(LAMPYRIS_SOURCE_DIR))
                  .error()
                  .message.find("is no plain file"),
              std::string::npos);
}

TEST(GltfUri, AMissingGltfIsAnErrorThatNamesIt) {
    const auto result = loadGltf("/nowhere/scene.gltf");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("/nowhere/scene.gltf"), std::string::npos);
}

}  // namespace
}  // namespace lampyris::assets
