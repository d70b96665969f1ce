/// urdf_mistakes_test - every error in a URDF file is one line with its place and a correction.
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;

struct Error {
  const char* name;
  std::string text;
  int line;          ///< that the message names
  const char* says;  ///< part of the message
};

void PrintTo(const Error& error, std::ostream* stream) { *stream << error.name; }

class UrdfMistake : public testing::TestWithParam<Error> {};

TEST_P(UrdfMistake, IsOneLineThatSaysWhere) {
  const Error& error = GetParam();
  const std::string what = message(error.text);
  EXPECT_TRUE(contains(what, "robot.urdf:" + std::to_string(error.line) + ": ")) << what;
  EXPECT_TRUE(contains(what, error.says)) << what;
  EXPECT_FALSE(contains(what, "\n")) << what;
}

std::string inertial(const std::string& mass, const std::string& tensor) {
  return with_link("<inertial><mass value='" + mass + "'/><inertia " + tensor + "/></inertial>");
}

std::string two_limbs(const std::string& first, const std::string& second) {
  return robot_xml(link("a", solid()) + link("b", solid()) + joint("revolute", "base", "a", any_limit + first, "ja") +
                   joint("revolute", "a", "b", any_limit + second, "jb"));
}

std::vector<Error> errors() {
  const std::string unit = "ixx='1' iyy='1' izz='1'";
  return {
      {"Truncated", "<robot name='r'>\n<link name='a'>\n<visual>", 3, "not well-formed XML"},
      {"Empty", "", 1, "not well-formed XML"},
      {"OtherRoot", "<mujoco/>", 1, "not <robot>"},
      {"NoLink", "<robot name='r'></robot>", 1, "there is no link"},
      {"LinkWithoutName", "<robot name='r'>\n<link/></robot>", 2, "<link> without name"},
      {"TwoLinksOfOneName", robot_xml(link("base")), 2, "link 'base' is already there"},
      {"TwoJointsOfOneName",
       robot_xml(link("a") + link("b") + joint("fixed", "base", "a") + joint("fixed", "base", "b")), 5,
       "joint 'j' is already there"},
      {"UnknownParent", robot_xml(link("limb") + joint("fixed", "bas", "limb")), 3,
       "unknown link 'bas'; did you mean 'base'?"},
      {"UnknownChild", robot_xml(link("limb") + joint("fixed", "base", "limp")), 3, "unknown link 'limp'"},
      {"NoParent", robot_xml(link("limb") + "<joint name='j' type='fixed'><child link='limb'/></joint>"), 3,
       "<joint> without <parent>"},
      {"ParentOfItself", robot_xml(link("limb") + joint("fixed", "limb", "limb")), 3, "to itself"},
      {"TwoParents",
       robot_xml(link("a") + link("b") + joint("fixed", "base", "a", "", "j1") + joint("fixed", "base", "b", "", "j2") +
                 joint("fixed", "b", "a", "", "j3")),
       6, "two parents, by joints 'j1' and 'j3'"},
      {"Circle",
       "<robot name='r'>\n" + link("a") + link("b") + joint("fixed", "a", "b", "", "j1") +
           joint("fixed", "b", "a", "", "j2") + "</robot>",
       5, "circle"},
      {"CircleBesideTheRobot",
       robot_xml(link("a") + link("b") + joint("fixed", "a", "b", "", "j1") + joint("fixed", "b", "a", "", "j2")), 5,
       "does not reach"},
      {"TwoRoots", robot_xml(link("limb")), 2, "'limb' is a second root beside 'base'"},
      {"UnknownType", with_joint("revolut", any_limit), 3, "unknown type of joint 'revolut'; did you mean 'revolute'?"},
      {"NoType", robot_xml(link("limb") + "<joint name='j'><parent link='base'/><child link='limb'/></joint>"), 3,
       "<joint> without type"},
      {"Planar", with_joint("planar", ""), 3, "planar joint 'j' is not supported"},
      {"FloatingInside", with_joint("floating", ""), 3, "only its base may float"},
      {"ZeroAxis", with_joint("revolute", any_limit + "<axis xyz='0 0 0'/>"), 3, "axis of joint 'j' has no direction"},
      {"ShortAxis", with_joint("revolute", any_limit + "<axis xyz='0 1'/>"), 3, "write 3 finite numbers"},
      {"NoLimit", with_joint("revolute", ""), 3, "make it continuous"},
      {"NoLimitOfPrismatic", with_joint("prismatic", ""), 3, "prismatic joint 'j' has no limit"},
      {"LimitsUpsideDown", with_joint("revolute", "<limit lower='1' upper='-1' effort='1' velocity='1'/>"), 3,
       "swap them"},
      {"NegativeEffort", with_joint("revolute", "<limit lower='0' upper='1' effort='-1' velocity='1'/>"), 3,
       "effort of <limit> is negative"},
      {"NegativeDamping", with_joint("continuous", "<dynamics damping='-1'/>"), 3, "damping of <dynamics> is negative"},
      {"NotANumber", with_joint("continuous", "<origin xyz='0 0 nan'/>"), 3, "'0 0 nan'; write 3 finite numbers"},
      {"Infinite", inertial("inf", unit), 2, "'inf'; write one finite number"},
      {"TooLarge", inertial("1e999", unit), 2, "'1e999'; write one finite number"},
      {"Words", inertial("heavy", unit), 2, "'heavy'; write one finite number"},
      {"NegativeMass", inertial("-1", unit), 2, "mass -1 kg of link 'base' is negative"},
      {"NoMass", with_link("<inertial><inertia ixx='1' iyy='1' izz='1'/></inertial>"), 2, "<inertial> without <mass>"},
      {"NoInertia", with_link("<inertial><mass value='1'/></inertial>"), 2, "<inertial> without <inertia>"},
      {"TwoInertials", with_link("<inertial/>\n<inertial/>"), 3, "second <inertial>"},
      {"NoGeometry", with_link("<collision/>"), 2, "<collision> without <geometry>"},
      {"EmptyGeometry", with_link(collision_xml("")), 2, "<geometry> is empty"},
      {"TwoShapes", with_link(collision_xml("<sphere radius='1'/><sphere radius='1'/>")), 2, "second shape"},
      {"NegativeRadius", with_link(collision_xml("<sphere radius='-1'/>")), 2, "radius of <sphere> is -1"},
      {"FlatBox", with_link(collision_xml("<box size='1 1 0'/>")), 2, "more than 0"},
      {"UnknownShape", with_link(collision_xml("<bocks size='1 1 1'/>")), 2, "unknown element in geometry 'bocks'"},
      {"UnsupportedShape", with_link(collision_xml("<ellipsoid/>")), 2, "element 'ellipsoid' is not supported"},
      {"UnknownAttribute", with_link(collision_xml("<sphere radis='1'/>")), 2, "did you mean 'radius'?"},
      {"ElementInTheWrongPlace", with_link("<mass value='1'/>"), 2, "unknown element in link 'mass'"},
      {"MovedCollision", robot_xml("<gazebo reference='base'><collision><pose>0 0 1 0 0 0</pose></collision></gazebo>"),
       2, "<pose> of a collision in a gazebo block"},
      {"NegativeFrictionOfContact", with_link("<contact><lateral_friction value='-1'/></contact>"), 2,
       "value of <lateral_friction> is negative"},
      {"UnknownElement", with_joint("continuous", "<limmit/>"), 3, "did you mean 'limit'?"},
      {"MissingMesh", with_link(collision_xml("<mesh filename='gone.stl'/>")), 2, "there is no mesh file 'gone.stl'"},
      {"MissingPackage", with_link(collision_xml("<mesh filename='package://gone/a.stl'/>")), 2,
       "folder of package 'gone'"},
      {"LeaderOfItself", two_limbs("", "<mimic joint='jb'/>"), 5, "mimicking itself"},
      {"LeadersInACircle", two_limbs("<mimic joint='jb'/>", "<mimic joint='ja'/>"), 4, "mimicking itself"},
      {"FloatingLeader",
       "<robot name='r'><link name='world'/><link name='a'/>\n" + link("b", solid()) +
           joint("floating", "world", "a", "", "ja") + joint("continuous", "a", "b", "<mimic joint='ja'/>", "jb") +
           "</robot>",
       4, "which is floating"},
      {"MacroElement", "<robot name='r' xmlns:xacro='x'>\n<xacro:property name='a' value='1'/></robot>", 2,
       "expand it first"},
      {"MacroInANumber", inertial("${m}", unit), 2, "expand it first"},
      {"MacroInAName", with_link(collision_xml("<mesh filename='$(arg a)/b.stl'/>")), 2, "expand it first"},
      {"Kinematic", robot_xml("<gazebo reference='base'><kinematic>true</kinematic></gazebo>"), 2,
       "<kinematic> true in a gazebo block"},
      {"InjectedLink", robot_xml("<gazebo><link/></gazebo>"), 2, "write it as URDF"},
      {"NegativeFriction", robot_xml("<gazebo reference='base'><mu1>-1</mu1></gazebo>"), 2, "<mu1> is negative"},
      {"CompilerOption", robot_xml("<mujoco><compiler settotalmass='1'/></mujoco>"), 2,
       "'settotalmass' of compiler is not supported"},
  };
}

