#include "murosimf/multibody/kinematics.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::multibody {
namespace {

using fixtures::Dice;
using fixtures::difference;
using fixtures::State;
using Spans = std::span<const Vec3d>;

constexpr std::uint64_t trees = 20;

Eigen::Vector3d dense(const Vec3d& v) { return {v.x, v.y, v.z}; }
Eigen::Matrix3d dense(const Mat3d& m) {
  Eigen::Matrix3d d;
  d << dense(m.x), dense(m.y), dense(m.z);
  return d;
}

/// The 4x4 transformation of one object, by its kind and nothing else.
Eigen::Matrix4d transformation(const Object& object, double q) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  switch (object.kind) {
    case Kind::translation: T.topRightCorner<3, 1>() = dense(object.vector); break;
    case Kind::rotation: T.topLeftCorner<3, 3>() = dense(object.turn); break;
    case Kind::revolute: T.topLeftCorner<3, 3>() = Eigen::AngleAxisd(q, dense(object.vector)).toRotationMatrix(); break;
    case Kind::prismatic: T.topRightCorner<3, 1>() = q * dense(object.vector); break;
    case Kind::base:
    case Kind::fork:
    case Kind::endpoint: break;
  }
  return T;
}

/// The objects whose rows the kernels keep: all but the structural ones.
std::vector<int> kept_rows(const Model& model) {
  std::vector<int> rows;
  for (int i = 0; i < model.size(); ++i) {
    if (!model.objects()[i].structural) rows.push_back(i);
  }
  return rows;
}

/// Poses of all objects by composition, one by one.
std::vector<Eigen::Matrix4d> compose(const Model& model, const State<double>& s) {
  std::vector<Eigen::Matrix4d> T(static_cast<std::size_t>(model.size()), Eigen::Matrix4d::Identity());
  T[0].topLeftCorner<3, 3>() = dense(s.R[0]);
  T[0].topRightCorner<3, 1>() = dense(s.r[0]);
  for (int i = 1; i < model.size(); ++i) {
    const Object& object = model.objects()[i];
    T[i] = T[object.parent] * transformation(object, s.q[i]);
  }
  return T;
}

void place(const Model& model, State<double>& s) { poses<double>(model.tree(), s.q, s.r, s.R); }
void move(const Model& model, State<double>& s) { velocities<double>(model.tree(), s.qd, s.r, s.R, s.v, s.w); }

/// The state a little later, if all rates stay: base by its velocity, joints by theirs.
State<double> later(const Model& model, const State<double>& s, double time) {
  State<double> next = s;
  next.r[0] += time * s.v[0];
  next.R[0] = to_matrix(exponential(time * s.w[0])) * s.R[0];
  for (const int joint : model.joints()) next.q[joint] += time * s.qd[joint];
  place(model, next);
  return next;
}

/// One row about direct kinematics.
void expect_kernel(const std::string& law, const std::string& source, const law::Measured& error, double limit,
                   const std::string& unit) {
  law::expect_below({.law = law, .level = "kinematics", .source = source}, error, limit, unit);
}

/// Links from the base (excluded) to `link`.
std::vector<int> path_to(const Tree& tree, int link) {
  std::vector<int> path;
  for (int l = link; l > 0; l = tree.links[l].parent) path.insert(path.begin(), l);
  return path;
}

// Tolerance: up to 30 products, each with a rounding of a few 1e-16 of lengths up to 10 m.
TEST(Kinematics, PosesAgainstHomogeneousMatrices) {
  law::Worst place_error, turn_error;
  for (std::uint64_t seed = 1; seed <= trees; ++seed) {
    const Model model = fixtures::random_model(seed);
    Dice dice("poses", seed);
    State<double> s = fixtures::random_state(model, dice);
    place(model, s);
    const auto T = compose(model, s);
    for (const int i : kept_rows(model)) {
      place_error.see((dense(s.r[i]) - T[i].topRightCorner<3, 1>()).norm(), "tree", seed, "object", i);
      turn_error.see((dense(s.R[i]) - T[i].topLeftCorner<3, 3>()).norm(), "tree", seed, "object", i);
    }
  }
  expect_kernel("poses in random trees: error of places", "product of the objects' 4x4 matrices", place_error, 3e-14,
                "m");
  expect_kernel("poses in random trees: error of orientations", "product of the objects' 4x4 matrices", turn_error,
                2e-14, "");
}

// A straight leg is 0.31 m long, a knee at q moves the foot on a circle. Tolerance: rounding.
TEST(Kinematics, LegInClosedForm) {
  const Model model = fixtures::two_legged();
  State<double> s(model.size());
  place(model, s);
  const int foot = model.object_index("left_foot");
  law::Worst error;
  error.see(difference(s.r[foot], {0.02, 0.05, -0.31}), "straight");
  const double q = 0.7;
  s.q[model.object_index("left_knee")] = q;
  place(model, s);
  // the shin with foot, (0.02, 0, -0.15) from the knee, turned about y
  const Vec3d expected{0.02 * std::cos(q) - 0.15 * std::sin(q), 0.05, -0.16 - 0.02 * std::sin(q) - 0.15 * std::cos(q)};
  error.see(difference(s.r[foot], expected), "bent");
  error.see(difference(s.r[model.object_index("right_foot")], {0.02, -0.05, -0.31}), "other leg");
  expect_kernel("two-legged robot, knee bent: error of the feet's places", "closed form of two links", error, 1e-15,
                "m");
}

