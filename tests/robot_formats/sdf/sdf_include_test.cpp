/// sdf_include_test - models that others include, and models in worlds.
#include "murosimf/robot_formats/sdf/sdf_include.h"

#include "tests/robot_formats/sdf/sdf_files.h"

namespace murosimf::robot_formats::sdf {
namespace {

using namespace sdf_files;

class SdfInclude : public SdfTest {
 protected:
  void SetUp() override {
    SdfTest::SetUp();
    write("leg/model.config",
          "<model><name>leg</name><sdf version='1.4'>old.sdf</sdf><sdf version='1.9'>new.sdf</sdf></model>");
    write("leg/new.sdf", model(link("foot", "<pose>0 0 -1 0 0 0</pose>") + link("toe", "<pose>1 0 -1 0 0 0</pose>") +
                                   joint("revolute", "foot", "toe", "<axis><xyz>0 1 0</xyz></axis>", "hinge"),
                               "leg"));
    write("leg/old.sdf", "this is not read");
    write("plain/model.sdf", model(link("box"), "plain"));
  }
};

TEST_F(SdfInclude, StandsWhereItsPoseSaysUnderItsName) {
  const auto robot =
      read(model(link("a") + "<include><uri>model://leg</uri><name>left</name><pose>0 1 0 0 0 0</pose></include>" +
                 "<include><uri>leg</uri><name>right</name><pose>0 -1 0 0 0 0</pose></include>" +
                 joint("fixed", "a", "left::foot", "", "l") + joint("fixed", "a", "right::foot", "", "r")));
  ASSERT_EQ(robot.bodies.size(), 5u);
  expect_near(place_in_base(robot, "left::toe").position, {1, 1, -1});
  expect_near(place_in_base(robot, "right::toe").position, {1, -1, -1});
  EXPECT_EQ(robot.bodies.at(2).joints.at(0).name, "left::hinge");
  EXPECT_TRUE(contains(robot.bodies[2].where, "new.sdf:3")) << robot.bodies[2].where;
}

TEST_F(SdfInclude, MergesItsLinks) {
  const auto robot = read(model(link("a") + "<include merge='true'><uri>leg</uri><pose>0 1 0 0 0 0</pose></include>" +
                                joint("fixed", "a", "foot", "", "l")));
  expect_near(place_in_base(robot, "toe").position, {1, 1, -1});
  EXPECT_TRUE(robot.bodies.at(0).frames.empty());
}

TEST_F(SdfInclude, TakesTheFileOfAFolder) {
  const auto robot =
      read(model(link("a") + "<include><uri>plain/model.sdf</uri></include>" + joint("fixed", "a", "plain::box")));
  EXPECT_EQ(robot.bodies.at(1).name, "plain::box");
}

TEST_F(SdfInclude, IncludesWhatIncludes) {
  write("outer/model.sdf",
        model(link("m") + "<include><uri>model://leg</uri></include>" + joint("fixed", "m", "leg::foot"), "outer"));
  const auto robot =
      read(model(link("a") + "<include><uri>outer</uri></include>" + joint("fixed", "a", "outer::m", "", "k")));
  EXPECT_EQ(robot.bodies.back().name, "outer::leg::toe");
}

TEST_F(SdfInclude, RefusesWhatIsNotThereAndWhatIncludesItself) {
  EXPECT_TRUE(contains(message(model(link("a") + "<include><uri>model://nowhere</uri></include>")),
                       "robot.sdf:3: there is no model 'model://nowhere'"));
  write("self/model.sdf", model(link("a") + "<include><uri>self</uri><name>again</name></include>", "self"));
  write("self/self/model.sdf", "");
  const std::string said = message(model("<include><uri>robot.sdf</uri><name>again</name></include>" + link("a")));
  EXPECT_TRUE(contains(said, "does one include itself?")) << said;
}

TEST_F(SdfInclude, TakesTheRobotOfAWorld) {
  const std::string world =
      "<sdf version='1.9'><world name='w'><include><uri>model://ground_plane</uri></include>\n"
      "<physics name='p' type='ode'/><model name='house'><static>true</static>" +
      link("wall") +
      "</model>\n"
      "<include><uri>model://leg</uri><name>robot</name></include></world></sdf>";
  const auto robot = read(world);
  EXPECT_EQ(robot.name, "robot");
  EXPECT_EQ(robot.bodies.size(), 2u);
  EXPECT_EQ(robot.bodies.at(1).name, "toe");
  EXPECT_TRUE(names_unused(robot, "model 'house' of the world is not read"));
  EXPECT_TRUE(names_unused(robot, "there is no model 'model://ground_plane'"));
  EXPECT_TRUE(names_unused(robot, "element 'physics' is not used"));
  EXPECT_FALSE(robot.fixed_base);
}

TEST_F(SdfInclude, BoltsWhatTheFileHoldsInTheWorld) {
  const auto held = read(model(link("a", "<pose>0 0 1 0 0 0</pose>") + joint("fixed", "world", "a")));
  EXPECT_TRUE(held.fixed_base);
  EXPECT_EQ(held.bodies.at(0).name, "world");
  expect_near(held.bodies.at(1).place.position, {0, 0, 1});
  const auto fixed = read(model("<static>true</static>" + link("a")));
  EXPECT_TRUE(fixed.fixed_base);
}

}  // namespace
}  // namespace murosimf::robot_formats::sdf
