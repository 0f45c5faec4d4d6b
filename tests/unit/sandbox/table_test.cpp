#include "table.h"

#include <gtest/gtest.h>

namespace lampyris::sandbox {
namespace {

const Table kTable{
    "t", "A title", {"node", "ms"}, {{"gbuffer", "1.5"}, {"a, \"b\"", ""}, {"–", "100"}}};

TEST(Table, AlignsColumnsByCharacters) {
    EXPECT_EQ(toText(kTable),
              "A title\nnode      ms\ngbuffer  1.5\na, \"b\"      \n–        100\n");
}

TEST(Table, AsMarkdown) {
    EXPECT_EQ(
        toMarkdown(kTable),
        "A title\n\n| node    |  ms |\n| ------- | --: |\n| gbuffer | 1.5 |\n| a, \"b\"  |     |\n"
        "| –       | 100 |\n");
}

TEST(Table, QuotesWhatCsvWouldMisread) {
    EXPECT_EQ(toCsv(kTable), "node,ms\ngbuffer,1.5\n\"a, \"\"b\"\"\",\n–,100\n");
}

}  // namespace
}  // namespace lampyris::sandbox
