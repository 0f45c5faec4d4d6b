#include "table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "core/check.h"
#include "core/file.h"

namespace lampyris::sandbox {
namespace {

using Row = std::vector<std::string>;

/// Characters, not bytes, of UTF-8 text.
size_t lengthOf(const std::string& text) {
    return static_cast<size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<size_t> widthsOf(const Table& table) {
    std::vector<size_t> widths;
    for (const std::string& cell : table.header) widths.push_back(lengthOf(cell));
    for (const Row& row : table.rows) {
        CHECK(row.size() == widths.size());
        for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], lengthOf(row[i]));
    }
    return widths;
}

std::string aligned(const Row& row, const std::vector<size_t>& widths, const char* gap) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
        const std::string fill(widths[i] - lengthOf(row[i]), ' ');
        if (i > 0) line.append(gap).append(fill);
        line.append(row[i]);
        if (i == 0) line.append(fill);
    }
    return line;
}

std::string csvCell(const std::string& cell) {
    if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
    std::string quoted{'"'};
    for (const char c : cell) {
        if (c == '"') quoted.push_back('"');
        quoted.push_back(c);
    }
    quoted.push_back('"');
    return quoted;
}

std::string csvLine(const Row& row) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
        if (i > 0) line.push_back(',');
        line.append(csvCell(row[i]));
    }
    line.push_back('\n');
    return line;
}

}  // namespace

std::string toText(const Table& table) {
    const auto widths = widthsOf(table);
    std::string text = table.title + "\n" + aligned(table.header, widths, "  ") + "\n";
    for (const Row& row : table.rows) text += aligned(row, widths, "  ") + "\n";
    return text;
}

std::string toMarkdown(const Table& table) {
    const auto widths = widthsOf(table);
    Row rule;
    for (size_t i = 0; i < widths.size(); ++i)
        rule.push_back(i == 0 ? std::string(widths[i], '-')
                              : std::string(widths[i] - 1, '-') + ":");
    std::string text = table.title + "\n\n";
    text += "| " + aligned(table.header, widths, " | ") + " |\n";
    text += fmt::format("| {} |\n", aligned(rule, widths, " | "));
    for (const Row& row : table.rows) text += fmt::format("| {} |\n", aligned(row, widths, " | "));
    return text;
}

std::string toCsv(const Table& table) {
    std::string text = csvLine(table.header);
    for (const Row& row : table.rows) text += csvLine(row);
    return text;
}

core::Result<void> publish(const Table& table, const std::filesystem::path& folder) {
    fmt::print("{}\n", toText(table));
    std::fflush(stdout);
    if (folder.empty()) return {};
    TRY_VOID(core::writeFile(folder / (table.name + ".csv"), toCsv(table)));
    return core::writeFile(folder / (table.name + ".md"), toMarkdown(table));
}

}  // namespace lampyris::sandbox
