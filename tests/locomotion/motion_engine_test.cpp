// The motion engine on kid21: pushes, falls, motions on request, odometry, limits of rates; from its own sensors with their errors.
#include "murosimf/locomotion/motion_engine.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"

namespace murosimf::locomotion {
namespace {

using namespace std::chrono_literals;

constexpr const char* articulated = "articulated_dynamics";

/// kid21 on the plane of scene `walk`.
struct Walker {
  explicit Walker(const std::string& level, const std::string& command = "[0,0,0]", std::vector<std::string> more = {},
                  const std::string& controller = "motions")
      : scene("walk", options(level, command, std::move(more), controller)) {}

  static scene::SceneOptions options(const std::string& level, const std::string& command,
                                     std::vector<std::string> more, const std::string& controller) {
    for (const std::string& text :
         {"level=" + level, "command=" + command, "controller=" + controller, std::string("position=[-2,0]")})
      more.push_back("walker." + text);
    return {.overrides = std::move(more), .cameras = false};
  }

  void run(Duration time) { scene.simulation().run(time); }
  /// [N s] at the trunk's center of mass, in 0.1 s.
  void push(const Vec3d& impulse) {
    robot.object("torso").set(properties::applied_force, {{}, 10.0 * impulse});
    run(100ms);
    robot.object("torso").set(properties::applied_force, {});
  }
  [[nodiscard]] double upright() const { return robot.base().get(properties::orientation).z.z; }
  [[nodiscard]] MotionMode mode() const {
    return static_cast<MotionMode>(robot.base().get(properties::motion_state).mode);
  }
  void ask(std::string_view motion) {
    const NamedMotions& motions = *robot.model().find(properties::given_motions, 0);
    MotionRequests requests = robot.base().get(properties::motion_request);
    for (std::size_t i = 0; i < motions.size(); ++i) requests.number[i] += motions[i].name == motion ? 1 : 0;
    robot.base().set(properties::motion_request, requests);
  }

  scene::Scene scene;
  Entity& robot = scene.simulation().world().entity("walker");
};

const std::vector<Vec3d> directions{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};

TEST(MotionEngine, StepsAgainstPushesThatTheOpenLoopFallsBy) {
  for (const char* command : {"[0,0,0]", "[0.15,0,0]"}) {
    for (const Vec3d& direction : directions) {
      Walker walker(articulated, command);
      walker.run(3s);
      walker.push(2.0 * direction);
      walker.run(3s);
      EXPECT_GT(walker.upright(), 0.9) << command << ", " << direction.x << ", " << direction.y;
      EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0);
    }
  }
  int fell = 0;
  for (const Vec3d& direction : directions) {
    Walker walker(articulated, "[0.15,0,0]", {}, "walk");
    walker.run(3s);
    walker.push(2.0 * direction);
    walker.run(3s);
    if (walker.upright() < 0.9) ++fell;
  }
  EXPECT_GE(fell, 3) << "without feedback";
}

TEST(MotionEngine, HurriesWhenItFallsOverTheFootThatStands) {
  const auto falls = [](const std::string& option) {
    int count = 0;
    for (const char* when :
         {"2.68..2.78", "2.74..2.84"}) {  // the robot comes down on its left foot, and goes on over it
      scene::SceneOptions options = Walker::options(articulated, "[0.15,0,0]", {option}, "motions");
      options.pushes = {std::string("walker.torso=[0,25,0]@") + when};
      scene::Scene scene("walk", std::move(options));
      scene.simulation().run(5s);
      if (scene.simulation().world().entity("walker").base().get(properties::orientation).z.z < 0.9) ++count;
    }
    return count;
  };
  EXPECT_EQ(falls("walker.options.hurry_at=0.04"), 0);
  EXPECT_EQ(falls("walker.options.hurry_at=10"), 2) << "slowly";
}

TEST(MotionEngine, WalksUpAndDownASlopeAsOnLevelGround) {
  const auto way = [](double slope, std::vector<std::string> more) {  // [m] in 8 s; weight to the back: uphill
    more.push_back(fmt::format("gravity=[{},0,{}]", -9.81 * std::sin(slope), -9.81 * std::cos(slope)));
    Walker walker(articulated, "[0.2,0,0]", std::move(more));
    walker.run(8s);
    EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0) << slope;
    return walker.robot.base().get(properties::position).x + 2;
  };
  constexpr double steep = 3 * pi / 180;
  const double level = way(0, {});
  for (const double slope : {steep, -steep}) {
    EXPECT_NEAR(way(slope, {}), level, 0.2 * level) << slope;
    EXPECT_GT(std::abs(way(slope, {"walker.options.slope=0"}) - level), 0.3 * level) << slope << ", not followed";
  }
}

