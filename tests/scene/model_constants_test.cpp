// Constants of models by --set: an entity with other constants has a model of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

std::string constants_scene() {
  return fixtures::write_scene(R"([ball]
[[teams]]
name = "blue"
[defaults]
model = "kid21"
level = "articulated_dynamics"
[[robots]]
name = "blue1"
team = "blue"
position = [-1.0, 0.5]
[[robots]]
name = "blue2"
team = "blue"
[[robots]]
name = "other"
position = [1.0, 0.5]
)");
}

std::string constants_mistake(const std::string& setting) {
  try {
    const Scene scene(constants_scene(), {.overrides = {setting}});
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

bool contains_all(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) return false;
  }
  return true;
}

template <class T>
const T& constant(const Scene& scene, const std::string& entity, const std::string& object,
                  const Property<T>& property) {
  const Model& model = scene.simulation().world().entity(entity).model();
  return *model.find(property, model.object_index(object));
}

TEST(ModelConstants, AMassTakesItsInertiaAlongAndSaysSo) {
  const Scene usual(constants_scene());
  const Scene scene(constants_scene(), {.overrides = {"blue1.torso.mass=1.2"}});
  const double before = constant(usual, "blue1", "torso", properties::mass);
  EXPECT_EQ(constant(scene, "blue1", "torso", properties::mass), 1.2);
  EXPECT_EQ(constant(scene, "blue2", "torso", properties::mass), before) << "no other robot changes";
  EXPECT_NEAR(constant(scene, "blue1", "torso", properties::inertia).xx,
              constant(usual, "blue1", "torso", properties::inertia).xx * 1.2 / before, 1e-12);
  EXPECT_NEAR(scene.simulation().world().entity("blue1").model().tree().mass,
              usual.simulation().world().entity("blue1").model().tree().mass + 1.2 - before, 1e-9);
  const auto notes = make_report(scene).notes;
  ASSERT_FALSE(notes.empty());
  EXPECT_TRUE(contains_all(notes.front(), {"blue1: torso: mass 1.2 kg instead of", "its inertia scaled by"}))
      << notes.front();
}

TEST(ModelConstants, RobotsWithEqualChangesShareAModel) {
  const Scene scene(constants_scene(), {.overrides = {"blue.*.torso.mass=1.2"}});
  const World& world = scene.simulation().world();
  EXPECT_EQ(world.entity("blue1").model_ptr(), world.entity("blue2").model_ptr());
  EXPECT_NE(world.entity("blue1").model_ptr(), world.entity("other").model_ptr());
  const auto notes = make_report(scene).notes;
  ASSERT_FALSE(notes.empty());
  EXPECT_TRUE(contains_all(notes.front(), {"blue1, blue2: torso: mass"})) << notes.front();
}

TEST(ModelConstants, OfBodiesJointsAndServosChange) {
  const Scene scene(constants_scene(),
                    {.overrides = {"blue1.torso.center_of_mass=[0.01,0,0.02]", "blue1.torso.inertia=[2,2,2,0,0,0]",
                                   "blue1.torso.mass=3", "blue1.j_l_shin.joint_range=[-0.5,1]",
                                   "blue1.joint_damping=0.25", "blue1.j_l_*.joint_friction=0.1",
                                   "blue1.j_l_shin.servo.backlash=0.01", "blue1.servo.stall_torque=4",
                                   "ball.ball.mass=0.3"}});
  EXPECT_EQ(constant(scene, "blue1", "torso", properties::center_of_mass).z, 0.02);
  EXPECT_EQ(constant(scene, "blue1", "torso", properties::inertia).xx, 2) << "a given inertia is not scaled";
  EXPECT_EQ(constant(scene, "blue1", "j_l_shin", properties::joint_range).x, -0.5);
  EXPECT_EQ(constant(scene, "blue1", "j_r_shin", properties::joint_damping), 0.25) << "all joints";
  EXPECT_EQ(constant(scene, "blue1", "j_l_shin", properties::joint_friction), 0.1);
  EXPECT_EQ(constant(scene, "blue1", "j_l_shin", properties::servo).backlash, 0.01);
  EXPECT_EQ(constant(scene, "blue1", "j_r_shin", properties::servo).stall_torque, 4) << "all servos";
  EXPECT_EQ(constant(scene, "ball", "ball", properties::mass), 0.3);
}

