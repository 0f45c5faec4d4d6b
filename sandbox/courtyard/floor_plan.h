/// \file Where the rooms of the courtyard are: metres, x to the east, z to the south.
#pragma once

#include <vector>

#include "math/bounds.h"
#include "math/glm.h"

namespace lampyris::courtyard {

constexpr float kRoofY = 6.4f;     ///< top of the walls around the square and the street
constexpr float kCeilingY = 3.4f;  ///< of every roofed room
constexpr float kArchTopY = 2.9f;  ///< of the arcade's openings
constexpr int kArches = 5;         ///< between the square and the arcade
constexpr float kArchWidth = 2.0f;

/// The west edge of an opening of the arcade.
constexpr float archWest(int arch) {
    return -6.6f + 2.8f * static_cast<float>(arch);
}

struct Room {
    glm::vec3 lower;
    glm::vec3 upper;
};

inline constexpr Room kSquare{{-7.0f, 0.0f, -6.0f}, {7.0f, kRoofY, 6.0f}};
inline constexpr Room kArcade{{-7.0f, 0.0f, -9.0f}, {7.0f, kCeilingY, -6.4f}};
inline constexpr Room kWorkshop{{-12.4f, 0.0f, -3.0f}, {-7.4f, kCeilingY, 4.0f}};
inline constexpr Room kStudy{{-12.4f, 0.0f, -9.0f}, {-7.4f, kCeilingY, -3.4f}};
inline constexpr Room kStreet{{7.4f, 0.0f, -9.0f}, {10.4f, kRoofY, 6.0f}};
inline constexpr Room kDoorway{{-7.4f, 0.0f, -0.8f}, {-7.0f, 2.3f, 0.8f}};     ///< has the door
inline constexpr Room kWindow{{-7.4f, 1.2f, 2.0f}, {-7.0f, 2.2f, 3.2f}};       ///< barred
inline constexpr Room kStudyDoor{{-7.4f, 0.0f, -8.4f}, {-7.0f, 2.4f, -7.2f}};  ///< to the arcade
inline constexpr Room kPassage{{-10.4f, 0.0f, -3.4f}, {-9.2f, 2.4f, -3.0f}};   ///< study, workshop
inline constexpr Room kGate{{7.0f, 0.0f, -1.6f}, {7.4f, kArchTopY, 0.8f}};     ///< to the street
inline constexpr Room kStreetDoor{{7.0f, 0.0f, -8.4f}, {7.4f, 2.4f, -7.2f}};   ///< arcade, street

/// All of the above, and the arcade's openings.
[[nodiscard]] std::vector<Room> rooms();

constexpr float kSlabTopY = 0.035f;  ///< of the paving; all other floors are at 0
/// What one stands on there.
[[nodiscard]] float floorAt(const glm::vec3& position);

/// Where the fountain stands, and how far its rim reaches.
inline constexpr glm::vec3 kFountain{-1.4f, 0.0f, -0.6f};
constexpr float kFountainRadiusMetres = 1.5f;

/// Where the hearth of the workshop is.
inline constexpr glm::vec3 kHearth{-11.7f, 0.0f, 0.6f};

}  // namespace lampyris::courtyard
