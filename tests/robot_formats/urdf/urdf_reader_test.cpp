/// urdf_reader_test - URDF files become the right description of a robot.
#include "murosimf/robot_formats/urdf/urdf_reader.h"

#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;

TEST(UrdfReader, PutsParentsBeforeChildrenInTheOrderOfTheFile) {
  const auto description = read(robot_xml(link("d") + link("c") + link("b") + link("a") +
                                          joint("fixed", "b", "c", "", "j1") + joint("fixed", "base", "a", "", "j2") +
                                          joint("fixed", "base", "b", "", "j3") + joint("fixed", "a", "d", "", "j4")));
  std::vector<std::string> names;
  for (const robot_formats::BodyDescription& body : description.bodies) names.push_back(body.name);
  EXPECT_EQ(names, (std::vector<std::string>{"base", "a", "d", "b", "c"}));
  EXPECT_EQ(description.bodies[0].parent, -1);
  EXPECT_EQ(description.bodies[2].parent, 1);
  EXPECT_EQ(description.bodies[4].parent, 3);
  EXPECT_TRUE(description.bodies[4].joints.empty());
}

TEST(UrdfReader, NamesTheRobotAfterItsFileIfItHasNoName) {
  EXPECT_EQ(read("<robot name='pelican'><link name='a'/></robot>").name, "pelican");
  EXPECT_EQ(read("<robot><link name='a'/></robot>").name, "robot");
}

TEST(UrdfReader, ReadsEveryNumberOfAJoint) {
  const auto description = read(with_joint("revolute",
                                           "<origin xyz='1 2 3'/><axis xyz='0 3 4'/>"
                                           "<limit lower='-0.5' upper='1.5' effort='7' velocity='8'/>"
                                           "<dynamics damping='0.25' friction='0.75'/>"));
  const robot_formats::BodyDescription& body = description.bodies.at(1);
  expect_near(body.place.position, {1, 2, 3});
  const robot_formats::JointDescription& joint = body.joints.at(0);
  EXPECT_EQ(joint.name, "j");
  EXPECT_EQ(joint.kind, Kind::revolute);
  expect_near(joint.axis, {0, 0.6, 0.8});
  expect_near(joint.anchor, {});
  ASSERT_TRUE(joint.range);
  expect_near(*joint.range, {-0.5, 1.5, 0});
  EXPECT_EQ(joint.effort_limit, 7);
  EXPECT_EQ(joint.rate_limit, 8);
  EXPECT_EQ(joint.damping, 0.25);
  EXPECT_EQ(joint.friction, 0.75);
  EXPECT_TRUE(joint.where.ends_with("robot.urdf:3")) << joint.where;
}

TEST(UrdfReader, TurnsAJointWithoutAxisAboutX) {
  expect_near(read(with_joint("continuous", "")).bodies.at(1).joints.at(0).axis, {1, 0, 0});
  expect_near(read(with_joint("continuous", "<axis/>")).bodies.at(1).joints.at(0).axis, {1, 0, 0});
}

TEST(UrdfReader, KnowsWhichJointsHaveARange) {
  const auto continuous = read(with_joint("continuous", any_limit)).bodies.at(1).joints.at(0);
  EXPECT_FALSE(continuous.range);
  EXPECT_EQ(continuous.effort_limit, 2);
  const auto prismatic = read(with_joint("prismatic", any_limit)).bodies.at(1).joints.at(0);
  EXPECT_TRUE(prismatic.range);
  EXPECT_EQ(prismatic.kind, Kind::prismatic);
}

TEST(UrdfReader, TurnsByRollThenPitchThenYawAboutFixedAxes) {
  // by hand: a quarter about x takes y to z, then a quarter about y takes z to x, then a quarter about z takes x to y
  const auto description =
      read(with_joint("continuous", "<origin rpy='1.5707963267948966 1.5707963267948966 1.5707963267948966'/>"));
  const Mat3d& turn = description.bodies.at(1).place.orientation;
  expect_near(turn * Vec3d{0, 1, 0}, {0, 1, 0});
  expect_near(turn * Vec3d{1, 0, 0}, {0, 0, -1});
  expect_near(turn * Vec3d{0, 0, 1}, {1, 0, 0});
}

TEST(UrdfReader, TurnsInertiaToTheAxesOfTheLink) {
  const auto description =
      read(with_link("<inertial><origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/><mass value='2'/>"
                     "<inertia ixx='1' iyy='2' izz='2.5' ixy='0.1' ixz='0.2' iyz='0.3'/></inertial>"));
  const robot_formats::MassProperties& solid = description.bodies.at(0).solid;
  EXPECT_EQ(solid.mass, 2);
  expect_near(solid.center, {1, 2, 3});
  // x of the inertial frame is y of the link, y of it is -x
  expect_near({solid.inertia.xx, solid.inertia.yy, solid.inertia.zz}, {2, 1, 2.5});
  expect_near({solid.inertia.xy, solid.inertia.xz, solid.inertia.yz}, {-0.1, -0.3, 0.2});
  EXPECT_TRUE(description.bodies[0].solid_where.ends_with("robot.urdf:2"));
}

