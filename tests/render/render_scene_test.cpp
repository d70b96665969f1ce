#include "murosimf/render/render_scene.h"

#include <string>

#include "murosimf/collision/contact_properties.h"
#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

/// A trunk with two feet that have a ball each.
ModelPtr two_feet() {
  const auto leg = [](const std::string& name, double y) {
    return Chain{}
        .translation({0, y, -0.2})
        .revolute(name, {0, 1, 0})
        .with(properties::mass, 0.2)
        .with(properties::inertia, diagonal(1e-3))
        .with(properties::sole, Sole{0.05, 0.03})
        .with(properties::shapes, Shapes{fixtures::placed(Sphere{0.03})});
  };
  return std::make_shared<const Model>("walker", Chain{}
                                                     .base("trunk")
                                                     .with(properties::mass, 1.0)
                                                     .with(properties::inertia, diagonal(1e-2))
                                                     .with(properties::shapes, Shapes{fixtures::placed(Sphere{0.1})})
                                                     .fork(leg("left", 0.05), leg("right", -0.05)));
}

/// Names of the objects that are drawn in yellow.
std::string yellow(const render::RenderScene& render_scene) {
  std::string names;
  render_scene.for_drawables(0, [&](const render::Drawable& drawable, const Transformd&) {
    if (drawable.color.red == 1 && drawable.color.blue == 0) {
      names += render_scene.owner(drawable)->model().objects()[drawable.object].name + " ";
    }
  });
  return names;
}

// Rule (paper, Fig. 4): the standing foot is yellow, at kinematic_walking only, and only on request.
TEST(RenderScene, MarksTheStandingFoot) {
  DrawnWorld world;
  Entity& robot = world.add("robot", two_feet(), {0, 0, 0.3});
  robot.column(properties::stance_foot).values.assign(1, 0);
  robot.column(properties::dynamic).values.assign(1, 0);
  render::RenderScene render_scene(world.world, world.moving_entities);
  render_scene.locate();
  EXPECT_EQ(yellow(render_scene), "");
  render_scene.mark_standing_feet({1, 0.85, 0});
  EXPECT_EQ(yellow(render_scene), "left ");
  robot.column(properties::stance_foot).values[0] = 1;
  EXPECT_EQ(yellow(render_scene), "right ");
  robot.column(properties::dynamic).values[0] = 1;
  EXPECT_EQ(yellow(render_scene), "") << "forces move it now";
}

// Rule: gray without a material means the entity's own color; a material may be gray.
TEST(RenderScene, GrayOfAMaterialStaysGray) {
  DrawnWorld world;
  world.add("robot", two_feet(), {0, 0, 0.3});
  const render::RenderScene render_scene(world.world, world.moving_entities, [](const Entity& /*entity*/) {
    return render::EntityAppearance{{{0, render::unit_box(), {}}, {0, render::unit_box(), {}, true}}, {}};
  });
  ASSERT_EQ(render_scene.drawables().size(), 2U);
  EXPECT_TRUE(render_scene.drawables()[0].own_color);
  EXPECT_FALSE(render_scene.drawables()[1].own_color);
  EXPECT_EQ(render_scene.drawables()[1].color, Color{});
}

// A displayed moment hides columns that it does not have: nothing of the running world is used.
TEST(RenderScene, ShowsAMomentInsteadOfColumns) {
  DrawnWorld world;
  Entity& robot = world.add("robot", two_feet(), {0, 0, 0.3});
  robot.column(properties::stance_foot).values.assign(1, 0);
  robot.column(properties::dynamic).values.assign(1, 1);
  render::RenderScene render_scene(world.world, world.moving_entities);
  render_scene.locate();
  render_scene.mark_standing_feet({1, 0.85, 0});
  PoseFrame frame;
  take_poses(world.world, frame);
  const render::ShownMoment moment{&frame, {1}};
  render_scene.show(&moment);
  robot.column(properties::position).values.assign(robot.model().size(), Vec3d{9, 9, 9});
  robot.set_present(false);
  int seen = 0;
  render_scene.for_drawables(0, [&](const render::Drawable&, const Transformd& pose) {
    ++seen;
    EXPECT_LT(norm(pose.position), 2);
  });
  EXPECT_EQ(seen, 3);
  EXPECT_EQ(yellow(render_scene), "right ");
  frame.present[0] = false;
  EXPECT_EQ(yellow(render_scene), "");
  render_scene.show(nullptr);
  robot.set_present(true);
  render_scene.for_drawables(0,
                             [&](const render::Drawable&, const Transformd& pose) { EXPECT_GT(pose.position.x, 8); });
}

TEST(RenderScene, LabelsTellPiecesApart) {
  DrawnWorld world;
  world.add("robot", two_feet(), {0, 0, 0.3});
  render::RenderScene render_scene(world.world, world.moving_entities);
  render_scene.label_pieces();
  for (std::size_t i = 0; i < render_scene.drawables().size(); ++i) {
    EXPECT_EQ(render_scene.drawables()[i].label, render::RenderScene::first_piece_label + i);
  }
}

}  // namespace
}  // namespace murosimf::test
