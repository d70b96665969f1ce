// Where a sensor is and how it moves: frames on a link, turned ones, mounting errors.
#include "murosimf/sensors/mounting.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::difference;

/// A head on a neck, with a frame for eyes that is turned; rows are those of dice.
struct Head {
  Head() {
    fixtures::Dice dice("head");
    for (const int i : {entity.model().object_index("trunk"), entity.model().object_index("neck")}) {
      entity.column(properties::position);
      r(i) = dice.vector(1);
      v(i) = dice.vector(1);
      w(i) = dice.vector(2);
      R(i) = dice.turn();
    }
  }
  Vec3d& r(int i) { return entity.column(properties::position).values[i]; }
  Vec3d& v(int i) { return entity.column(properties::linear_velocity).values[i]; }
  Vec3d& w(int i) { return entity.column(properties::angular_velocity).values[i]; }
  Mat3d& R(int i) { return entity.column(properties::orientation).values[i]; }
  static ModelPtr model() {
    return std::make_shared<const Model>("head", Chain{}
                                                     .base("trunk")
                                                     .with(properties::mass, 1.0)
                                                     .translation({0, 0, 0.3})
                                                     .revolute("neck", {0, 0, 1})
                                                     .with(properties::mass, 0.1)
                                                     .translation({0.1, 0.02, 0.05})
                                                     .rotation(rotation_y(0.4), "eyes")
                                                     .endpoint());
  }
  World world;
  AccessSet access;
  Entity& entity = world.add("robot", model());
  Setup setup{world, entity, access};
};

TEST(Mounting, OnAFrameOfALink) {
  Head head;
  const Mounting mounting(head.setup,
                          {.frame = "eyes", .position = {0.01, 0.03, -0.02}, .orientation = rotation_x(0.7)});
  const int neck = head.entity.model().object_index("neck");
  EXPECT_EQ(mounting.link_object(), neck);
  const Vec3d on_link = Vec3d{0.1, 0.02, 0.05} + rotation_y(0.4) * Vec3d{0.01, 0.03, -0.02};
  EXPECT_LT(difference(mounting.position_on_link(), on_link), 1e-15);
  EXPECT_LT(difference(mounting.orientation_on_link(), rotation_y(0.4) * rotation_x(0.7)), 1e-15);
  const Vec3d arm = head.R(neck) * on_link;
  EXPECT_LT(difference(mounting.position(), head.r(neck) + arm), 1e-15);
  EXPECT_LT(difference(mounting.velocity(), head.v(neck) + cross(head.w(neck), arm)), 1e-15);
  EXPECT_EQ(difference(mounting.angular_velocity(), head.w(neck)), 0);
  EXPECT_LT(difference(mounting.orientation(), head.R(neck) * rotation_y(0.4) * rotation_x(0.7)), 1e-15);
}

TEST(Mounting, WithoutAFrameItIsOnTheBase) {
  Head head;
  const Mounting mounting(head.setup, {.position = {1, 2, 3}});
  EXPECT_EQ(mounting.link_object(), 0);
  EXPECT_LT(difference(mounting.position(), head.r(0) + head.R(0) * Vec3d{1, 2, 3}), 1e-15);
  EXPECT_EQ(mounted_on(head.entity.model(), {}), 0);
  EXPECT_EQ(mounted_on(head.entity.model(), {.frame = "eyes"}), head.entity.model().object_index("eyes"));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)Mounting(head.setup, {.frame = "eyse"}); }), {"eyse"}));
}

// Rule: roll about x first, then pitch, then yaw, about the axes that the sensor should have.
TEST(Mounting, ErrorsTurnItsAxes) {
  const Mat3d turn = rotation_z(0.5) * rotation_x(-1);
  EXPECT_LT(difference(true_orientation({.orientation = turn, .mounting_error = {0.1, 0, 0}}), turn * rotation_x(0.1)),
            1e-15);
  EXPECT_LT(difference(true_orientation({.orientation = turn, .mounting_error = {0, 0.2, 0}}), turn * rotation_y(0.2)),
            1e-15);
  EXPECT_LT(difference(true_orientation({.orientation = turn, .mounting_error = {0, 0, 0.3}}), turn * rotation_z(0.3)),
            1e-15);
  EXPECT_LT(difference(true_orientation({.orientation = turn, .mounting_error = {0.1, 0.2, 0.3}}),
                       turn * rotation_z(0.3) * rotation_y(0.2) * rotation_x(0.1)),
            1e-15);
  Head head;
  const Mounting mounting(head.setup, {.frame = "eyes", .orientation = turn, .mounting_error = {0.1, 0.2, 0.3}});
  EXPECT_LT(difference(mounting.orientation_on_link(),
                       rotation_y(0.4) * turn * rotation_z(0.3) * rotation_y(0.2) * rotation_x(0.1)),
            1e-15);
}

}  // namespace
}  // namespace murosimf::sensors
