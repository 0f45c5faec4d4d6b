#include "thesis/row_store.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "unit/core/scratch_folder.h"

namespace lampyris::sandbox::thesis {
namespace {

using core::ScratchFolder;
using Json = nlohmann::json;

const Json kSettings{{"paths", 1000}, {"radius", 0.25}, {"device", "llvmpipe"}};
const Row kRow{{"thesis", {{"frame_ms", {11.3, 0.1}}, {"MSE", {167.09, 2.5}}}},
               {"full", {{"frame_ms", {1.0 / 3.0, 0.0}}}}};

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

void expectSame(const Row* row, const Row& expected) {
    ASSERT_NE(row, nullptr);
    ASSERT_EQ(row->size(), expected.size());
    for (const auto& [contestant, figures] : expected)
        for (const auto& [name, spread] : figures) {
            EXPECT_EQ(row->at(contestant).at(name).mean, spread.mean) << name;
            EXPECT_EQ(row->at(contestant).at(name).stddev, spread.stddev) << name;
        }
}

Json other(int number) {
    Json settings = kSettings;
    settings["paths"] = number;
    return settings;
}

TEST(RowStore, GivesBackWhatAFormerRunKept) {
    const ScratchFolder folder;
    const auto file = folder / "rows.jsonl";
    {
        auto store = RowStore::open(file).value();
        EXPECT_EQ(store.find(kSettings), nullptr);
        ASSERT_TRUE(store.keep(kSettings, kRow).ok());
        expectSame(store.find(kSettings), kRow);
    }
    const auto store = RowStore::open(file).value();
    EXPECT_EQ(store.rows(), 1u);
    expectSame(store.find(kSettings), kRow);
}

TEST(RowStore, NeverGivesRowsOfOtherSettings) {
    const ScratchFolder folder;
    auto store = RowStore::open(folder / "rows.jsonl").value();
    ASSERT_TRUE(store.keep(kSettings, kRow).ok());
    for (const char* changed :
         {R"({"paths":1000,"radius":0.25,"device":"other"})",
          R"({"paths":1000,"radius":0.26,"device":"llvmpipe"})",
          R"({"paths":1001,"radius":0.25,"device":"llvmpipe"})", R"({"paths":1000,"radius":0.25})",
          R"({"paths":1000,"radius":0.25,"device":"llvmpipe","seed":1})"})
        EXPECT_EQ(store.find(Json::parse(changed)), nullptr) << changed;
    EXPECT_NE(store.find(Json::parse(R"({"device":"llvmpipe","radius":0.25,"paths":1000})")),
              nullptr)
        << "order is nothing";
}

// A run may be ended at any byte of a line.
TEST(RowStore, ACutLineIsMeasuredAgain) {
    const ScratchFolder folder;
    const auto file = folder / "rows.jsonl";
    {
        auto store = RowStore::open(file).value();
        ASSERT_TRUE(store.keep(other(1), kRow).ok());
        ASSERT_TRUE(store.keep(other(2), kRow).ok());
    }
    const std::string whole = textOf(file);
    const size_t second = whole.find('\n') + 1;
    for (size_t length = second; length < whole.size(); length += 7) {
        write(file, whole.substr(0, length));
        auto store = RowStore::open(file).value();
        expectSame(store.find(other(1)), kRow);
        EXPECT_EQ(store.find(other(2)), nullptr) << length;
        ASSERT_TRUE(store.keep(other(3), kRow).ok());
        const auto again = RowStore::open(file).value();
        expectSame(again.find(other(1)), kRow);
        expectSame(again.find(other(3)), kRow);
    }
}

TEST(RowStore, DamagedLinesAreAsIfTheyWereNotThere) {
    const ScratchFolder folder;
    const auto file = folder / "rows.jsonl";
    const std::string good = R"({"row":{"full":{"MSE":[1.0,0.5]}},"settings":{"paths":1}})";
    for (const char* bad :
         {"", "null", "[]", "3", "{}", "\xff\xfe", R"({"settings":{"paths":1}})",
          R"({"row":{},"settings":{"paths":1}})", R"({"row":[1],"settings":{"paths":1}})",
          R"({"row":{"full":3},"settings":{"paths":1}})",
          R"({"row":{"full":{"MSE":1.0}},"settings":{"paths":1}})",
          R"({"row":{"full":{"MSE":[1.0]}},"settings":{"paths":1}})",
          R"({"row":{"full":{"MSE":[1.0,null]}},"settings":{"paths":1}})"}) {
        write(file, std::string(bad) + "\n");
        EXPECT_EQ(RowStore::open(file).value().rows(), 0u) << bad;
        write(file, std::string(bad) + "\n" + good + "\n");
        EXPECT_EQ(RowStore::open(file).value().rows(), 1u) << bad;
    }
}

TEST(RowStore, TheLaterOfTwoRowsCounts) {
    const ScratchFolder folder;
    const auto file = folder / "rows.jsonl";
    const Row later{{"full", {{"MSE", {5.0, 0.0}}}}};
    {
        auto store = RowStore::open(file).value();
        ASSERT_TRUE(store.keep(kSettings, kRow).ok());
        ASSERT_TRUE(store.keep(kSettings, later).ok());
    }
    expectSame(RowStore::open(file).value().find(kSettings), later);
}

TEST(RowStore, AFileThatCannotBeWrittenIsAnError) {
    const ScratchFolder folder;
    EXPECT_FALSE(RowStore::open(folder / "nowhere" / "rows.jsonl").ok());
    std::filesystem::create_directory(folder / "taken");
    const auto taken = RowStore::open(folder / "taken");
    ASSERT_FALSE(taken.ok());
    EXPECT_NE(taken.error().message.find("taken: cannot write"), std::string::npos);

    std::filesystem::create_directory(folder / "goes");
    auto store = RowStore::open(folder / "goes" / "rows.jsonl").value();
    std::filesystem::remove_all(folder / "goes");
    EXPECT_FALSE(store.keep(kSettings, kRow).ok());
}

TEST(RowStore, WithoutAFileKeepsInMemory) {
    RowStore store;
    ASSERT_TRUE(store.keep(kSettings, kRow).ok());
    expectSame(store.find(kSettings), kRow);
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