TEST(MotionEngine, StandsAgainWhereItWasPushed) {
  Walker walker(articulated);
  walker.run(2s);
  walker.push({2, 0, 0});
  walker.run(5s);
  EXPECT_EQ(walker.robot.base().get(properties::gait_amplitude), 0);
  const Vec3d place = walker.robot.base().get(properties::position);
  walker.run(2s);
  EXPECT_LT(norm(walker.robot.base().get(properties::position) - place), 1e-3);
}

TEST(MotionEngine, WalksTurnsAndGoesSidewaysAtEveryLevel) {
  struct Case {
    const char* command;
    double forward, sideways, turned;  // [m, m, rad] after 8 s, about
  };
  for (const char* level : {"kinematic_walking", "simplified_dynamics", "full_dynamics", articulated}) {
    for (const Case& c : {Case{"[0.2,0,0]", 1.45, 0, 0}, Case{"[0,0.1,0]", 0, 0.75, 0}}) {
      Walker walker(level, c.command);
      walker.run(8s);
      const Vec3d place = walker.robot.base().get(properties::position);
      EXPECT_NEAR(place.x + 2, c.forward, 0.35) << level << c.command;
      EXPECT_NEAR(place.y, c.sideways, 0.35) << level << c.command;
      EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0) << level << c.command;
    }
    Walker turning(level, "[0,0,0.5]");
    turning.run(4s);
    EXPECT_NEAR(heading(turning.robot.base().get(properties::orientation)), 1.9, 0.4) << level;
  }
}

TEST(MotionEngine, KnowsHowFarItHasWalked) {
  for (const char* level : {"full_dynamics", articulated}) {
    Walker walker(level, "[0.2,0,0.2]");
    walker.run(6s);
    const Vec3d place = walker.robot.base().get(properties::position),
                odometry = walker.robot.base().get(properties::odometry);
    // slip of the feet and bias of the gyroscope, which is not known before the robot has stood still
    EXPECT_NEAR(odometry.x, place.x + 2, 0.15) << level;
    EXPECT_NEAR(odometry.y, place.y, 0.15) << level;
    EXPECT_NEAR(odometry.z, heading(walker.robot.base().get(properties::orientation)), 0.1) << level;
  }
}

TEST(MotionEngine, GetsUpFromEverySideAndWalksOn) {
  for (const char* lies : {"pitch_deg=90", "pitch_deg=-90", "roll_deg=90", "roll_deg=-90"}) {
    Walker walker(articulated, "[0.2,0,0]", {std::string("walker.") + lies});
    walker.run(11s);  // a second try, where the first one fails
    EXPECT_GT(walker.upright(), 0.9) << lies;
    EXPECT_EQ(walker.mode(), MotionMode::walk) << lies;
    const double before = walker.robot.base().get(properties::odometry).x;
    walker.run(3s);
    EXPECT_GT(walker.robot.base().get(properties::odometry).x - before, 0.3) << lies;
  }
}

TEST(MotionEngine, GetsSparkNaosUpFromTheirFronts) {
  for (const char* model : {"spark_nao0", "spark_nao1", "spark_nao3", "spark_nao4"}) {
    Walker walker(articulated, "[0,0,0]", {std::string("walker.model=") + model, "walker.pitch_deg=90"});
    walker.run(9s);
    EXPECT_GT(walker.upright(), 0.9) << model;
    EXPECT_EQ(walker.mode(), MotionMode::walk) << model;
  }
}

TEST(MotionEngine, ProtectsItselfOnTheSideToWhichItFallsAndGetsUp) {
  for (const auto& [lean, name] :
       {std::pair{"roll_deg=-38", "protect_left"}, std::pair{"roll_deg=38", "protect_right"}}) {
    Walker walker(articulated, "[0,0,0]", {std::string("walker.") + lean});
    walker.run(100ms);
    ASSERT_EQ(walker.mode(), MotionMode::protect) << name;
    const NamedMotions& motions = *walker.robot.model().find(properties::given_motions, 0);
    const double motion = walker.robot.base().get(properties::motion_state).motion;
    EXPECT_EQ(motions.at(static_cast<std::size_t>(motion)).name, name);
    walker.run(11s);
    EXPECT_GT(walker.upright(), 0.9) << name;
    EXPECT_EQ(walker.mode(), MotionMode::walk) << name;
  }
}

