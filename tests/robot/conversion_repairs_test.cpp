/// conversion_repairs_test - repaired masses are those of the written robot.
#include <filesystem>

#include <fmt/format.h>

#include "murosimf/robot/robot_conversion.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

/// Converted, written and read.
RobotFile again(const std::filesystem::path& file, WrittenFormat format) {
  const RobotConversion robot = convert_robot(file, {.folder = test_folder() / "out", .format = format});
  const std::string name = format == WrittenFormat::mjcf ? "out/again.xml" : "out/again.urdf";
  write("out/again.toml", robot.toml);
  return read_robot(write(name, robot.text));
}

/// Bodies without mass, points and inertias that are repaired, alone and as parts of others.
std::string with_repairs() {
  const auto solid = [](const char* mass, const char* moments) {
    return fmt::format("<inertial><origin xyz='0.1 0.2 0.3' rpy='0 0 1'/><mass value='{}'/><inertia {}/></inertial>",
                       mass, moments);
  };
  return robot_xml(link("part", solid("0.1", "ixx='2' iyy='3' izz='-0.01'")) +
                   link("turning", solid("0", "ixx='.1' iyy='.2' izz='.2'")) + link("cross") +
                   link("limb", solid("2", "ixx='2' iyy='3' izz='4'")) + link("nothing") +
                   link("point", solid("0.5", "ixx='0' iyy='0' izz='0'")) +
                   link("tip", solid("0.1", "ixx='0' iyy='0' izz='0'")) +
                   link("wrong", solid("1", "ixx='2' iyy='3' izz='-1'")) +
                   link("end", solid("1", "ixx='1' iyy='1' izz='1'")) + joint("fixed", "base", "part", "", "f1") +
                   joint("fixed", "base", "turning", "", "f2") + joint("continuous", "base", "cross", "", "j1") +
                   joint("continuous", "cross", "limb", "<axis xyz='0 1 0'/>", "j2") +
                   joint("continuous", "limb", "nothing", "", "j3") + joint("continuous", "limb", "point", "", "j4") +
                   joint("fixed", "point", "tip", "", "f3") + joint("continuous", "limb", "wrong", "", "j5") +
                   joint("fixed", "wrong", "end", "", "f4"));
}

void expect_same_solids(const RobotFile& found, const RobotFile& expected) {
  ASSERT_EQ(found.description.bodies.size(), expected.description.bodies.size());
  for (std::size_t i = 0; i < expected.description.bodies.size(); ++i) {
    const robot_formats::BodyDescription &is = found.description.bodies[i], &was = expected.description.bodies[i];
    const SymMat3d &I = is.solid.inertia, &J = was.solid.inertia;
    ASSERT_EQ(is.name, was.name);
    EXPECT_NEAR(is.solid.mass, was.solid.mass, 1e-12) << is.name;
    EXPECT_LT(fixtures::difference(is.solid.center, was.solid.center), 1e-12) << is.name;
    EXPECT_LT(fixtures::difference(Vec3d{I.xx, I.yy, I.zz}, {J.xx, J.yy, J.zz}), 1e-12) << is.name;
    EXPECT_LT(fixtures::difference(Vec3d{I.xy, I.xz, I.yz}, {J.xy, J.xz, J.yz}), 1e-12) << is.name;
  }
}

// 1e-12: the largest mass and moment that are written where a format needs one and there is none.
TEST(ConversionRepairs, KeepsWhatWasRepaired) {
  const auto file = write("repaired.urdf", with_repairs());
  const RobotFile before = read_robot(file);
  ASSERT_EQ(before.description.bodies.size(), 6u);
  EXPECT_EQ(before.description.bodies[1].solid.mass, 0) << "carries a limb";
  EXPECT_EQ(before.description.bodies[3].solid.mass, 1e-6) << "carries nothing";
  const RobotFile mjcf = again(file, WrittenFormat::mjcf), urdf = again(file, WrittenFormat::urdf);
  expect_same_solids(mjcf, before);
  expect_same_solids(urdf, before);
  for (const RobotFile* after : {&mjcf, &urdf}) {
    EXPECT_FALSE(any_contains(after->notes, "moves without")) << "nothing is left to repair";
    EXPECT_FALSE(any_contains(after->warnings, "positive definite"));
  }
}

TEST(ConversionRepairs, NamesInertiasThatAreEvened) {
  const auto file =
      write("odd.urdf",
            robot_xml(link("limb", "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='4'/></inertial>") +
                      joint("continuous", "base", "limb")));
  const auto left_out = convert_robot(file).left_out;
  ASSERT_EQ(left_out.size(), 1u);
  EXPECT_TRUE(fixtures::says(left_out[0], {"odd.urdf:2: inertia of body 'limb'", "2 kg m^2 is read"}));
  EXPECT_NEAR(again(file, WrittenFormat::mjcf).description.bodies.at(1).solid.inertia.zz, 2, 1e-15);
}

}  // namespace
}  // namespace murosimf::robot
