/// urdf_robots_test - robots of teams are read unchanged, without leniency.
#include "tests/robot_data.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

struct Counts {
  std::size_t joints = 0, collisions = 0, visuals = 0;
  double mass = 0;  ///< [kg]
};

Counts counts_of(const robot_formats::RobotDescription& description) {
  Counts counts;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    counts.joints += body.joints.size();
    counts.visuals += body.visuals.size();
    counts.collisions +=
        static_cast<std::size_t>(std::ranges::count_if(body.shapes, [](const robot_formats::ShapeDescription& shape) {
          return shape.placed.collides;
        }));
    counts.mass += body.solid.mass;
  }
  return counts;
}

// Numbers below are counted with grep, and masses summed, in the files themselves.
TEST(UrdfRobots, BoosterK1) {
  if (!std::filesystem::exists(k1_urdf())) GTEST_SKIP() << k1_urdf() << " is not there";
  const robot_formats::RobotDescription description = robot_formats::urdf::read_urdf(k1_urdf());
  const Counts counts = counts_of(description);
  EXPECT_EQ(description.bodies.size(), 23u);
  EXPECT_EQ(counts.joints, 22u);
  EXPECT_EQ(counts.collisions, 20u);
  EXPECT_EQ(counts.visuals, 24u);
  EXPECT_NEAR(counts.mass, 19.666, 1e-9);
  EXPECT_EQ(description.meshes.size(), 24u);
  EXPECT_FALSE(any_contains(description.warnings, "there is no mesh"));
}

TEST(UrdfRobots, WolfgangOp) {
  if (!std::filesystem::exists(wolfgang_urdf())) GTEST_SKIP() << wolfgang_urdf() << " is not there";
  const robot_formats::RobotDescription description = robot_formats::urdf::read_urdf(wolfgang_urdf());
  const Counts counts = counts_of(description);
  EXPECT_EQ(description.bodies.size(), 47u);
  EXPECT_EQ(counts.joints, 20u);
  EXPECT_EQ(counts.collisions, 293u);
  EXPECT_EQ(counts.visuals, 133u);
  EXPECT_NEAR(counts.mass, 6.1167, 1e-4);
  EXPECT_EQ(description.sensors.size(), 2u);
  EXPECT_FALSE(any_contains(description.warnings, "there is no mesh"));
  EXPECT_TRUE(any_contains(description.warnings, "camera_optical_frame"));
}

}  // namespace
}  // namespace murosimf::robot
