// include/murosimf/kinematics.h: against the scene's poses, differences of poses, and the energy of the robot.
#include "murosimf/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/scene.h"

namespace murosimf::api {
namespace {

struct Kid {
  Scene scene = Scene::of_robot("kid21", {.set = {"robot.level=simplified_dynamics"}});
  Robot robot = scene.robot();
  Kinematics kinematics = robot.kinematics();
  std::vector<double> q = row(0.3, 1.3), v = row(-0.7, 2.1), a = row(1.9, 0.6);

  /// Numbers that no symmetry of the robot hides.
  [[nodiscard]] std::vector<double> row(double scale, double phase) const {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < robot.joints().size(); ++i) {
      numbers.push_back(scale * std::sin(phase + 0.9 * static_cast<double>(i * i)));
    }
    return numbers;
  }
};

Vector3 turned(const Rotation& q, const Vector3& v) {
  const Vector3 t{2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x)};
  return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
          v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

TEST(ApiKinematics, PosesAreThoseOfTheScene) {
  Kid kid;
  kid.scene.run(0.3);
  const Pose base = kid.robot.pose();
  const std::span<const double> q = kid.robot.joint_position();
  for (const std::string& object : kid.robot.objects()) {
    const Pose pose = kid.kinematics.poses(q, object).at(0);
    const Vector3 there = turned(base.orientation, pose.position), world = kid.robot.pose(object).position;
    EXPECT_NEAR(base.position.x + there.x, world.x, 1e-12) << object;
    EXPECT_NEAR(base.position.y + there.y, world.y, 1e-12);
    EXPECT_NEAR(base.position.z + there.z, world.z, 1e-12);
  }
}

TEST(ApiKinematics, JacobiansAreDifferencesOfPoses) {
  Kid kid;
  const std::size_t n = kid.q.size();
  for (const char* object : {"head", "l_foot", "r_foot"}) {
    const std::vector<double> J = kid.kinematics.jacobians(kid.q, object);
    ASSERT_EQ(J.size(), 6 * n);
    const double h = 1e-6;
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<double> two = kid.q;
      two[i] -= h;
      const std::vector<double> low = two;
      two[i] += 2 * h;
      two.insert(two.end(), low.begin(), low.end());
      const std::vector<Pose> poses = kid.kinematics.poses(two, object);
      ASSERT_EQ(poses.size(), 2U);
      const Vector3 &up = poses[0].position, &down = poses[1].position;
      EXPECT_NEAR(J[0 * n + i], (up.x - down.x) / (2 * h), 1e-8) << object << " " << i;
      EXPECT_NEAR(J[1 * n + i], (up.y - down.y) / (2 * h), 1e-8);
      EXPECT_NEAR(J[2 * n + i], (up.z - down.z) / (2 * h), 1e-8);
      // dq = w/2 q, so w = 2 (dq q*)
      const Rotation &b = poses[0].orientation, &c = poses[1].orientation;
      const double wx = -b.w * c.x + b.x * c.w - b.y * c.z + b.z * c.y;
      EXPECT_NEAR(J[3 * n + i], wx / h, 1e-7);
    }
  }
}

TEST(ApiKinematics, TheMassMatrixIsTheEnergyAndTheTorques) {
  Kid kid;
  const std::size_t n = kid.q.size(), size = n + 6;
  const std::vector<double> M = kid.kinematics.mass_matrices(kid.q);
  ASSERT_EQ(M.size(), size * size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(M[i * size + j], M[j * size + i], 1e-12);
  }
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(M[i * size + i], kid.kinematics.mass(), 1e-12);
  const Vector3 c = kid.kinematics.centers_of_mass(kid.q).at(0);
  EXPECT_NEAR(M[0 * size + 4], -kid.kinematics.mass() * c.z, 1e-12);  // m [c]x
  EXPECT_NEAR(M[0 * size + 5], kid.kinematics.mass() * c.y, 1e-12);
  const std::vector<double> with = kid.kinematics.inverse_dynamics(kid.q, kid.v, kid.a);
  const std::vector<double> without = kid.kinematics.inverse_dynamics(kid.q, kid.v, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    double torque = 0;
    for (std::size_t j = 0; j < n; ++j) torque += M[(i + 6) * size + j + 6] * kid.a[j];
    EXPECT_NEAR(with[i] - without[i], torque, 1e-12);
  }
}

TEST(ApiKinematics, GravityIsTheSlopeOfThePotentialEnergy) {
  Kid kid;
  const std::vector<double> zeros(kid.q.size());
  const Vector3 g{1.5, -2, -9};
  const std::vector<double> torque = kid.kinematics.inverse_dynamics(kid.q, zeros, zeros, g);
  const auto energy = [&](const std::vector<double>& q) {
    const Vector3 c = kid.kinematics.centers_of_mass(q).at(0);
    return -kid.kinematics.mass() * (g.x * c.x + g.y * c.y + g.z * c.z);
  };
  const double h = 1e-6;
  for (std::size_t i = 0; i < kid.q.size(); ++i) {
    std::vector<double> up = kid.q, down = kid.q;
    up[i] += h;
    down[i] -= h;
    EXPECT_NEAR(torque[i], (energy(up) - energy(down)) / (2 * h), 1e-7) << i;
  }
}

TEST(ApiKinematics, RowsAreWorkedOutEachByItself) {
  Kid kid;
  std::vector<double> rows = kid.q, v = kid.v, a = kid.a;
  rows.insert(rows.end(), kid.a.begin(), kid.a.end());
  v.insert(v.end(), kid.q.begin(), kid.q.end());
  a.insert(a.end(), kid.v.begin(), kid.v.end());
  const std::vector<double> both = kid.kinematics.inverse_dynamics(rows, v, a);
  const std::vector<double> second = kid.kinematics.inverse_dynamics(kid.a, kid.q, kid.v);
  EXPECT_EQ(std::vector<double>(both.begin() + static_cast<std::ptrdiff_t>(kid.q.size()), both.end()), second);
  EXPECT_EQ(kid.kinematics.jacobians(rows, "head").size(), 2 * 6 * kid.q.size());
  rows.pop_back();
  EXPECT_THROW((void)kid.kinematics.poses(rows, "head"), InputError);
  EXPECT_THROW((void)kid.kinematics.poses(kid.q, "haed"), UnknownName);
  EXPECT_THROW((void)kid.kinematics.inverse_dynamics(kid.q, kid.v, {}), InputError);
}

}  // namespace
}  // namespace murosimf::api