TEST(ModelConstants, ThatAreImpossibleAreRefused) {
  EXPECT_TRUE(contains_all(constants_mistake("blue1.torso.mass=0"), {"--set 'blue1.torso.mass=0'", "must be above 0"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.torso.mass=-1"), {"must be above 0"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.torso.mass=nan"), {"must be finite"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.torso.mass=[1,2]"), {"takes 1 number, not 2"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.torsoo.mass=1"), {"unknown object 'torsoo'", "torso"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.torso.inertia=[1,1,-1,0,0,0]"), {"not positive definite"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.pelvis.joint_damping=1"), {"'pelvis'", "no joint"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.joint_damping=-1"), {"must be at least 0"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.j_l_shin.joint_range=[1,-1]"), {"range", "empty"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.j_l_shin.servo.stall_torqe=1"),
                           {"unknown key of a servo 'stall_torqe'", "stall_torque"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.servo.duty_limit=2"),
                           {"'duty_limit' must be a number above 0, at most 1"}));
  EXPECT_TRUE(contains_all(constants_mistake("blue1.servo.voltage=10"), {"does not say at which voltage"}));
}

TEST(ModelConstants, TargetsOfAllJointsAreSetAtOnce) {
  Scene scene(constants_scene(), {.overrides = {"blue1.joint_target=0.1"}, .events = {"0.01:blue2.torque_enabled=0"}});
  scene.simulation().initialize();
  Entity& robot = scene.simulation().world().entity("blue1");
  EXPECT_EQ(robot.object("j_l_shin").get(properties::joint_target), 0.1);
  EXPECT_EQ(robot.object("j_head").get(properties::joint_target), 0.1);
  scene.simulation().run(std::chrono::milliseconds(20));
  EXPECT_EQ(scene.simulation().world().entity("blue2").object("j_l_shin").get(properties::torque_enabled), 0);
}

/// The same from the start, for another robot of the same model.
TEST(ModelConstants, ChangeWhileAModelRuns) {
  const std::string constants[] = {"torso.mass=2", "joint_damping=1", "servo.stall_torque=2"};
  std::vector<std::string> events, overrides;
  for (const std::string& constant : constants) {
    events.push_back("0.01:blue1." + constant);
    overrides.push_back("blue1." + constant);
  }
  Scene changed(constants_scene(), {.events = events}), built(constants_scene(), {.overrides = overrides});
  changed.simulation().run(std::chrono::milliseconds(20));
  const Model& model = changed.simulation().world().entity("blue1").model();
  const Model& expected = built.simulation().world().entity("blue1").model();
  for (const int object : expected.having(properties::mass)) {
    EXPECT_EQ(*model.find(properties::mass, object), *expected.find(properties::mass, object));
  }
  for (const int joint : expected.joints()) {
    EXPECT_EQ(*model.find(properties::joint_damping, joint), 1);
    EXPECT_EQ(model.find(properties::servo, joint)->stall_torque,
              expected.find(properties::servo, joint)->stall_torque);
  }
}

TEST(ModelConstants, ChangesThatCannotBeAreRefusedBeforeTheRun) {
  for (const char* event : {"1:blue1.torso.mass=-2", "1:blue1.joint_damping=-1", "1:materials.frction=1"}) {
    EXPECT_THROW(Scene(constants_scene(), {.events = {event}}), SetupError) << event;
  }
}

// friction by --set

PairSurface pair_of(const std::vector<std::string>& settings, const std::string& a, const std::string& b) {
  return scene_file::read_scene(constants_scene(), settings).materials.find({.material = a}, {.material = b});
}

TEST(MaterialSettings, ReachAllPairsOneMaterialOrOnePair) {
  EXPECT_EQ(pair_of({"materials.friction=0.2"}, "rubber", "carpet").friction, 0.2);
  EXPECT_EQ(pair_of({"materials.friction=0.2"}, "rubber", "carpet").restitution, 0.4) << "the rest stays";
  EXPECT_EQ(pair_of({"materials.friction=0.2"}, "", "carpet").friction, 0.2) << "also those not in the table";
  EXPECT_EQ(pair_of({"materials.ball.restitution=0.9"}, "carpet", "ball").restitution, 0.9);
  EXPECT_EQ(pair_of({"materials.ball.restitution=0.9"}, "carpet", "rubber").restitution, 0.4);
  EXPECT_EQ(pair_of({"materials.carpet.rubber.friction=0.3", "materials.friction=0.2"}, "rubber", "carpet").friction,
            0.3)
      << "what is more special wins";
  EXPECT_EQ(pair_of({"field.friction=0.1"}, "rubber", "carpet").friction, 0.1);
  EXPECT_EQ(pair_of({"field.friction=0.1"}, "", "carpet").friction, 0.1);
  EXPECT_EQ(pair_of({"field.friction=0.1"}, "rubber", "plastic").friction, 0.6) << "only with the ground";
}

TEST(MaterialSettings, RefuseWhatTheyDoNotKnow) {
  EXPECT_TRUE(contains_all(constants_mistake("materials.frictoin=0.2"), {"did you mean 'friction'?"}));
  EXPECT_TRUE(contains_all(constants_mistake("materials.rubbr.friction=0.2"), {"unknown material 'rubbr'", "rubber"}));
  EXPECT_TRUE(contains_all(constants_mistake("materials.friction=-1"), {"at least 0"}));
  EXPECT_TRUE(contains_all(constants_mistake("materials.friction=slippery"), {"must be a number"}));
  EXPECT_TRUE(contains_all(constants_mistake("field.friction=-0.1"), {"must not be negative"}));
}

}  // namespace
}  // namespace murosimf::scene