TEST(UrdfReader, TakesLinksWithoutInertialForMassless) {
  const auto description = read(with_link(collision_xml("<box size='1 1 1'/>")));
  EXPECT_EQ(description.bodies.at(0).solid.mass, 0);
  EXPECT_TRUE(description.bodies[0].solid_where.empty());
}

TEST(UrdfReader, TakesFramesWithAWeightForPoints) {
  const auto description = read(
      robot_xml("\n" + link("tip", "<inertial><mass value='0.0001'/><inertia ixx='0' iyy='0' izz='0'/></inertial>") +
                joint("fixed", "base", "tip")));
  EXPECT_EQ(description.bodies.at(1).solid.mass, 0.0001);
  EXPECT_EQ(description.bodies[1].solid.inertia.xx, 0);
  EXPECT_TRUE(any_contains(description.notes, "robot.urdf:3: links with mass and without inertia are points"));
}

TEST(UrdfReader, WarnsAboutInertiaThatNoSolidHas) {
  const auto text = with_link("<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='3'/></inertial>");
  EXPECT_TRUE(any_contains(read(text).warnings, "robot.urdf:2: no solid body has"));
}

TEST(UrdfReader, TakesBothHalvesOfAnInertia) {
  const std::string text =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0.1' iyx='0.1' ixz='0.2' "
      "izx='0.3'/></inertial>";
  const auto description = read(with_link(text));
  ASSERT_EQ(description.warnings.size(), 1u);
  EXPECT_TRUE(
      contains(description.warnings[0], "robot.urdf:2: inertia of link 'base' is not symmetric: izx is not ixz"));
  EXPECT_EQ(description.bodies.at(0).solid.inertia.xz, 0.2);
}

TEST(UrdfReader, BalancesInertiaWhereTheFileAsksForIt) {
  const auto description = read(
      "<robot name='r'><mujoco><compiler balanceinertia='true'/></mujoco><link name='base'><inertial>"
      "<mass value='1'/><inertia ixx='1' iyy='1' izz='4'/></inertial></link></robot>");
  const SymMat3d& inertia = description.bodies.at(0).solid.inertia;
  expect_near({inertia.xx, inertia.yy, inertia.zz}, {2, 2, 2});
  EXPECT_TRUE(description.warnings.empty());
}

TEST(UrdfReader, HalvesTheSizesOfShapes) {
  const auto description =
      read(with_link(collision_xml("<box size='2 4 6'/>") + collision_xml("<cylinder radius='1' length='4'/>") +
                     collision_xml("<capsule radius='1' length='6'/>") + collision_xml("<sphere radius='3'/>")));
  const auto& shapes = description.bodies.at(0).shapes;
  ASSERT_EQ(shapes.size(), 4u);
  expect_near(std::get<Box>(shapes[0].placed.shape).half_size, {1, 2, 3});
  EXPECT_EQ(std::get<Cylinder>(shapes[1].placed.shape).half_length, 2);
  EXPECT_EQ(std::get<Capsule>(shapes[2].placed.shape).half_length, 3);
  EXPECT_EQ(std::get<Sphere>(shapes[3].placed.shape).radius, 3);
}

TEST(UrdfReader, TellsWhatCollidesFromWhatIsForTheEye) {
  const auto description = read(
      with_link(visual("<sphere radius='1'/>", "<material name='m'><color rgba='1 0.5 0 1'/></material>") +
                "<collision name='bump'><origin xyz='1 0 0'/><geometry><sphere radius='2'/></geometry></collision>"));
  const auto& shapes = description.bodies.at(0).shapes;
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_TRUE(shapes[0].placed.collides);
  EXPECT_EQ(shapes[0].name, "bump");
  expect_near(shapes[0].placed.position, {1, 0, 0});
  EXPECT_EQ(shapes[0].placed.color.green, 0.5);
  EXPECT_FALSE(shapes[1].placed.collides);
}

TEST(UrdfReader, FindsColorsByNameWhereverTheyAreDefined) {
  const auto description =
      read("<robot name='r'><material name='blue'><color rgba='0 0 1 1'/></material><link name='base'>" +
           visual("<sphere radius='1'/>", "<material name='blue'/>") +
           visual("<sphere radius='1'/>", "<material name='red'/>") +
           visual("<sphere radius='1'/>", "<material name='red'><color rgba='1 0 0 1'/></material>") +
           visual("<sphere radius='1'/>", "<material name='green'/>") + "</link></robot>");
  const auto& shapes = description.bodies.at(0).shapes;
  EXPECT_EQ(shapes[0].placed.color.blue, 1);
  EXPECT_EQ(shapes[1].placed.color.red, 1);
  EXPECT_EQ(shapes[2].placed.color.red, 1);
  EXPECT_EQ(shapes[3].placed.color.red, Color{}.red);
  EXPECT_TRUE(any_contains(description.notes, "material 'green' has no color"));
}

