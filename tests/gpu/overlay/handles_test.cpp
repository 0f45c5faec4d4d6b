// Handles follow the mouse: along an axis that is seen end-on nothing can be measured, and under a
// mirrored parent an entity turns as the mouse does.
#include "overlay/handles.h"

#include <cmath>

#include "ecs/hierarchy.h"
#include "scene/components.h"
#include "scene/systems/world_transforms.h"
#include "support/overlay_test.h"
#include "support/small_scenes.h"

namespace lampyris::overlay {
namespace {

constexpr graph::Extent kSize{640, 360};

class HandlesTest : public test::OverlayTest {
 protected:
    ecs::Entity place(const scene::Transform& transform, ecs::Entity parent = {}) {
        const ecs::Entity entity = world_.create();
        world_.add(entity, transform);
        if (parent.valid()) test::need(ecs::setParent(world_, entity, parent));
        return entity;
    }
    /// A frame with the mouse there. \return whether the mouse is the handles'
    bool point(ecs::Entity entity, double x, double y, bool down) {
        window::Input input;
        input.cursorX = x;
        input.cursorY = y;
        input.buttons[0] = down;
        scene::updateWorldTransforms(world_);
        overlay_->begin(input, kSize, kSize, 0.1);
        const bool theirs = handles_.draw(world_, entity, camera_, kSize);
        overlay_->end();
        scene::updateWorldTransforms(world_);
        return theirs;
    }

    ecs::World world_;
    Handles handles_;
    scene::SnapshotCamera camera_ = test::lookFrom({0, 0, 5}, {0, 0, 0});
};

TEST_F(HandlesTest, AnAxisThatIsSeenEndOnIsNotTaken) {
    const ecs::Entity entity = place({.translation = {-0.2f, -0.15f, 0.0f}});
    // A little beyond the tip of z, which lies 4° from the mouse's ray; x and y go the other ways.
    EXPECT_FALSE(point(entity, 299.2, 195.5, false));
    EXPECT_FALSE(point(entity, 299.2, 195.5, true));
    EXPECT_FALSE(handles_.dragging());
}

TEST_F(HandlesTest, ADragOverTheEndOnPlaceMovesNothingThere) {
    for (const HandleKind kind : {HandleKind::Move, HandleKind::Scale}) {
        handles_.kind = kind;
        const scene::Transform before{.translation = {-1.0f, -0.75f, 0.0f}};
        const ecs::Entity entity = place(before);
        EXPECT_TRUE(point(entity, 232.6, 245.5, false));  // the tip of z
        EXPECT_TRUE(point(entity, 232.6, 245.5, true));
        ASSERT_TRUE(handles_.dragging());
        for (int i = 0; i < 3; ++i)  // a ray along z
            EXPECT_TRUE(point(entity, 320.0, 180.0, true)) << "the camera must not turn";
        const auto& after = world_.get<scene::Transform>(entity);
        EXPECT_EQ(after.translation, before.translation);
        EXPECT_EQ(after.scale, before.scale);
        EXPECT_TRUE(point(entity, 232.6, 245.5, true));  // back to where it was taken
        EXPECT_NEAR(world_.get<scene::Transform>(entity).translation.z, 0.0f, 1e-3f);
        EXPECT_NEAR(world_.get<scene::Transform>(entity).scale.z, 1.0f, 1e-3f);
        EXPECT_TRUE(point(entity, 222.6, 253.0, true));  // and on
        const auto& moved = world_.get<scene::Transform>(entity);
        EXPECT_GT(kind == HandleKind::Move ? moved.translation.z : moved.scale.z - 1.0f, 0.05f);
        EXPECT_EQ(moved.translation.x, before.translation.x);
        (void)point(entity, 600.0, 300.0, false);
        EXPECT_FALSE(handles_.dragging());
    }
}

TEST_F(HandlesTest, TurnsWithTheMouseUnderAMirroredParentToo) {
    handles_.kind = HandleKind::Rotate;
    for (const float side : {1.0f, -1.0f}) {
        const ecs::Entity parent = place({.scale = {side, 1.0f, 1.0f}});
        const ecs::Entity entity = place({}, parent);
        constexpr double kAside = 64.0;  // whole pixels, as ImGui has the mouse
        EXPECT_TRUE(point(entity, 320.0 + kAside, 180.0 - kAside, false));
        EXPECT_TRUE(point(entity, 320.0 + kAside, 180.0 - kAside, true));
        EXPECT_TRUE(point(entity, 320.0, 90.0, true));  // an eighth turn counter-clockwise
        const auto& matrix = world_.get<scene::WorldTransform>(entity).matrix;
        EXPECT_NEAR(matrix[0].x, side * std::sqrt(0.5f), 1e-3f);
        EXPECT_NEAR(matrix[0].y, side * std::sqrt(0.5f), 1e-3f);
        (void)point(entity, 600.0, 300.0, false);
    }
}

}  // namespace
}  // namespace lampyris::overlay
