/// \file What stands in an SVG file, for tests of those who write one.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace lampyris::sandbox::plot {

struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;

    [[nodiscard]] double number(const std::string& attribute) const {
        return std::stod(attributes.at(attribute));
    }
};

/// All elements in their order. A failure of the test where the text is no well-formed XML of
/// elements, attributes in double quotes, and text.
inline std::vector<Element> readSvg(const std::string& svg) {
    std::vector<Element> elements;
    std::vector<size_t> open;
    const auto checkText = [](const std::string& text) {
        EXPECT_EQ(text.find_first_of("<>"), std::string::npos) << text;
        for (size_t i = text.find('&'); i != std::string::npos; i = text.find('&', i + 1))
            EXPECT_TRUE(text.compare(i, 5, "&amp;") == 0 || text.compare(i, 4, "&lt;") == 0 ||
                        text.compare(i, 4, "&gt;") == 0 || text.compare(i, 6, "&quot;") == 0)
                << text;
    };
    for (size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
        const size_t end = svg.find('>', at);
        if (end == std::string::npos) {
            ADD_FAILURE() << "a tag has no end";
            return elements;
        }
        std::string tag = svg.substr(at + 1, end - at - 1);
        if (tag[0] == '/') {
            const bool matches = !open.empty() && elements[open.back()].name == tag.substr(1);
            EXPECT_TRUE(matches) << "</" << tag.substr(1) << "> closes nothing";
            if (!open.empty()) open.pop_back();
            continue;
        }
        const bool empty = tag.back() == '/';
        if (empty) tag.pop_back();
        Element element;
        size_t next = tag.find(' ');
        element.name = tag.substr(0, next);
        while (next != std::string::npos && tag.find('=', next) != std::string::npos) {
            const size_t equals = tag.find("=\"", next);
            const size_t close = tag.find('"', equals + 2);
            const std::string value = tag.substr(equals + 2, close - equals - 2);
            checkText(value);
            EXPECT_TRUE(
                element.attributes.emplace(tag.substr(next + 1, equals - next - 1), value).second);
            next = tag.find(' ', close);
        }
        if (!empty) {
            element.text = svg.substr(end + 1, svg.find('<', end) - end - 1);
            checkText(element.text);
            open.push_back(elements.size());
        }
        elements.push_back(element);
    }
    EXPECT_TRUE(open.empty()) << "an element is not closed";
    return elements;
}

inline std::vector<Element> elementsNamed(const std::string& svg, const std::string& name) {
    std::vector<Element> found;
    for (const Element& element : readSvg(svg))
        if (element.name == name) found.push_back(element);
    return found;
}

/// The first of that text, or an empty one and a failure of the test.
inline Element labelled(const std::string& svg, const std::string& text) {
    for (const Element& element : elementsNamed(svg, "text"))
        if (element.text == text) return element;
    ADD_FAILURE() << "no label " << text;
    return {};
}

}  // namespace lampyris::sandbox::plot
