/// same_model.h - whether two models are equal: names, poses in any joint positions, constants, servos and shapes.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/loops.h"
#include "tests/fixtures.h"

namespace murosimf::robot::same_model {

constexpr double tolerance = 2e-12;  ///< [1] of the larger of a number and 1: rounding, and the least inertia

inline bool is_near(double a, double b) { return std::fabs(a - b) <= tolerance * std::max(1.0, std::fabs(b)); }

struct Poses {
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
};

/// All joints turned or shifted by an amount that follows from their names.
inline Poses bent(const Model& model) {
  std::vector<double> q(static_cast<std::size_t>(model.size()), 0.0);
  for (const int joint : model.joints()) {
    q[joint] = RandomStream(7, model.objects()[joint].name).uniform(0, -1.5, 1.5);
  }
  Poses poses{std::vector<Vec3d>(q.size()), std::vector<Mat3d>(q.size())};
  multibody::poses<double>(model.tree(), q, poses.r, poses.R);
  return poses;
}

/// Rows of numbers: masses, inertias, ranges, dampings ...
inline void expect_same_constants(const Model& found, int i, const Model& expected, int k, const std::string& name) {
  for (const auto& [key, column] : expected.constants().columns()) {
    const auto& columns = found.constants().columns();
    const auto other = columns.find(key);
    const auto right = column->numbers(k);
    const auto numbers = other == columns.end() ? std::vector<double>{} : other->second->numbers(i);
    ASSERT_EQ(numbers.size(), right.size()) << name << ": " << key;
    for (std::size_t n = 0; n < right.size(); ++n) {
      EXPECT_TRUE(is_near(numbers[n], right[n])) << name << ": " << key << ' ' << numbers[n] << ", not " << right[n];
    }
  }
}

inline void expect_same_servo(const Servo* found, const Servo* expected, const std::string& name) {
  ASSERT_EQ(found == nullptr, expected == nullptr) << name;
  if (!expected) return;
  EXPECT_EQ(found->law, expected->law) << name;
  EXPECT_EQ(found->stall_torque, expected->stall_torque) << name;
  EXPECT_EQ(found->position_gain, expected->position_gain) << name;
  EXPECT_EQ(found->velocity_gain, expected->velocity_gain) << name;
}

inline void expect_same_shape(const PlacedShape& found, const PlacedShape& expected, const std::string& name) {
  EXPECT_STREQ(shape_name(found.shape), shape_name(expected.shape)) << name;
  EXPECT_TRUE(is_near(bounding_radius(found.shape), bounding_radius(expected.shape))) << name;
  EXPECT_LT(fixtures::difference(found.position, expected.position), tolerance) << name;
  EXPECT_LT(fixtures::difference(found.orientation, expected.orientation), tolerance) << name;
  EXPECT_EQ(found.surface.friction, expected.surface.friction) << name;
  EXPECT_EQ(found.color.red, expected.color.red) << name;
  ASSERT_EQ(found.collides, expected.collides) << name;
  if (!expected.collides) return;
  EXPECT_EQ(found.contact_type, expected.contact_type) << name;
  EXPECT_EQ(found.contact_affinity, expected.contact_affinity) << name;
}

inline void expect_same_shapes(const Shapes* found, const Shapes* expected, const std::string& name) {
  ASSERT_EQ(found == nullptr, expected == nullptr) << name;
  if (!expected) return;
  ASSERT_EQ(found->size(), expected->size()) << name;
  for (std::size_t i = 0; i < expected->size(); ++i) expect_same_shape((*found)[i], (*expected)[i], name);
}

inline void expect_same_coupling(const JointCoupling* found, const JointCoupling* expected, const std::string& name) {
  ASSERT_EQ(found == nullptr, expected == nullptr) << name;
  if (!expected) return;
  EXPECT_EQ(found->leader, expected->leader) << name;
  EXPECT_EQ(found->ratio, expected->ratio) << name;
  EXPECT_EQ(found->offset, expected->offset) << name;
}

inline void expect_same_loop(const LoopClosure* found, const LoopClosure* expected, const std::string& name) {
  ASSERT_EQ(found == nullptr, expected == nullptr) << name;
  if (!expected) return;
  EXPECT_EQ(found->other, expected->other) << name;
  EXPECT_EQ(found->welded, expected->welded) << name;
}

/// All objects but those that only give the tree its shape: forks are numbered in the order of the file, and turns by
/// less than rounding may be gone.
inline void expect_same(const Model& found, const Model& expected) {
  EXPECT_EQ(found.joints().size(), expected.joints().size());
  EXPECT_EQ(found.bodies().size(), expected.bodies().size());
  EXPECT_TRUE(is_near(found.tree().mass, expected.tree().mass)) << found.tree().mass;
  const Poses poses = bent(found), right = bent(expected);
  for (int k = 0; k < expected.size(); ++k) {
    const Object& object = expected.objects()[k];
    if (object.kind == Kind::fork || object.structural) continue;
    const auto i = found.find_object(object.name);
    ASSERT_TRUE(i) << object.name << " is lost";
    EXPECT_EQ(found.objects()[*i].kind, object.kind) << object.name;
    EXPECT_LT(fixtures::difference(poses.r[*i], right.r[k]), tolerance) << object.name;
    EXPECT_LT(fixtures::difference(poses.R[*i], right.R[k]), tolerance) << object.name;
    expect_same_constants(found, *i, expected, k, object.name);
    expect_same_servo(found.find(properties::servo, *i), expected.find(properties::servo, k), object.name);
    expect_same_shapes(found.find(properties::shapes, *i), expected.find(properties::shapes, k), object.name);
    expect_same_loop(found.find(properties::loop_closure, *i), expected.find(properties::loop_closure, k), object.name);
    expect_same_coupling(found.find(properties::joint_coupling, *i), expected.find(properties::joint_coupling, k),
                         object.name);
  }
}

}  // namespace murosimf::robot::same_model
