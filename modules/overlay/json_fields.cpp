#include "overlay/json_fields.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace lampyris::overlay {
namespace {

using Json = nlohmann::json;

constexpr size_t kLongest = 64;  // [chosen] entries of a list that are shown

/// A hundredth of its size a pixel, and never nothing.
float dragSpeed(double value) {
    return std::max(0.005f, static_cast<float>(std::abs(value)) * 0.01f);
}

bool isVector(const Json& value) {
    return value.is_array() && value.size() >= 2 && value.size() <= 4 &&
           std::all_of(value.begin(), value.end(),
                       [](const Json& v) { return v.is_number_float(); });
}

bool editVector(const char* label, Json& value) {
    std::array<float, 4> numbers{};
    float largest = 0.0f;
    for (size_t i = 0; i < value.size(); ++i) {
        numbers[i] = value[i].get<float>();
        largest = std::max(largest, std::abs(numbers[i]));
    }
    const auto before = numbers;
    if (!ImGui::DragScalarN(label, ImGuiDataType_Float, numbers.data(),
                            static_cast<int>(value.size()), dragSpeed(largest), nullptr, nullptr,
                            "%.4g"))
        return false;
    for (size_t i = 0; i < value.size(); ++i) value[i] = static_cast<double>(numbers[i]);
    return numbers != before;
}

bool editNumber(const char* label, Json& value) {
    if (value.is_number_float()) {
        double number = value.get<double>();
        if (!ImGui::DragScalar(label, ImGuiDataType_Double, &number, dragSpeed(number), nullptr,
                               nullptr, "%.6g"))
            return false;
        value = number;
        return true;
    }
    int64_t number = value.get<int64_t>();
    if (!ImGui::InputScalar(label, ImGuiDataType_S64, &number)) return false;
    if (value.is_number_unsigned())
        value = static_cast<uint64_t>(std::max<int64_t>(number, 0));
    else
        value = number;
    return true;
}

/// A half-written name is no name: it counts once the field is left, by Enter or for another.
bool editText(const char* label, Json& value) {
    // ImGui forgets what was typed in the frame that leaves the field.
    static struct {
        ImGuiID field = 0;
        std::string words;
    } typed;
    const ImGuiID field = ImGui::GetID(label);
    const bool left = typed.field == field;
    std::string words = value.get<std::string>();
    const bool entered = ImGui::InputText(label, &words, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool dropped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    const bool done = entered || (left && ImGui::IsItemDeactivatedAfterEdit() && !dropped);
    const std::string result = entered ? words : typed.words;
    if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) typed = {field, words};
    if (!done) return false;
    value = result;
    return true;
}

bool editOne(const char* label, Json& value);

bool editList(const char* label, Json& value) {
    if (!ImGui::TreeNode(label, "%s: %zu", label, value.size())) return false;
    bool changed = false;
    for (size_t i = 0; i < std::min(value.size(), kLongest); ++i) {
        ImGui::PushID(static_cast<int>(i));
        changed |= editOne(std::to_string(i).c_str(), value[i]);
        ImGui::PopID();
    }
    if (value.size() > kLongest) ImGui::TextDisabled("and %zu more", value.size() - kLongest);
    ImGui::TreePop();
    return changed;
}

bool editOne(const char* label, Json& value) {
    if (isVector(value)) return editVector(label, value);
    if (value.is_array()) return editList(label, value);
    if (value.is_number()) return editNumber(label, value);
    if (value.is_boolean()) {
        bool on = value.get<bool>();
        if (!ImGui::Checkbox(label, &on)) return false;
        value = on;
        return true;
    }
    if (value.is_string()) {
        return editText(label, value);
    }
    if (value.is_object()) {
        if (!ImGui::TreeNodeEx(label, ImGuiTreeNodeFlags_DefaultOpen)) return false;
        const bool changed = editFields(value);
        ImGui::TreePop();
        return changed;
    }
    ImGui::TextDisabled("%s: none", label);
    return false;
}

}  // namespace

bool editFields(nlohmann::json& value) {
    if (!value.is_object()) return editOne("value", value);
    bool changed = false;
    for (const auto& [key, field] : value.items()) {
        ImGui::PushID(key.c_str());
        changed |= editOne(key.c_str(), field);
        ImGui::PopID();
    }
    return changed;
}

}  // namespace lampyris::overlay
