/// sdf_mistakes_test - each error in an SDF file is one line with its place; parts without effect are reported.
#include "murosimf/model/error.h"
#include "tests/robot_formats/sdf/sdf_files.h"

namespace murosimf::robot_formats::sdf {
namespace {

using namespace sdf_files;

class SdfMistakes : public SdfTest {};

void expect_message(const std::string& text, const std::string& part) {
  const std::string said = message(text);
  EXPECT_TRUE(contains(said, part)) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

TEST_F(SdfMistakes, AreToldWithTheirPlace) {
  expect_message("<sdf version='1.9'>", "robot.sdf:1: not well-formed XML");
  expect_message("<robot name='r'/>", "the root is <robot>, not <sdf>");
  expect_message("<sdf version='1.9'/>", "robot.sdf:1: there is no model in this file");
  expect_message(model(""), "robot.sdf:1: A model must have at least one link");
  expect_message(model("<link name='a'><inertial><mass>-1</mass></inertial></link>"),
                 "robot.sdf:2: <mass> of inertial is -1");
  expect_message(model("<link name='a'><inertial><mass>x</mass></inertial></link>"), "robot.sdf:2");
  expect_message(model("<link/>"), "robot.sdf:2");
  expect_message(model(link("a") + link("a")), "robot.sdf:");
  expect_message(model(link("a") + link("b")), "robot.sdf:3: link 'b' hangs on no joint");
  expect_message(model(link("a") + joint("fixed", "a", "c")), "c");
  expect_message(model(link("a") + joint("fixed", "a", "a")), "robot.sdf:");
  expect_message(pair("screw", "<axis><xyz>0 0 1</xyz></axis>"),
                 "robot.sdf:4: joint 'j' of type 'screw' is not supported");
  expect_message(pair("revolute", "<axis><xyz>0 0 1</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis>"),
                 "robot.sdf:4");
  expect_message(pair("revolute", "<pose relative_to='nowhere'/><axis><xyz>0 0 1</xyz></axis>"), "nowhere");
  expect_message(pair("revolute", "<axis><xyz expressed_in='nowhere'>0 0 1</xyz></axis>"), "nowhere");
  expect_message(model(link("a", "<collision name='s'><geometry><plane/></geometry></collision>")),
                 "element 'plane' is not supported");
  expect_message(model(link("a", "<collision name='s'><geometry><box/></geometry></collision>")),
                 "<size> of box must be three");
  expect_message(model(link("a", "<colision name='s'/>")), "robot.sdf:2: unknown element in link 'colision'");
}

TEST_F(SdfMistakes, OfCirclesOfMimicsAreTold) {
  const std::string axis = "<axis><xyz>0 0 1</xyz><mimic joint='";
  expect_message(model(link("a") + link("b") + link("c") + joint("revolute", "a", "b", axis + "k'/></axis>", "j") +
                       joint("revolute", "b", "c", axis + "j'/></axis>", "k")),
                 "ends up mimicking itself");
}

TEST_F(SdfMistakes, AreWarningsWhereTheReaderIsLenient) {
  const auto robot = read(model(link("a") + link("b")), {.lenient = true});
  EXPECT_EQ(robot.bodies.size(), 1u);
  EXPECT_TRUE(any_contains(robot.warnings, "link 'b' hangs on no joint"));
}

TEST_F(SdfMistakes, AreNoneWhereSomethingHasNoEffect) {
  const auto robot = read(model(link("a", "<enable_wind>true</enable_wind><mine:own xmlns:mine='x'/>") +
                                "<plugin filename='p' name='n'/>"));
  EXPECT_TRUE(names_unused(robot, "robot.sdf:2: element 'enable_wind' is not used"));
  EXPECT_TRUE(names_unused(robot, "unknown element 'mine:own' in link is not used"));
  EXPECT_TRUE(names_unused(robot, "robot.sdf:3: element 'plugin' is not used"));
  EXPECT_TRUE(robot.warnings.empty());
}

TEST_F(SdfMistakes, OfGravityAndKinematicLinksAreTold) {
  EXPECT_TRUE(any_contains(read(model(link("a", "<gravity>false</gravity>"))).warnings, "gravity is switched off"));
  expect_message(model(link("a", "<kinematic>true</kinematic>")), "kinematic");
}

TEST(SdfWithoutLibrary, IsSaidInOneLine) {
  if (has_sdf_program()) GTEST_SKIP() << "this build has libsdformat";
  EXPECT_TRUE(
      contains(message(model(link("a"))), "SDF files need libsdformat (libsdformat-dev), which this build has not"));
}

}  // namespace
}  // namespace murosimf::robot_formats::sdf