TEST(MotionEngine, GetsABoosterK1UpFromEverySide) {
  for (const char* lies : {"pitch_deg=90", "pitch_deg=-90", "roll_deg=90", "roll_deg=-90"}) {
    Walker walker("full_dynamics", "[0,0,0]", {"walker.model=booster_k1", std::string("walker.") + lies});
    walker.run(11s);  // a second try, where the first one fails
    EXPECT_GT(walker.upright(), 0.9) << lies;
    EXPECT_EQ(walker.mode(), MotionMode::walk) << lies;
  }
}

TEST(MotionEngine, LiesDownUntilItIsAskedToGetUpOrToWalk) {
  for (const bool asks_to_walk : {false, true}) {
    Walker walker("full_dynamics", "[0,0,0]", {"walker.model=booster_k1"});
    walker.run(1s);
    walker.ask("lie_down");
    walker.run(10s);
    EXPECT_LT(walker.upright(), 0.2);
    EXPECT_EQ(walker.mode(), MotionMode::play);
    if (asks_to_walk) walker.robot.base().set(properties::walk_command, {0.1, 0, 0});
    if (!asks_to_walk) walker.ask("get_up_front");
    walker.run(11s);
    EXPECT_GT(walker.upright(), 0.9) << asks_to_walk;
    EXPECT_EQ(walker.mode(), MotionMode::walk) << asks_to_walk;
    EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0) << "it was asked to";
  }
}

TEST(MotionEngine, StandsAfterABoosterK1HasKicked) {
  for (const char* level : {"simplified_dynamics", "full_dynamics", articulated}) {
    Walker walker(level, "[0,0,0]", {"walker.model=booster_k1"});
    walker.run(1s);
    walker.ask("kick_left");
    walker.run(300ms);
    EXPECT_EQ(walker.mode(), MotionMode::play) << level;
    walker.run(4s);
    EXPECT_EQ(walker.mode(), MotionMode::walk) << level;
    EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0) << level;
  }
}

TEST(MotionEngine, FallsGetsUpAndGoesOnAfterAPushThatNothingHelpsAgainst) {
  Walker walker(articulated, "[0.15,0,0]");
  walker.run(3s);
  walker.push({8, 0, 0});
  walker.run(8s);
  EXPECT_GE(walker.robot.base().get(properties::motion_state).falls, 1);
  EXPECT_GT(walker.upright(), 0.9);
  EXPECT_EQ(walker.mode(), MotionMode::walk);
}

TEST(MotionEngine, PlaysAMotionOnceForEachRequest) {
  Walker walker("full_dynamics");
  walker.run(1s);
  for (int i = 0; i < 2; ++i) {
    walker.ask("kick_right");
    walker.run(100ms);
    EXPECT_EQ(walker.mode(), MotionMode::play);
    walker.run(5s);
    EXPECT_EQ(walker.mode(), MotionMode::walk);
  }
}

TEST(MotionEngine, StopsBeforeItKicks) {
  Walker walker(articulated, "[0.2,0,0]");
  walker.run(3s);
  walker.ask("kick_left");
  walker.run(100ms);
  EXPECT_EQ(walker.mode(), MotionMode::walk) << "it is still walking";
  walker.run(1500ms);
  EXPECT_EQ(walker.mode(), MotionMode::play);
  walker.run(6s);
  EXPECT_EQ(walker.mode(), MotionMode::walk);
  EXPECT_GT(walker.robot.base().get(properties::gait_amplitude), 0) << "and walks on";
  EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0);
}

// Key frames place feet from the stance of the walk engine, which is narrower than kid21 walks with feedback.
TEST(MotionEngine, StandsWhereKeyFramesBeginAndWalksWider) {
  Walker walker("full_dynamics");
  const double stance = 2 * seeded_parameters(walker.robot.model()).half_width,
               wide = 2 * balanced_walk(walker.robot.model(), {}).half_width;
  ASSERT_GT(wide, stance + 0.02);
  const auto apart = [&] {
    const auto foot = [&](const char* name) { return walker.robot.object(name).get(properties::position); };
    return norm(foot("l_foot") - foot("r_foot"));
  };
  walker.run(1s);
  EXPECT_NEAR(apart(), stance, 2e-3);
  walker.robot.base().set(properties::walk_command, {0.01, 0, 0});
  walker.run(4s);
  double least = 1;
  for (int i = 0; i < 50; ++i, walker.run(10ms)) least = std::min(least, apart());
  EXPECT_GT(least, stance + 0.01);
  walker.robot.base().set(properties::walk_command, {});
  walker.run(4s);
  EXPECT_EQ(walker.robot.base().get(properties::gait_amplitude), 0);
  EXPECT_NEAR(apart(), stance, 4e-3);
}

