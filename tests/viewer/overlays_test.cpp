#include "murosimf/viewer/overlays.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"

namespace murosimf::viewer {
namespace {

TEST(Overlays, HullOfPointsOnTheGround) {
  const auto hull = hull_on_ground({{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}, {2, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}});
  ASSERT_EQ(hull.size(), 4U) << "neither the one inside nor the one on an edge";
  double area = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec3d &a = hull[i], &b = hull[(i + 1) % hull.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  EXPECT_NEAR(area, 2, 1e-12) << "counterclockwise";
  EXPECT_EQ(hull_on_ground({{1, 1, 0}, {0, 0, 0}}).size(), 2U);
  EXPECT_LE(hull_on_ground({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).size(), 2U);
}

/// A running scene's first moment, as the viewer has it.
struct Moment {
  explicit Moment(Duration time = std::chrono::milliseconds(200))
      : scene("three_on_three", {.overrides = {"blue1.level=simplified_dynamics"}}) {
    auto reader = scene.simulation().poses().subscribe({.contacts = true});
    scene.simulation().run(time);
    frame = *reader->latest();
    outline = outline_of(scene);
    seen = inspect(scene, {});
  }
  scene::Scene scene;
  PoseFrame frame;
  std::vector<EntityOutline> outline;
  Inspection seen;
};

TEST(Overlays, NothingUnlessAskedFor) {
  const Moment moment;
  const auto nothing = overlays(moment.frame, moment.outline, moment.seen, {.names = false}, -1);
  EXPECT_TRUE(nothing.marks.empty());
  EXPECT_TRUE(nothing.labels.empty());
}

TEST(Overlays, NamesOfAllWhoMove) {
  const Moment moment;
  const auto drawn = overlays(moment.frame, moment.outline, moment.seen, {}, -1);
  EXPECT_EQ(drawn.labels.size(), 7U) << "six robots and the ball";
}

// The sum of the forces with the ground on a robot that walks slowly is its weight, more or less.
TEST(Overlays, ForcesStandOnTheContacts) {
  const Moment moment;
  const auto drawn =
      overlays(moment.frame, moment.outline, moment.seen, {.forces = true, .names = false, .force_scale = 0.01}, -1);
  ASSERT_FALSE(drawn.marks.empty());
  for (const Mark& mark : drawn.marks) {
    ASSERT_EQ(mark.points.size(), 2U);
    EXPECT_TRUE(mark.arrow);
    EXPECT_LT(mark.points[0].z, 0.2);
  }
}

TEST(Overlays, CenterOfMassIsThatOfTheModel) {
  const Moment moment;
  const auto entity = static_cast<std::size_t>(
      moment.scene.simulation().world().index_of(moment.scene.simulation().world().find("blue1")));
  const std::size_t first = moment.frame.first[entity], rows = moment.frame.first[entity + 1] - first;
  const Model& model = *moment.outline[entity].model;
  const auto center = center_of_mass(model, std::span(moment.frame.position).subspan(first, rows),
                                     std::span(moment.frame.orientation).subspan(first, rows));
  ASSERT_TRUE(center);
  // the level knows its own
  const auto* column = moment.scene.simulation().world().entity("blue1").find("common_center_of_mass");
  ASSERT_TRUE(column);
  const auto own = moment.scene.simulation().world().entity("blue1").base().get("common_center_of_mass").numbers;
  EXPECT_NEAR(center->x, own[0], 1e-9);
  EXPECT_NEAR(center->y, own[1], 1e-9);
  EXPECT_NEAR(center->z, own[2], 1e-9);
}

TEST(Overlays, SupportPolygonIsUnderTheRobotThatTouches) {
  const Moment moment(std::chrono::milliseconds(1200));
  const auto drawn =
      overlays(moment.frame, moment.outline, moment.seen, {.names = false, .support_polygons = true}, -1);
  ASSERT_FALSE(drawn.marks.empty());
  for (const Mark& mark : drawn.marks) {
    bool near_somebody = false;
    for (std::size_t i = 0; i < moment.outline.size(); ++i) {
      if (!moment.outline[i].is_robot) continue;
      const Vec3d base = moment.frame.position[moment.frame.first[i]];
      near_somebody = near_somebody || std::hypot(base.x - mark.points[0].x, base.y - mark.points[0].y) < 0.3;
    }
    EXPECT_TRUE(near_somebody);
  }
}

TEST(Overlays, BeliefsStandWhereRobotsTakeThemselvesToBe) {
  Moment moment;
  const OverlayOptions beliefs{.names = false, .beliefs = true};
  EXPECT_TRUE(overlays(moment.frame, moment.outline, moment.seen, beliefs, -1).marks.empty())
      << "no robot has a belief";
  const auto robot = static_cast<std::size_t>(
      moment.scene.simulation().world().index_of(&moment.scene.simulation().world().entity("red1")));
  moment.seen.entities[robot].believed_pose = Vec3d{1, 2, pi / 2};
  const auto marks = overlays(moment.frame, moment.outline, moment.seen, beliefs, -1).marks;
  ASSERT_EQ(marks.size(), 3U);
  for (const Vec3d& p : marks[0].points) EXPECT_NEAR(std::hypot(p.x - 1, p.y - 2), 0.22, 1e-12);
  EXPECT_TRUE(marks[1].arrow);
  EXPECT_NEAR(marks[1].points[1].x, 1, 1e-12);
  EXPECT_GT(marks[1].points[1].y, 2.1) << "along y";
  EXPECT_NEAR(marks[2].points[1].x, moment.frame.position[moment.frame.first[robot]].x, 1e-12) << "to the truth";
}

// A robot that stands still is carried below its center of mass; forces at 0 and 1 m of 1 and 3 N act at 0.75 m.
TEST(Overlays, ZeroMomentPoint) {
  PoseFrame frame;
  frame.contacts = {{{0, 2, 0}, {5, 0, 1}, 7},
                    {{1, 2, 0}, {0, 5, 3}, 7},
                    {{9, 9, 0}, {0, 0, 100}, 8},
                    {{8, 8, 1}, {0, 0, 100}, -1}};
  const auto point = zero_moment_point(frame, 7);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->x, 0.75, 1e-12);
  EXPECT_NEAR(point->y, 2, 1e-12);
  EXPECT_FALSE(zero_moment_point(frame, 6));
  const Moment moment(std::chrono::milliseconds(800));
  int shown = 0;
  for (std::size_t i = 0; i < moment.outline.size(); ++i) {
    if (!moment.outline[i].is_robot) continue;
    const auto carried = zero_moment_point(moment.frame, static_cast<int>(i));
    if (!carried) continue;
    ++shown;
    const std::size_t first = moment.frame.first[i], rows = moment.frame.first[i + 1] - first;
    const auto center = center_of_mass(*moment.outline[i].model, std::span(moment.frame.position).subspan(first, rows),
                                       std::span(moment.frame.orientation).subspan(first, rows));
    EXPECT_LT(std::hypot(carried->x - center->x, carried->y - center->y), 0.15) << moment.outline[i].name;
  }
  EXPECT_GT(shown, 0);
}

TEST(Overlays, JointLoadsAreSharesOfTheServos) {
  EXPECT_EQ(color_of_load(0), (Color{0, 1, 0.1}));
  EXPECT_EQ(color_of_load(0.5), (Color{1, 1, 0.1}));
  EXPECT_EQ(color_of_load(3), (Color{1, 0, 0.1}));
  scene::Scene scene("nudge");
  auto reader = scene.simulation().poses().subscribe({});
  scene.simulation().run(std::chrono::milliseconds(300));
  const Inspection seen = inspect(scene, {.loads = true});
  ASSERT_FALSE(seen.loads.empty());
  const Entity& robot = *scene.simulation().world().entities()[static_cast<std::size_t>(seen.loads[0].path.entity)];
  bool loaded = false;
  for (const JointLoad& load : seen.loads) {
    const Servo& servo = *robot.model().find(properties::servo, load.path.object);
    const double torque = robot.find(properties::joint_torque)->values[static_cast<std::size_t>(load.path.object)];
    const double limit = servo.torque_limit > 0 ? servo.torque_limit : servo.stall_torque;
    EXPECT_NEAR(load.share * limit, std::abs(torque), 1e-9);
    loaded = loaded || load.share > 0.05;
  }
  EXPECT_TRUE(loaded) << "it stands";
  const auto outline = outline_of(scene);
  const auto drawn = overlays(*reader->latest(), outline, seen, {.names = false, .joint_loads = true}, -1);
  EXPECT_EQ(drawn.marks.size(), seen.loads.size());
}

}  // namespace
}  // namespace murosimf::viewer
