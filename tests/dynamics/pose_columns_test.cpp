// Where a robot is put at its start, what users change on the way, and its momentum.
#include "murosimf/dynamics/pose_columns.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;

struct Nothing {
  explicit Nothing(Setup&) {}
};

/// A body with an unsymmetric box; its sole, if it has one, is turned against it.
Chain body(bool sole) {
  PlacedShape box;
  box.shape = Box{{0.1, 0.2, 0.05}};
  box.position = {0, 0, -0.3};
  Chain chain = Chain{}
                    .base("base")
                    .with(properties::mass, 2.0)
                    .with(properties::inertia, {0.1, 0.2, 0.3, 0, 0, 0})
                    .with(properties::shapes, Shapes{box})
                    .revolute("joint", {1, 0, 0})
                    .with(properties::mass, 0.7)
                    .with(properties::center_of_mass, {0.1, -0.2, 0.15})
                    .with(properties::inertia, {0.01, 0.02, 0.03, 0, 0, 0});
  if (sole) chain.rotation({0, 0, 1}, 0.5).with(properties::sole, {0.05, 0.03});
  return chain;
}

struct Placed {
  explicit Placed(const EntityOptions& options, bool sole = false)
      : entity(simulation.world().add("robot", std::make_shared<const Model>("robot", body(sole)), options)),
        columns(simulation.attach<test::Holder<Nothing>>("part", entity, 1000).columns) {
    simulation.initialize();
  }
  Simulation simulation;
  Entity& entity;
  PoseColumns& columns;
};

TEST(PlaceAtStart, LowestPointIsAtTheHeightAndTheBaseAboveItsPlace) {
  Placed placed({.position = {1, 2, 0.03}, .heading = 0.6});
  placed.columns.v[0] = {9, 9, 9};
  placed.columns.qd[1] = 3;
  place_at_start(placed.columns, placed.entity);
  EXPECT_LT(difference(placed.columns.r[0], {1, 2, 0.03 + 0.35}), 1e-15);
  EXPECT_LT(difference(placed.columns.R[0], rotation_z(0.6)), 1e-15);
  EXPECT_LT(difference(to_matrix(placed.columns.Q[0]), rotation_z(0.6)), 1e-15);
  EXPECT_EQ(norm(placed.columns.v[0]), 0);
  EXPECT_EQ(placed.columns.qd[1], 0);
  EXPECT_LT(difference(placed.columns.r[1], placed.columns.r[0]), 1e-15);
}

// On its side about x the box lies on its long edge: its half width of 0.2 m is below, and the box beside the base.
TEST(PlaceAtStart, AttitudeComesBeforeTheHeading) {
  Placed placed({.heading = 0.6, .attitude = rotation_x(pi / 2)});
  place_at_start(placed.columns, placed.entity);
  EXPECT_LT(difference(placed.columns.R[0], rotation_z(0.6) * rotation_x(pi / 2)), 1e-15);
  EXPECT_NEAR(placed.columns.r[0].z, 0.2, 1e-15);
}

TEST(PlaceAtStart, HeadingIsThatOfTheFirstSole) {
  Placed placed({.heading = 0.6}, true);
  placed.columns.q[placed.entity.model().object_index("joint")] = 0.2;
  place_at_start(placed.columns, placed.entity);
  const int sole = placed.entity.model().having(properties::sole).front();
  EXPECT_LT(difference(placed.columns.R[sole], rotation_z(0.6)), 1e-14) << "flat, and turned by the heading";
  EXPECT_LT(difference(to_matrix(placed.columns.Q[0]), placed.columns.R[0]), 1e-14);
}

// What it remembers is state: it stands in columns, so that a copy of them goes on alike.
TEST(PoseColumns, RemembersTheBaseInItsColumns) {
  Placed placed({});
  placed.columns.r[0] = {1, 2, 3};
  placed.columns.v[0] = {4, 5, 6};
  placed.columns.remember_base();
  EXPECT_EQ(difference(placed.entity.base().get(properties::written_position), {1, 2, 3}), 0);
  EXPECT_EQ(difference(placed.entity.base().get(properties::written_velocity), {4, 5, 6}), 0);
}

TEST(PoseColumns, TakesWhatUsersChangedOnce) {
  Placed placed({});
  PoseColumns& columns = placed.columns;
  columns.r[0] = {1, 2, 3};
  columns.v[0] = {4, 5, 6};
  columns.remember_base();
  EXPECT_EQ(norm(columns.take_displacement()), 0);
  columns.r[0] = {1.5, 2, 2};
  columns.v[0] = {4, 4, 8};
  EXPECT_LT(difference(columns.take_displacement(), {0.5, 0, -1}), 1e-15);
  EXPECT_LT(difference(columns.take_velocity_change(), {0, -1, 2}), 1e-15);
  EXPECT_EQ(norm(columns.take_displacement()), 0);
  EXPECT_EQ(norm(columns.take_velocity_change()), 0);
}

TEST(PoseColumns, StopLeavesNoMotion) {
  Placed placed({});
  PoseColumns& columns = placed.columns;
  for (auto& v : columns.v) v = {1, 1, 1};
  for (auto& w : columns.w) w = {1, 1, 1};
  for (auto& qd : columns.qd) qd = 1;
  columns.stop();
  for (int i = 0; i < placed.entity.model().size(); ++i) {
    EXPECT_EQ(norm(columns.v[i]) + norm(columns.w[i]) + columns.qd[i], 0);
  }
}

// Sum over two bodies by hand.
TEST(PoseColumns, MomentumIsThatOfAllBodies) {
  Placed placed({});
  PoseColumns& columns = placed.columns;
  columns.r[0] = {0.3, 0.1, 0.5};
  columns.R[0] = rotation_z(0.4) * rotation_x(0.3);
  columns.q[1] = 0.7;
  columns.qd[1] = -2;
  columns.v[0] = {1, -2, 0.5};
  columns.w[0] = {0.3, 0.8, -1.1};
  columns.update_poses();
  columns.update_velocities();
  const Vec3d arm = columns.R[1] * Vec3d{0.1, -0.2, 0.15}, limb = columns.r[1] + arm;
  const Vec3d limb_velocity = columns.v[1] + cross(columns.w[1], arm);
  EXPECT_LT(difference(columns.w[1], columns.w[0] - 2.0 * columns.R[0].x), 1e-14);
  const Vec3d p = 2.0 * columns.v[0] + 0.7 * limb_velocity;
  const Vec3d center = (1 / 2.7) * (2.0 * columns.r[0] + 0.7 * limb);
  const Vec3d L = cross(columns.r[0] - center, 2.0 * columns.v[0]) + cross(limb - center, 0.7 * limb_velocity) +
                  rotated(columns.R[0], SymMat3d{0.1, 0.2, 0.3, 0, 0, 0}) * columns.w[0] +
                  rotated(columns.R[1], SymMat3d{0.01, 0.02, 0.03, 0, 0, 0}) * columns.w[1];
  const Momentum found = columns.momentum();
  EXPECT_LT(difference(found.linear, p), 1e-14);
  EXPECT_LT(difference(found.angular, L), 1e-14);
}

}  // namespace
}  // namespace murosimf::dynamics