TEST(MotionEngine, KicksASideAsHardAsKeyFramesAlone) {
  const auto speed = [](std::vector<std::string> how, std::vector<std::string> events) {
    for (const char* one : {"robot.level=articulated_dynamics", "ball.position=[0.02,-0.23]", "field.friction=0.6"})
      how.emplace_back(one);
    scene::Scene scene("kick", {.overrides = std::move(how), .events = std::move(events), .cameras = false});
    double fastest = 0;
    for (int i = 0; i < 600; ++i) {
      scene.simulation().run(10ms);
      fastest =
          std::max(fastest, norm(scene.simulation().world().entity("ball").base().get(properties::linear_velocity)));
    }
    return fastest;
  };
  const double alone = speed({"robot.controller=keyframes", "robot.motion=side_kick_right"}, {});
  EXPECT_GT(alone, 1.5);
  EXPECT_NEAR(speed({"robot.controller=motions"}, {"1:robot.play=side_kick_right"}), alone, 0.05);
}

TEST(MotionEngine, DivesAtOnceAndStandsUpAgain) {
  Walker walker(articulated);
  walker.run(1s);
  walker.ask("dive_left");
  walker.run(10ms);
  EXPECT_EQ(walker.mode(), MotionMode::play);
  walker.run(1500ms);
  EXPECT_LT(walker.upright(), 0.5);
  EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0) << "it means to lie";
  walker.run(12s);
  EXPECT_GT(walker.upright(), 0.9);
  EXPECT_EQ(walker.mode(), MotionMode::walk);
}

TEST(MotionEngine, NeverAsksAJointForMoreThanItsServoTurnsWithoutLoad) {
  Walker walker(articulated, "[0.35,0,0]");
  const Model& model = walker.robot.model();
  const auto targets = [&] {
    std::vector<double> values;
    for (const int joint : model.joints())
      values.push_back(walker.robot.object(model.objects()[joint].name).get(properties::joint_target));
    return values;
  };
  walker.run(10ms);  // joints go to where the stance has them
  std::vector<double> before = targets();
  for (int i = 0; i < 800; ++i) {
    if (i == 200) walker.push({6, 0, 0});  // falls, and gets up
    if (i == 200) before = targets();
    walker.run(10ms);
    const std::vector<double> now = targets();
    for (std::size_t k = 0; k < now.size(); ++k) {
      const double most = model.find(properties::servo, model.joints()[k])->no_load_speed * 0.01;
      EXPECT_LE(std::abs(now[k] - before[k]), most * (1 + 1e-9))
          << i << ", " << model.objects()[model.joints()[k]].name;
    }
    before = now;
  }
}

TEST(MotionEngine, AnswersNothingWhereItCannotFall) {
  Walker walker("kinematic_walking", "[0.2,0,0]");
  Walker open_loop("kinematic_walking", "[0.2,0,0]", {"walker.options.steps=none"});
  walker.run(5s);
  open_loop.run(5s);
  EXPECT_EQ(walker.robot.base().get(properties::position).x, open_loop.robot.base().get(properties::position).x);
}

TEST(MotionEngine, StepsWideInsteadOfADiveWhereItCannotFall) {
  for (const char* command : {"[0,0,0]", "[0.2,0,0]"}) {
    for (const double left : {1.0, -1.0}) {
      Walker walker("kinematic_walking", command);
      walker.run(1s);
      const Vec3d before = walker.robot.base().get(properties::position);
      walker.ask(left > 0 ? "dive_left" : "dive_right");
      walker.run(700ms);
      const Vec3d wide = walker.robot.base().get(properties::position);
      EXPECT_EQ(walker.mode(), MotionMode::play);
      EXPECT_LT(wide.z, before.z - 0.04) << "the hips sink";
      EXPECT_GT(left * (wide.y - before.y), 0.08) << "and the robot goes to that side";
      walker.run(3s);
      const Vec3d after = walker.robot.base().get(properties::position);
      EXPECT_EQ(walker.mode(), MotionMode::walk);
      EXPECT_NEAR(after.z, before.z, 0.01);
      EXPECT_GT(left * (after.y - before.y), 0.16);
      EXPECT_GT(walker.upright(), 0.99);
      EXPECT_EQ(walker.robot.base().get(properties::motion_state).falls, 0);
    }
  }
}

