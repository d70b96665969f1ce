// Places of painted numbers: on the trunk, in front of all its parts, readable from outside.
#include "murosimf/appearance/jersey_numbers.h"

#include <cmath>

#include "murosimf/files/data_path.h"
#include "murosimf/geometry/ray.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/fixtures.h"
#include "tests/robot_data.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::appearance {
namespace {

using robot_formats::urdf::urdf_files::expect_near;

struct Robot {
  explicit Robot(const std::filesystem::path& file)
      : model(robot::read_robot(file, {.guess = true}).model),
        appearance(appearance_of(*model)),
        plates(jersey_numbers(*model, appearance)) {}
  explicit Robot(const Chain& chain)
      : model(std::make_shared<const Model>("r", chain)),
        appearance(appearance_of(*model)),
        plates(jersey_numbers(*model, appearance)) {}

  ModelPtr model;
  Appearance appearance;
  std::vector<JerseyNumber> plates;
};

/// The first hit of a ray against the plate's normal, through a point of the plate, before the plate or within
/// 20 cm behind it.
struct Covered {
  int in_front = 0, bare = 0, points = 0;
};

/// Distance of the triangle on the ray; infinite if it misses.
double meet(const geometry::Ray& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d normal = cross(b - a, c - a);
  const double speed = dot(ray.direction, normal);
  const double t = dot(a - ray.origin, normal) / speed;
  const Vec3d p = ray.origin + t * ray.direction;
  const double u = dot(cross(b - a, p - a), normal), v = dot(cross(c - b, p - b), normal),
               w = dot(cross(a - c, p - c), normal);
  return speed != 0 && u >= 0 && v >= 0 && w >= 0 ? t : INFINITY;
}

/// Of visible parts on the plate's own object.
Covered look_at(const Robot& robot, const JerseyNumber& plate) {
  const Vec3d out = cross(plate.right, plate.up);
  Covered covered;
  for (double u = -0.97; u < 1; u += 0.1) {
    for (double v = -0.97; v < 1; v += 0.1) {
      const Vec3d p = plate.center + u * plate.half_width * plate.right + v * plate.half_height * plate.up;
      const geometry::Ray ray{p + out, -out};
      double nearest = INFINITY;
      for (const SeenShape& seen : robot.appearance.shapes) {
        if (seen.object != plate.object) continue;
        const auto entry = geometry::meet(ray, seen.placed.shape, {seen.placed.position, seen.placed.orientation});
        if (entry) nearest = std::min(nearest, entry->distance);
      }
      for (const SeenMesh& seen : robot.appearance.meshes) {
        if (seen.object != plate.object) continue;
        const auto& at = seen.mesh.vertices;
        for (const auto& [a, b, c] : seen.mesh.triangles) nearest = std::min(nearest, meet(ray, at[a], at[b], at[c]));
      }
      ++covered.points;
      covered.in_front += nearest < 1 ? 1 : 0;
      covered.bare += nearest > 1.2 ? 1 : 0;
    }
  }
  return covered;
}

/// `most_bare`: share of a plate behind which the robot may have holes.
void expect_good_plates(const Robot& robot, const std::string& object, double most_bare = 0.25) {
  ASSERT_EQ(robot.plates.size(), 2U);
  for (const JerseyNumber& plate : robot.plates) {
    EXPECT_EQ(plate.object, robot.model->object_index(object));
    EXPECT_NEAR(norm(plate.right), 1, 1e-12);
    EXPECT_NEAR(dot(plate.right, plate.up), 0, 1e-12);
    EXPECT_LE(plate.half_height, plate.half_width * (1 + 1e-12));
    EXPECT_LE(plate.half_width, 1.5 * plate.half_height * (1 + 1e-12));
    EXPECT_GT(plate.half_height, 0.02) << "large enough to be read";
    const Covered covered = look_at(robot, plate);
    EXPECT_EQ(covered.in_front, 0) << "nothing hides the number";
    EXPECT_LT(covered.bare, most_bare * covered.points) << "the robot is behind it";
  }
  const Vec3d chest = cross(robot.plates[0].right, robot.plates[0].up);
  const Vec3d back = cross(robot.plates[1].right, robot.plates[1].up);
  expect_near(chest, -back);
  EXPECT_GT(dot(robot.plates[0].center - robot.plates[1].center, chest), 0.05) << "the trunk is between them";
}

TEST(JerseyNumbers, OfKid21AreOnItsTorso) {
  const Robot robot(files::find_data_file("kid21", "models", ".xml"));
  expect_good_plates(robot, "torso");
  // a box of half 0.05 x 0.065 x 0.07 m at a height of 0.08 m
  expect_near(robot.plates[0].center, {0.051, 0, 0.08});
  expect_near(robot.plates[1].center, {-0.051, 0, 0.08});
  expect_near(robot.plates[0].right, {0, 1, 0});
  expect_near(robot.plates[0].up, {0, 0, 1});
  EXPECT_NEAR(robot.plates[0].half_width, 0.039, 1e-12);
  EXPECT_NEAR(robot.plates[0].half_height, 0.039, 1e-12);
}

TEST(JerseyNumbers, OfTheLeaguesRobotAreOnItsTorso) {
  expect_good_plates(Robot(files::find_data_file("spark_nao0", "models", ".xml")), "torso");
}

TEST(JerseyNumbers, OfBoosterK1AreOnItsTrunk) {
  if (!std::filesystem::exists(k1_mjcf())) GTEST_SKIP() << "no " << k1_mjcf();
  expect_good_plates(Robot(k1_mjcf()), "Trunk");
}

TEST(JerseyNumbers, OfWolfgangOpAreOnItsTorso) {
  if (!std::filesystem::exists(wolfgang_urdf())) GTEST_SKIP() << "no " << wolfgang_urdf();
  const robot::RobotFile file = robot::read_robot(wolfgang_urdf(), {.lenient = true});
  expect_good_plates(Robot(wolfgang_urdf()), file.model->objects()[0].name, 0.6);  // its trunk is an open frame
}

Chain with_shape(Chain chain, const Shape& shape) {
  return chain.with(properties::mass, 1.0)
      .with(properties::inertia, {1, 1, 1, 0, 0, 0})
      .with(properties::shapes, {fixtures::placed(shape)});
}

TEST(JerseyNumbers, LookForwardOnALinkThatIsTurned) {
  // the trunk's own x points to the left, its z forward
  const Mat3d turn{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  Chain arm = Chain{}.revolute("arm", {0, 1, 0}), head = Chain{}.revolute("head", {0, 0, 1});
  Chain trunk = with_shape(Chain{}.rotation(turn).revolute("waist", {0, 1, 0}), Box{{0.2, 0.3, 0.1}});
  trunk.fork(with_shape(arm, Sphere{0.05}), with_shape(head, Sphere{0.05}));
  Chain robot = with_shape(Chain{}.base(), Sphere{0.05});
  const Robot turned(robot.fork({trunk}));
  expect_good_plates(turned, "waist");
  expect_near(turned.plates[0].center, {0, 0, 0.101});
  expect_near(turned.plates[0].right, {1, 0, 0});
  expect_near(turned.plates[0].up, {0, 1, 0});
  EXPECT_NEAR(turned.plates[0].half_width, 0.12, 1e-12) << "60 % of 0.4 m";
}

TEST(JerseyNumbers, OfWhatCannotBeSeenThereAreNone) {
  EXPECT_TRUE(
      Robot(Chain{}.base().with(properties::mass, 1.0).with(properties::inertia, {1, 1, 1, 0, 0, 0})).plates.empty());
}

TEST(JerseyNumbers, CarryNumbersThatFit) {
  const JerseyNumber plate{3, {1, 2, 3}, {0, -1, 0}, {0, 0, 1}, 0.3, 0.2};
  for (const int number : {4, 88, 123}) {
    double wide = 0, high = 0;
    for (const Vec3d& v : number_on(plate, number).vertices) {
      EXPECT_NEAR(v.x, 1, 1e-12);
      wide = std::max(wide, std::abs(v.y - 2)), high = std::max(high, std::abs(v.z - 3));
    }
    EXPECT_LE(wide, 0.3 + 1e-12);
    EXPECT_LE(high, 0.2 + 1e-12);
    EXPECT_TRUE(wide > 0.27 || high > 0.199) << "as large as the plate allows";
  }
}

}  // namespace
}  // namespace murosimf::appearance