INSTANTIATE_TEST_SUITE_P(Urdf, UrdfMistake, testing::ValuesIn(errors()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(UrdfMistakes, AMissingFileIsNamed) { EXPECT_THROW((void)read_urdf(test_folder() / "gone.urdf"), SetupError); }

TEST(UrdfMistakes, CountsWhatElseIsUnknown) {
  EXPECT_TRUE(contains(message(with_link("<colision/><colision/><inertail/>")), "and 2 more like this"));
}

TEST(UrdfMistakes, SayHowTheFileIsReadNevertheless) {
  EXPECT_TRUE(contains(message(with_link("<colision/>")), "(--lenient reads on)"));
  EXPECT_TRUE(contains(message(robot_xml("<gazebo><link/></gazebo>")), "(--lenient reads on)"));
}

TEST(UrdfMistakes, AreWarningsIfLenientWhereARobotRemains) {
  const auto wide =
      read(with_joint("revolute", "<limit lowr='-1' upper='1' effort='1' velocity='1'/>"), {.lenient = true});
  ASSERT_TRUE(wide.bodies.at(1).joints.at(0).range);
  EXPECT_EQ(wide.bodies[1].joints[0].range->x, 0);
  EXPECT_TRUE(any_contains(wide.warnings, "did you mean 'lower'?"));
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