TEST(MotionEngine, NeitherGetsUpNorProtectsItselfWhereItCannotFall) {
  Walker walker("kinematic_walking"), idle("kinematic_walking");
  walker.run(1s);
  for (const char* motion : {"get_up_front", "get_up_left", "protect_back"}) {
    walker.ask(motion);
    walker.run(1s);
    EXPECT_EQ(walker.mode(), MotionMode::walk) << motion;
  }
  idle.run(4s);
  EXPECT_EQ(norm(walker.robot.base().get(properties::position) - idle.robot.base().get(properties::position)), 0);
}

// The pelvis is at rest and the torso, which has the inertial sensor, turns: the robot has not turned.
TEST(MotionEngine, DoesNotTakeAWaistThatTurnsForItself) {
  Walker walker(articulated);
  walker.run(1s);
  walker.robot.object("torso").set(properties::applied_force, {{0, 0, 1.2}, {}});
  walker.run(300ms);
  EXPECT_GT(walker.robot.object("j_torso").get(properties::joint_position), 0.05);
  EXPECT_NEAR(walker.robot.base().get(properties::odometry).z,
              heading(walker.robot.base().get(properties::orientation)), 0.02);
  EXPECT_NEAR(walker.robot.base().get(properties::gait_state).waist[0],
              walker.robot.object("j_torso").get(properties::joint_position), 0.03);
}

TEST(MotionEngine, ReadsAllSensorsOfJoints) {
  const std::vector<std::string> halves{"walker.sensors.encoders=false",
                                        "walker.sensors.left={type='joint_position',joints=['j_l_hip_yaw','j_l_hip_"
                                        "roll','j_l_thigh','j_l_shin','j_l_ankle',"
                                        "'j_l_foot','j_torso']}",
                                        "walker.sensors.right={type='joint_position',joints=['j_r_hip_yaw','j_r_hip_"
                                        "roll','j_r_thigh','j_r_shin','j_r_ankle',"
                                        "'j_r_foot']}"};
  Walker walker(articulated, "[0.2,0,0]", halves);
  walker.run(5s);
  EXPECT_NEAR(walker.robot.base().get(properties::odometry).x, walker.robot.base().get(properties::position).x + 2,
              0.15);
  std::vector<std::string> one(halves.begin(), halves.begin() + 2);
  const std::string error = fixtures::error_of([&] { const Walker lame(articulated, "[0,0,0]", one); });
  EXPECT_NE(error.find("'j_r_hip_yaw', which no sensor of the type joint_position reports"), std::string::npos)
      << error;
}

TEST(MotionEngine, GoesOnFromASavedState) {
  Walker first(articulated, "[0.2,0,0.3]");
  first.run(2s);
  first.push({1, 1, 0});
  const std::vector<std::byte> state = first.scene.save();
  first.run(2s);
  Walker second(articulated, "[0.2,0,0.3]");
  second.scene.load(state);
  second.run(2s);
  EXPECT_EQ(first.scene.simulation().state_hash(), second.scene.simulation().state_hash());
}

TEST(MotionEngine, GoesOnFromAStateInWhichItLies) {
  const std::vector<std::string> on_its_front{"walker.pitch_deg=90"};
  Walker first(articulated, "[0,0,0]", on_its_front);
  first.run(300ms);
  ASSERT_EQ(first.mode(), MotionMode::lie);
  const std::vector<std::byte> state = first.scene.save();
  first.run(1s);
  Walker second(articulated, "[0.2,0,0]", on_its_front);
  second.run(2s);  // another history
  second.scene.load(state);
  second.robot.base().set(properties::walk_command, Vec3d{});
  second.run(1s);
  EXPECT_EQ(first.scene.simulation().state_hash(), second.scene.simulation().state_hash());
}

TEST(MotionEngine, RefusesARobotWithoutLegs) {
  const std::string error = fixtures::error_of(
      [] { const scene::Scene scene("car_crash", {.overrides = {"car.controller=motions"}, .cameras = false}); });
  EXPECT_NE(error.find("soles"), std::string::npos) << error;
}

}  // namespace
}  // namespace murosimf::locomotion