// Tolerance: central differences over h = 1e-5 s err by h^2/6 of the third derivative (up to 20 joints at 2 rad/s: sums
// of 30 rad/s on arms of meters, 1e5 m/s^3 at most: 2e-6) and by rounding of positions (1e-15 m / h = 1e-10); a wrong
// term errs by 0.1 and more.
TEST(Kinematics, VelocitiesAgainstDifferencesOfPoses) {
  const double h = 1e-5;
  law::Worst v_error, w_error;
  for (std::uint64_t seed = 1; seed <= trees; ++seed) {
    const Model model = fixtures::random_model(seed);
    Dice dice("velocities", seed);
    State<double> s = fixtures::random_state(model, dice);
    place(model, s);
    move(model, s);
    const State<double> before = later(model, s, -h), after = later(model, s, h);
    for (const int i : kept_rows(model)) {
      const Vec3d v = (0.5 / h) * (after.r[i] - before.r[i]);
      v_error.see(difference(s.v[i], v), "tree", seed, "object", i);
      const Vec3d turned = (0.5 / h) * rotation_vector(from_matrix(after.R[i] * transpose(before.R[i])));
      w_error.see(difference(s.w[i], turned), "tree", seed, "object", i);
    }
  }
  expect_kernel("velocities in random trees: error, linear", "central differences of poses", v_error, 2e-6, "m/s");
  expect_kernel("velocities in random trees: error, angular", "central differences of poses", w_error, 2e-6, "rad/s");
}

// Rule: the base's rows are input and stay as they are.
TEST(Kinematics, BaseStays) {
  const Model model = fixtures::two_legged();
  Dice dice("base stays");
  State<double> s = fixtures::random_state(model, dice);
  const State<double> before = s;
  place(model, s);
  move(model, s);
  EXPECT_EQ(difference(s.r[0], before.r[0]), 0);
  EXPECT_EQ(difference(s.R[0], before.R[0]), 0);
  EXPECT_EQ(difference(s.v[0], before.v[0]), 0);
  EXPECT_EQ(difference(s.w[0], before.w[0]), 0);
}

// Tolerance: as for poses. Joints that are not on the way are NaN here: they are not looked at.
TEST(Kinematics, PoseInBase) {
  law::Worst place_error, turn_error;
  for (std::uint64_t seed = 1; seed <= trees; ++seed) {
    const Model model = fixtures::random_model(seed);
    const Tree& tree = model.tree();
    Dice dice("pose in base", seed);
    State<double> s = fixtures::random_state(model, dice);
    place(model, s);
    for (const int i : kept_rows(model)) {
      const std::vector<int> path = path_to(tree, tree.link_of[i]);
      std::vector<double> q(s.q.size(), std::nan(""));
      for (const int l : path) q[tree.links[l].object] = s.q[tree.links[l].object];
      const Transform<double> pose = pose_in_base<double>(tree, path, model.placement(i), q);
      place_error.see(difference(pose.position, transposed_times(s.R[0], s.r[i] - s.r[0])), "tree", seed, "object", i);
      turn_error.see(difference(pose.orientation, transpose(s.R[0]) * s.R[i]), "tree", seed, "object", i);
    }
  }
  const std::string source = "pose in the world, seen from the base";
  expect_kernel("pose in the base frame by the joints on the way: error of places", source, place_error, 3e-14, "m");
  expect_kernel("pose in the base frame by the joints on the way: error of orientations", source, turn_error, 2e-14,
                "");
}

// Tolerance: velocities up to 100 m/s and rad/s with 1e-16 each, over some ten joints.
TEST(Kinematics, TwistAgainstBase) {
  law::Worst w_error, v_error;
  for (std::uint64_t seed = 1; seed <= trees; ++seed) {
    const Model model = fixtures::random_model(seed);
    const Tree& tree = model.tree();
    Dice dice("twist against base", seed);
    State<double> s = fixtures::random_state(model, dice);
    place(model, s);
    move(model, s);
    for (const int i : kept_rows(model)) {
      const std::vector<int> path = path_to(tree, tree.link_of[i]);
      const Vec3d at = s.r[i] + dice.vector(0.2);
      const Twistd twist = twist_against_base<double>(tree, path, at, s.qd, Spans(s.r), std::span<const Mat3d>(s.R));
      const Vec3d carried = s.v[0] + cross(s.w[0], at - s.r[0]);
      w_error.see(difference(twist.w, s.w[i] - s.w[0]), "tree", seed, "object", i);
      v_error.see(difference(twist.v, s.v[i] + cross(s.w[i], at - s.r[i]) - carried), "tree", seed, "object", i);
    }
  }
  const std::string source = "velocity less that of a rigid body that moves with the base";
  expect_kernel("twist against the base: error, angular", source, w_error, 1e-13, "rad/s");
  expect_kernel("twist against the base: error, linear", source, v_error, 3e-13, "m/s");
}

// Rule: shift_all moves every row by the same vector.
TEST(Kinematics, ShiftAll) {
  std::vector<Vec3d> rows{{1, 2, 3}, {4, 5, 6}, {-1, 0, 1}};
  shift_all<double>(rows, Vec3d{0.5, -1, 2});
  EXPECT_EQ(difference(rows[0], {1.5, 1, 5}), 0);
  EXPECT_EQ(difference(rows[1], {4.5, 4, 8}), 0);
  EXPECT_EQ(difference(rows[2], {-0.5, -1, 3}), 0);
}

}  // namespace
}  // namespace murosimf::multibody
