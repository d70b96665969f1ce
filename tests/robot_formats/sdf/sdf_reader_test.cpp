/// sdf_reader_test - SDF files become the right description of a robot.
#include "murosimf/robot_formats/sdf/sdf_reader.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "murosimf/math/roll_pitch_yaw.h"
#include "murosimf/robot_formats/urdf/urdf_reader.h"
#include "tests/robot_formats/sdf/sdf_files.h"

namespace murosimf::robot_formats::sdf {
namespace {

using namespace sdf_files;

constexpr double quarter = 0.5 * std::numbers::pi;

class SdfReader : public SdfTest {};

/// Text of a pose.
std::string pose_text(const Transformd& place) {
  const Vec3d p = place.position, rpy = roll_pitch_yaw(place.orientation);
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", p.x, p.y, p.z, rpy.x, rpy.y, rpy.z);
}

/// The same robot in the words of SDF: links stand in their joints, joints in their parent links.
std::string to_sdf(const robot_formats::RobotDescription& robot) {
  std::string text = "<sdf version='1.9'><model name='twin'>\n";
  for (const robot_formats::BodyDescription& body : robot.bodies) {
    const auto& [mass, center, I] = body.solid;
    const bool is_base = body.parent < 0;
    text += fmt::format("<link name='{}'>{}", body.name,
                        is_base ? "" : fmt::format("<pose relative_to='j_{}'/>", body.name));
    text += fmt::format(
        "<inertial><pose>{:.17g} {:.17g} {:.17g} 0 0 "
        "0</pose><mass>{:.17g}</mass><inertia><ixx>{:.17g}</ixx><iyy>{:.17g}</iyy>"
        "<izz>{:.17g}</izz><ixy>{:.17g}</ixy><ixz>{:.17g}</ixz><iyz>{:.17g}</iyz></inertia></inertial></link>\n",
        center.x, center.y, center.z, mass, I.xx, I.yy, I.zz, I.xy, I.xz, I.yz);
    if (is_base) continue;
    const std::string parent = robot.bodies[static_cast<std::size_t>(body.parent)].name;
    text +=
        fmt::format("<joint name='j_{}' type='{}'><pose relative_to='{}'>{}</pose><parent>{}</parent><child>{}</child>",
                    body.name, body.joints.empty() ? "fixed" : "revolute", parent, pose_text(body.place), parent,
                    body.name);
    if (!body.joints.empty()) {
      const robot_formats::JointDescription& joint = body.joints[0];
      text += fmt::format(
          "<axis><xyz>{:.17g} {:.17g} {:.17g}</xyz><limit><lower>{:.17g}</lower><upper>{:.17g}</upper></limit></axis>",
          joint.axis.x, joint.axis.y, joint.axis.z, joint.range->x, joint.range->y);
    }
    text += "</joint>\n";
  }
  return text + "</model></sdf>";
}

void expect_same(const SymMat3d& a, const SymMat3d& b) {
  expect_near({a.xx, a.yy, a.zz}, {b.xx, b.yy, b.zz});
  expect_near({a.xy, a.xz, a.yz}, {b.xy, b.xz, b.yz});
}

void expect_same(const Mat3d& a, const Mat3d& b) {
  expect_near(a.x, b.x);
  expect_near(a.y, b.y);
  expect_near(a.z, b.z);
}

// angles and numbers of the example are not round: axes, places and inertias differ in every number from those of another order
TEST_F(SdfReader, ReadsTheSameRobotAsUrdf) {
  const auto urdf = urdf::read_urdf(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "examples/data/robot.urdf");
  const auto sdf = read(to_sdf(urdf));
  ASSERT_EQ(sdf.bodies.size(), urdf.bodies.size());
  std::size_t joints = 0;
  for (std::size_t i = 0; i < urdf.bodies.size(); ++i) {
    const robot_formats::BodyDescription &mine = sdf.bodies[i], &theirs = urdf.bodies[i];
    EXPECT_EQ(mine.name, theirs.name);
    EXPECT_EQ(mine.parent, theirs.parent);
    expect_near(mine.place.position, theirs.place.position);
    expect_same(mine.place.orientation, theirs.place.orientation);
    EXPECT_NEAR(mine.solid.mass, theirs.solid.mass, 1e-12);
    expect_near(mine.solid.center, theirs.solid.center);
    expect_same(mine.solid.inertia, theirs.solid.inertia);
    ASSERT_EQ(mine.joints.size(), theirs.joints.size());
    for (std::size_t k = 0; k < mine.joints.size(); ++k, ++joints) {
      expect_near(mine.joints[k].axis, theirs.joints[k].axis);
      expect_near(mine.joints[k].anchor, theirs.joints[k].anchor);
      expect_near(*mine.joints[k].range, *theirs.joints[k].range);
    }
  }
  EXPECT_GT(joints, 3u);
}

// by hand: b stands at (1, 2, 3) turned by a quarter about z, the joint 0.5 along its x, with an axis along y of the model
TEST_F(SdfReader, PlacesJointsInTheFrameOfTheirChild) {
  const auto robot =
      read(pair("revolute", "<pose>0.5 0 0 0 0 0</pose><axis><xyz expressed_in='__model__'>0 2 0</xyz></axis>",
                fmt::format("<pose>1 2 3 0 0 {:.17g}</pose>", quarter)));
  const robot_formats::BodyDescription& body = robot.bodies.at(1);
  expect_near(body.place.position, {1, 2, 3});
  expect_near(body.place.orientation * Vec3d{1, 0, 0}, {0, 1, 0});
  expect_near(body.joints.at(0).anchor, {0.5, 0, 0});
  expect_near(body.joints.at(0).axis, {1, 0, 0});
  EXPECT_TRUE(body.joints[0].where.ends_with("robot.sdf:4")) << body.joints[0].where;
}

TEST_F(SdfReader, FollowsChainsOfFrames) {
  const auto robot = read(model(link("a") + "<frame name='f' attached_to='a'><pose>0 0 1 0 0 " +
                                fmt::format("{:.17g}", quarter) + "</pose></frame>\n" +
                                link("b", "<pose relative_to='f'>1 0 0 0 0 0</pose>") + joint("fixed", "a", "b")));
  expect_near(robot.bodies.at(1).place.position, {0, 1, 1});
  ASSERT_EQ(robot.bodies[0].frames.size(), 1u);
  EXPECT_EQ(robot.bodies[0].frames[0].name, "f");
  expect_near(robot.bodies[0].frames[0].place.position, {0, 0, 1});
}

TEST_F(SdfReader, LeavesThePlaceOfTheModelToTheScene) {
  const auto robot = read(model("<pose>7 8 9 0 0 1</pose>" + link("a", "<pose>0 0 1 0 0 0</pose>") +
                                link("b", "<pose>0 0 3 0 0 0</pose>") + joint("fixed", "a", "b")));
  expect_near(robot.bodies.at(1).place.position, {0, 0, 2});
  EXPECT_FALSE(robot.fixed_base);
}

TEST_F(SdfReader, ReadsOldFiles) {
  const auto robot =
      read("<sdf version='1.4'><model name='r'>" + link("a") + link("b", "<pose>0 0 1 0 0 1.5707963267948966</pose>") +
           joint("revolute", "a", "b", "<axis><xyz>0 1 0</xyz></axis>") + "</model></sdf>");
  // before 1.5 axes are those of the model
  expect_near(robot.bodies.at(1).joints.at(0).axis, {1, 0, 0});
}

TEST_F(SdfReader, ReadsEveryNumberOfAJoint) {
  const auto one = joint_of(
      "revolute",
      "<axis><xyz>0 0 1</xyz><limit><lower>-0.5</lower><upper>1.5</upper><effort>7</effort><velocity>8</velocity>"
      "</limit><dynamics><damping>0.25</damping><friction>0.75</friction><spring_reference>0.1"
      "</spring_reference><spring_stiffness>3</spring_stiffness></dynamics></axis>");
  EXPECT_EQ(one.kind, Kind::revolute);
  ASSERT_TRUE(one.range);
  expect_near(*one.range, {-0.5, 1.5, 0});
  EXPECT_EQ(one.effort_limit, 7);
  EXPECT_EQ(one.rate_limit, 8);
  EXPECT_EQ(one.damping, 0.25);
  EXPECT_EQ(one.friction, 0.75);
  EXPECT_EQ(one.spring_reference, 0.1);
  EXPECT_EQ(one.stiffness, 3);
  EXPECT_EQ(joint_of("prismatic", "<axis><xyz>1 0 0</xyz></axis>").kind, Kind::prismatic);
}

TEST_F(SdfReader, TakesEndlessLimitsForNone) {
  const std::string limits =
      "<axis><xyz>0 0 1</xyz><limit><lower>-1e16</lower><upper>inf</upper><effort>-1</effort></limit></axis>";
  const auto one = joint_of("revolute", limits);
  EXPECT_FALSE(one.range);
  EXPECT_EQ(one.effort_limit, 0);
  EXPECT_EQ(one.rate_limit, 0);
  const auto continuous =
      joint_of("continuous", "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis>");
  EXPECT_FALSE(continuous.range);
}

TEST_F(SdfReader, FixesAJointThatItsLimitsHold) {
  const auto robot = read(pair("revolute",
                               "<axis><xyz>0 0 1</xyz><limit><lower>1.5707963267948966</lower><upper>1.5707963267948966"
                               "</upper></limit></axis>",
                               "<pose>1 0 0 0 0 0</pose>"));
  EXPECT_TRUE(robot.bodies.at(1).joints.empty());
  expect_near(robot.bodies[1].place.orientation * Vec3d{1, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(any_contains(robot.warnings, "joint 'j' cannot move"));
}

TEST_F(SdfReader, MakesHingesOfBallsAndUniversalJoints) {
  const auto ball = read(pair("ball"));
  ASSERT_EQ(ball.bodies.at(1).joints.size(), 3u);
  EXPECT_EQ(ball.bodies[1].joints[2].name, "j.z");
  const auto two = read(pair("universal", "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>"));
  ASSERT_EQ(two.bodies.at(1).joints.size(), 2u);
  EXPECT_EQ(two.bodies[1].joints[0].name, "j.1");
  expect_near(two.bodies[1].joints[0].axis, {1, 0, 0});
  expect_near(two.bodies[1].joints[1].axis, {0, 1, 0});
}

TEST_F(SdfReader, LetsJointsMimic) {
  const auto robot = read(
      model(link("a") + link("b") + link("c") + joint("revolute", "a", "b", "<axis><xyz>0 0 1</xyz></axis>", "lead") +
            joint("revolute", "b", "c",
                  "<axis><xyz>0 0 1</xyz><mimic joint='lead'><multiplier>2</multiplier><offset>1</offset>"
                  "<reference>0.25</reference></mimic></axis>",
                  "follow")));
  ASSERT_EQ(robot.mimics.size(), 1u);
  EXPECT_EQ(robot.mimics[0].joint, "follow");
  EXPECT_EQ(robot.mimics[0].leader, "lead");
  EXPECT_EQ(robot.mimics[0].ratio, 2);
  EXPECT_EQ(robot.mimics[0].offset, 0.5);
}

TEST_F(SdfReader, WeighsLinksWithoutInertialAsTheFormatSays) {
  const auto robot = read(model("<link name='a'/>"));
  EXPECT_EQ(robot.bodies.at(0).solid.mass, 1);
  expect_same(robot.bodies[0].solid.inertia, diagonal(1.0));
  EXPECT_TRUE(any_contains(robot.notes, "links without inertial weigh 1 kg"));
}

TEST_F(SdfReader, TurnsInertiaToTheAxesOfTheLink) {
  const auto robot =
      read(model("<link name='a'><inertial><pose>1 2 3 0 0 1.5707963267948966</pose><mass>2</mass><inertia><ixx>1</ixx>"
                 "<iyy>2</iyy><izz>2.5</izz><ixy>0.1</ixy><ixz>0.2</ixz><iyz>0.3</iyz></inertia></inertial></link>"));
  expect_near(robot.bodies.at(0).solid.center, {1, 2, 3});
  // x of the tensor is y of the link, y of the tensor is -x
  expect_same(robot.bodies[0].solid.inertia, {2, 1, 2.5, -0.1, -0.3, 0.2});
}

}  // namespace
}  // namespace murosimf::robot_formats::sdf
