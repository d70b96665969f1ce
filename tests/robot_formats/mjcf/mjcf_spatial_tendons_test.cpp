/// mjcf_spatial_tendons_test - paths of spatial tendons, and tendons that are tied, against lengths computed by hand.
#include "murosimf/robot_formats/mjcf/mjcf_spatial_tendons.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/robot_formats/mjcf/mjcf_reader.h"
#include "murosimf/robot_formats/tendon_path.h"
#include "tests/description_checks.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

using description_checks::any_contains;

/// A base with the site a at the origin and a wheel of radius 1 there about y; hinge i in the origin with the site b at (3, 0, 0), on it a
/// slide k along x with the site c at (4, 0, 0).
robot_formats::RobotDescription read(const std::string& tendons, const std::string& after = "",
                                     const std::string& of_i = "", const std::string& of_k = "") {
  const auto file = fixtures::temp_folder() / "strings.xml";
  std::ofstream(file)
      << "<mujoco><compiler angle='radian'/><worldbody><site name='outside'/><body name='base'><freejoint/>"
         "<geom name='box' type='box' size='.1 .1 .1'/><site name='a'/><site name='up' pos='0 0 2'/>"
         "<site name='left' pos='-3 0 .5'/>"
         "<geom name='wheel' type='cylinder' size='1 .1' euler='1.5707963267948966 0 0'/>"
         "<body name='l'><joint name='i' axis='0 1 0' "
      << of_i << "/><geom size='.1'/><site name='b' pos='3 0 0'/><body><joint name='k' type='slide' axis='1 0 0' "
      << of_k << "/><geom size='.1'/><site name='c' pos='4 0 0'/></body></body></body></worldbody><tendon>" << tendons
      << "</tendon>" << after << "</mujoco>";
  return read_mjcf(file);
}

std::string spatial(const std::string& path, const std::string& attributes = "stiffness='5'") {
  return "<spatial name='t' " + attributes + ">" + path + "</spatial>";
}
std::string site(const std::string& name) { return "<site site='" + name + "'/>"; }

double length_of(const std::string& path) {
  const auto robot = read(spatial(path));
  EXPECT_EQ(robot.tendons.size(), 1U);
  return robot.tendons.empty() ? 0 : robot.tendons[0].joint.reference;
}

TEST(MjcfSpatialTendons, AreAsLongAsTheirPath) {
  EXPECT_NEAR(length_of(site("a") + site("b") + site("c")), 4, 1e-12);
  EXPECT_NEAR(length_of(site("a") + site("b") + "<pulley divisor='2'/>" + site("b") + site("c") + site("up")),
              3 + (1 + std::hypot(4, 2)) / 2, 1e-12);
  EXPECT_NEAR(length_of("<pulley divisor='4'/>" + site("a") + site("b")), 0.75, 1e-12);
  // between left and b the line is 0.25 above the axis at most; tangents and the arc between them
  const double d = std::hypot(3, 0.5), tangents = std::acos(1 / d) + std::acos(1 / 3.0);
  const double turn = pi - std::atan2(0.5, 3), straight = std::sqrt(d * d - 1) + std::sqrt(8.0);
  EXPECT_NEAR(length_of(site("left") + "<geom geom='wheel'/>" + site("b")), straight + turn - tangents, 1e-9);
  EXPECT_NEAR(length_of(site("left") + "<geom geom='wheel' sidesite='up'/>" + site("b")), straight + turn - tangents,
              1e-9);
}

TEST(MjcfSpatialTendons, HaveSlidersWithWhatActsAlongThem) {
  const auto robot = read(spatial(site("a") + site("c"),
                                  "stiffness='5' damping='.3' frictionloss='.7' armature='.01' "
                                  "range='1 6' limited='true'"),
                          "<actuator><position name='p' tendon='t' kp='10' ctrlrange='2 5'/></actuator>", "ref='.4'",
                          "springref='.5'");
  ASSERT_EQ(robot.tendons.size(), 1U);
  const auto& slider = robot.tendons[0].joint;
  EXPECT_EQ(slider.kind, Kind::prismatic);
  EXPECT_NEAR(slider.reference, 4, 1e-12);
  EXPECT_EQ(slider.stiffness, 5);
  EXPECT_NEAR(slider.spring_reference, 4.5, 1e-12) << "where the joints' springs are slack";
  EXPECT_EQ(slider.damping, .3);
  EXPECT_EQ(slider.friction, .7);
  EXPECT_EQ(slider.armature, .01);
  EXPECT_EQ(slider.range->y, 6);
  ASSERT_TRUE(slider.servo);
  EXPECT_EQ(slider.servo->position_gain, 10);
  EXPECT_EQ(joints_of(robot, robot.tendons[0]), (std::vector<std::string>{"i", "k"}));
  EXPECT_FALSE(any_contains(robot.warnings, "tendon")) << "it acts";
}