// Rule: the texture of a material colors meshes that have places for it; its color multiplies it.
TEST(UrdfReader, FindsTexturesAsMeshes) {
  write("t.obj", tetrahedron());
  write("skins/Skin.png", "");
  const std::string mesh = "<mesh filename='t.obj'/>";
  const auto description = read(
      "<robot name='r'><material name='skin'><texture filename='skins/skin.png'/></material><link name='base'>" +
      visual(mesh, "<material name='skin'/>") +
      visual(mesh, "<material name='tinted'><texture filename='skins/skin.png'/><color rgba='1 .5 0 1'/></material>") +
      visual(mesh, "<material name='lost'><texture filename='lost.png'/></material>") + "</link></robot>");
  const auto& visuals = description.bodies.at(0).visuals;
  ASSERT_EQ(visuals.size(), 3U);
  EXPECT_EQ(std::filesystem::path(visuals[0].picture).filename(), "Skin.png");
  EXPECT_EQ(visuals[0].color, (Color{1, 1, 1}));
  EXPECT_EQ(visuals[1].picture, visuals[0].picture);
  EXPECT_EQ(visuals[1].color, (Color{1, 0.5, 0}));
  EXPECT_EQ(visuals[2].picture, "");
  EXPECT_TRUE(any_contains(description.warnings, "there is no texture 'lost.png'"));
}

TEST(UrdfReader, ReadsWhoFollowsWhom) {
  const auto description = read(robot_xml(
      link("a", solid()) + link("b", solid()) + joint("revolute", "base", "a", any_limit, "lead") +
      joint("revolute", "a", "b", any_limit + "<mimic joint='lead' multiplier='-2' offset='0.5'/>", "follow")));
  ASSERT_EQ(description.mimics.size(), 1u);
  EXPECT_EQ(description.mimics[0].joint, "follow");
  EXPECT_EQ(description.mimics[0].leader, "lead");
  EXPECT_EQ(description.mimics[0].ratio, -2);
  EXPECT_EQ(description.mimics[0].offset, 0.5);
}

TEST(UrdfReader, LetsTheRobotFloatInItsWorld) {
  const auto description = read("<robot name='r'><link name='world'/>" + link("trunk", solid()) +
                                joint("floating", "world", "trunk", "<origin xyz='0 0 9'/>") + "</robot>");
  ASSERT_EQ(description.bodies.size(), 1u);
  EXPECT_EQ(description.bodies[0].name, "trunk");
  EXPECT_EQ(description.bodies[0].parent, -1);
  expect_near(description.bodies[0].place.position, {});
}

TEST(UrdfReader, AnEmptyRootCalledWorldBoltsTheRobot) {
  for (const char* type : {"fixed", "continuous"}) {
    const auto description = read("<robot name='r'><link name='world'/>" + link("trunk", solid()) +
                                  joint(type, "world", "trunk") + "</robot>");
    EXPECT_EQ(description.bodies.size(), 2u);
    EXPECT_TRUE(description.fixed_base);
    EXPECT_TRUE(any_contains(description.notes, "bolted to the world"));
  }
  const std::string rest = link("trunk", solid()) + joint("fixed", "world", "trunk") + "</robot>";
  EXPECT_FALSE(read("<robot name='r'>" + link("world", solid()) + rest).fixed_base);
}

TEST(UrdfReader, IgnoresTheAxisOfAFixedJoint) {
  EXPECT_TRUE(read(with_joint("fixed", "<axis xyz='0 0 0'/><limit lower='0' upper='0' effort='0' velocity='0'/>"))
                  .bodies.at(1)
                  .joints.empty());
}

TEST(UrdfReader, TakesPrefixDeclarationsOfExpandedFiles) {
  EXPECT_EQ(read("<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><link name='a'/></robot>").bodies.size(), 1u);
}

TEST(UrdfReader, NotesWhatMeansNothingOncePerKind) {
  const auto description = read(robot_xml(
      link("limb", solid()) + joint("revolute", "base", "limb", any_limit + "<safety_controller k_velocity='1'/>") +
      "<transmission name='t'><joint name='j'/><actuator "
      "name='m'><mechanicalReduction>200</mechanicalReduction></actuator></transmission>"
      "<transmission name='u'><joint name='k'/></transmission>"));
  EXPECT_TRUE(names_unused(description, "robot.urdf:3: element 'safety_controller' is not used"));
  EXPECT_TRUE(names_unused(description, "robot.urdf:4: gear ratios are not used"));
  EXPECT_TRUE(any_contains(description.warnings, "robot.urdf:4: transmission 'u' speaks of joint 'k'"));
  EXPECT_EQ(std::ranges::count(description.unused, "transmission", &robot_formats::Unused::word), 1);
}

TEST(UrdfReader, DropsWhatItDoesNotKnowIfLenient) {
  const auto description = read(with_link("<colision/>" + collision_xml("<ellipsoid/>")), {.lenient = true});
  EXPECT_TRUE(any_contains(description.warnings, "robot.urdf:2: unknown element in link 'colision'"));
  EXPECT_TRUE(any_contains(description.warnings, "element 'ellipsoid' is not supported"));
  EXPECT_TRUE(description.bodies.at(0).shapes.empty());
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
