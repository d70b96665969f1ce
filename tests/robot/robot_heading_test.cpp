/// robot_heading_test - robots that do not face x of their base are the same robots, turned.
#include "murosimf/robot/robot_heading.h"

#include <cmath>

#include "murosimf/robot/robot_conversion.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"
#include "tests/biped_urdf.h"
#include "tests/robot/same_model.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using robot_formats::urdf::urdf_files::any_contains;
using robot_formats::urdf::urdf_files::test_folder;
using robot_formats::urdf::urdf_files::write;

/// The biped below a base without mass of its own, turned by quarters of a turn against it.
std::filesystem::path turned_biped(int quarters) {
  std::string text = fixtures::biped_urdf({});
  const std::string head = "<robot name='biped'>";
  text.insert(head.size(), fmt::format("<link name='root'/><joint name='turn' type='fixed'><parent link='root'/><child "
                                       "link='pelvis'/><origin rpy='0 0 {}'/></joint>",
                                       quarters * pi / 2));
  return write(fmt::format("turned_{}.urdf", quarters), text);
}

/// [m] Of an object, in the frame of the base, all joints bent.
Vec3d place_of(const Model& model, const std::string& name) {
  return same_model::bent(model).r[static_cast<std::size_t>(model.object_index(name))];
}

TEST(RobotHeading, IsThatOfTheHips) {
  const RobotFile straight = read_robot(turned_biped(0));
  EXPECT_FALSE(any_contains(straight.notes, "by names of left and right"));
  for (int quarters = 1; quarters < 4; ++quarters) {
    const RobotFile turned = read_robot(turned_biped(quarters));
    for (const char* name : {"l_foot", "r_foot", "l_foot.sole", "r_shin", "trunk", "pelvis"}) {
      EXPECT_LT(fixtures::difference(place_of(*turned.model, name), place_of(*straight.model, name)), 1e-12)
          << name << ' ' << quarters;
    }
    const auto sole = turned.model->object_index("l_foot.sole");
    EXPECT_NEAR(turned.model->find(properties::sole, sole)->half_length, 0.115, 1e-12);
    EXPECT_TRUE(any_contains(turned.notes, "of its base 'root': here the base is turned, so that x is forward"));
  }
  EXPECT_TRUE(any_contains(read_robot(turned_biped(2)).notes, "the robot faces -x of its base"));
}

TEST(RobotHeading, StaysWhereFeetSayOtherwise) {
  std::string text = fixtures::biped_urdf({});
  for (std::size_t at = text.find("'l_"); at != std::string::npos; at = text.find("'l_", at)) text[at + 1] = 'L';
  for (std::size_t at = text.find("'r_"); at != std::string::npos; at = text.find("'r_", at)) text[at + 1] = 'l';
  for (std::size_t at = text.find("'L_"); at != std::string::npos; at = text.find("'L_", at)) text[at + 1] = 'r';
  const RobotFile robot = read_robot(write("swapped.urdf", text));
  EXPECT_TRUE(any_contains(robot.warnings, "the robot faces -x, by its feet it does not; it is taken to face x"));
  EXPECT_GT(place_of(*robot.model, "r_yaw").y, 0);
}

// The written file faces as the original, and is turned again when it is read.
TEST(RobotHeading, IsThatOfTheFileAfterAConversion) {
  const auto file = turned_biped(2);
  const RobotConversion conversion = convert_robot(file, {.folder = test_folder()});
  const RobotFile before = read_robot(file), after = read_robot(write("converted.xml", conversion.text));
  for (const char* name : {"l_foot", "r_foot", "trunk"}) {
    EXPECT_LT(fixtures::difference(place_of(*after.model, name), place_of(*before.model, name)), 1e-12) << name;
  }
  const auto places = [](const RobotFile& robot) {
    return robot.model->placement(robot.model->object_index("l_foot.sole"));
  };
  EXPECT_LT(fixtures::difference(places(after).turn, places(before).turn), 1e-12);
  EXPECT_TRUE(any_contains(after.notes, "the robot faces -x of its base"));
}

// 5 s at 0.15 m/s and less while it starts: forward is where the scene has it face, whatever the file's axes are.
TEST(RobotHeading, IsWhereItWalks) {
  const auto scene =
      write("scene.toml", fmt::format("[[robots]]\nname = 'a'\nmodel = '{}'\nlevel = 'kinematic_walking'\n"
                                      "controller = 'walk'\ncommand = [0.15, 0, 0]\nsensors = false\n",
                                      turned_biped(2).string()));
  scene::Scene there(scene.string());
  there.simulation().run(std::chrono::seconds(5));
  const Vec3d r = there.simulation().world().entity("a").base().get(properties::position);
  EXPECT_GT(r.x, 0.4);
  EXPECT_NEAR(r.y, 0, 0.1);
}

}  // namespace
}  // namespace murosimf::robot