TEST(MjcfSpatialTendons, OutsideOfTheRobotDoNotAct) {
  const auto robot = read(spatial(site("outside") + site("b")),
                          "<actuator><motor name='p' tendon='t'/></actuator>"
                          "<equality><tendon tendon1='t'/></equality>");
  EXPECT_TRUE(robot.tendons.empty());
  EXPECT_TRUE(any_contains(robot.warnings, "tendon 't' does not act: spring"));
  EXPECT_TRUE(any_contains(robot.warnings, "actuator 'p' moves nothing: it acts on a tendon"));
  EXPECT_TRUE(any_contains(robot.warnings, "tendon of 't' does not act"));
}

TEST(MjcfSpatialTendons, MistakesAreNamed) {
  const auto complaint = [](const std::string& path) { return fixtures::error_of([&] { (void)read(spatial(path)); }); };
  EXPECT_TRUE(fixtures::says(complaint(site("a") + site("d")), {"strings.xml:1", "'d'", "site"}));
  EXPECT_TRUE(fixtures::says(complaint(site("a")), {"a branch of a spatial tendon needs two sites"}));
  EXPECT_TRUE(fixtures::says(complaint("<geom geom='wheel'/>" + site("a")), {"needs a site before each geom"}));
  EXPECT_TRUE(fixtures::says(complaint(site("a") + "<geom geom='wheel'/>"), {"needs a site behind each geom"}));
  EXPECT_TRUE(fixtures::says(complaint(site("a") + site("b") + "<pulley divisor='0'/>" + site("a") + site("b")),
                             {"divisor of pulley must be more than 0"}));
  for (const char* geom : {"box", "wheal"}) {
    EXPECT_TRUE(fixtures::says(complaint(site("a") + "<geom geom='" + geom + "'/>" + site("b")),
                               {"is no sphere or cylinder of the robot"}));
  }
}

// A tendon that an equality holds is a slider, even if it could act at its one joint.
TEST(MjcfTendonTies, HoldLengths) {
  const std::string two =
      "<fixed name='t'><joint joint='i' coef='2'/></fixed><fixed name='u'><joint joint='k' "
      "coef='1'/><joint joint='i' coef='1'/></fixed>";
  const auto tied = read(two, "<equality><tendon tendon1='t' tendon2='u' polycoef='.1 .2 .3'/></equality>");
  ASSERT_EQ(tied.tendons.size(), 2U);
  ASSERT_TRUE(tied.tendons[0].tie);
  EXPECT_EQ(tied.tendons[0].tie->other, "u");
  EXPECT_EQ(tied.tendons[0].tie->polynomial, (std::array<double, 5>{.1, .2, .3, 0, 0}));
  EXPECT_FALSE(tied.tendons[1].tie);
  EXPECT_TRUE(tied.warnings.empty());
  const auto alone = read(two, "<equality><tendon tendon1='t'/><tendon tendon1='u' active='false'/></equality>");
  ASSERT_EQ(alone.tendons.size(), 1U) << "the other one does nothing";
  EXPECT_EQ(alone.tendons[0].tie->other, "");
  const auto complaint = [&](const std::string& ties) {
    return fixtures::error_of([&] { (void)read(two, "<equality>" + ties + "</equality>"); });
  };
  EXPECT_TRUE(fixtures::says(complaint("<tendon tendon1='t' tendon2='v'/>"), {"strings.xml:1", "'v'"}));
  EXPECT_TRUE(fixtures::says(complaint("<tendon tendon1='t'/><tendon tendon1='t' tendon2='u'/>"),
                             {"tendon 't' is held by two equalities"}));
  EXPECT_TRUE(fixtures::says(complaint("<tendon tendon1='t' tendon2='t'/>"), {"tendon 't' is held to itself"}));
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
