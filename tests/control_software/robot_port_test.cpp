// What control software sees of its robot and may set: names, units, encoder steps, times of samples, ranges, refusals.
#include "murosimf/control_software/robot_port.h"

#include <gtest/gtest.h>

#include <functional>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

/// Control software that is a function.
class Program final : public ControlSoftware {
 public:
  using Step = std::function<void(Duration now)>;
  Program(Step start, Step step) : start_(std::move(start)), step_(std::move(step)) {}
  CallOutcome start() override {
    if (start_) start_({});
    return {};
  }
  CallOutcome step(Duration now) noexcept override {
    if (step_) step_(now);
    return {};
  }

 private:
  Step start_, step_;
};

using Connect = std::function<std::unique_ptr<Program>(RobotPort&)>;
SoftwareMaker made_by(const Connect& connect) {
  return [connect](Setup&, RobotPort& port, const SayLine&) { return connect(port); };
}

/// A robot whose software is made by `connect`, 100 times per second, at a level.
struct ProgrammedRobot {
  explicit ProgrammedRobot(const Connect& connect, ModelPtr model = test::kid21(),
                           const std::string& level = "simplified_dynamics")
      : robot(rig.add("robot", std::move(model))) {
    task = &rig.simulation.attach<ControllerTask>("control_software", robot, 100, made_by(connect),
                                                  ControllerTaskOptions{.software = "program"});
    rig.attach_dynamics(robot, {.level = level});
  }

  test::Rig rig;
  Entity& robot;
  ControllerTask* task;
};

std::unique_ptr<Program> nothing_to_do() { return std::make_unique<Program>(nullptr, nullptr); }

std::string refusal(const Connect& connect) {
  return fixtures::error_of([&] { ProgrammedRobot robot(connect); });
}

/// A base of 1 kg with two hinges; the first has a servo that knows its angle in steps.
ModelPtr two_arms(double encoder_step = 0) {
  Chain chain;
  chain.base("base").with(properties::mass, 1.0).with(properties::inertia, {0.01, 0.01, 0.01, 0, 0, 0});
  const auto arm = [](const std::string& name, double low, double high) {
    return Chain{}
        .revolute(name, {0, 0, 1})
        .with(properties::joint_range, {low, high, 0})
        .with(properties::mass, 0.1)
        .with(properties::inertia, {1e-4, 1e-4, 1e-4, 0, 0, 0});
  };
  Servo servo;
  servo.encoder_step = encoder_step;
  chain.fork(arm("first", -1, 1).with(properties::servo, servo), arm("second", -0.5, 0.5));
  return std::make_shared<const Model>("arms", chain);
}

TEST(RobotPort, ShowsJointsAsTheirBusReportsThem) {
  const double step = 2 * pi / 4096;  // of 12 bits
  const murosimf_signal *position = nullptr, *velocity = nullptr;
  std::vector<std::string> labels;
  ProgrammedRobot robot(
      [&](RobotPort& port) {
        position = port.signal("joint.position");
        velocity = port.signal("joint.velocity");
        labels = *port.labels("joint.position");
        murosimf_command* target = port.command("joint.target");
        return std::make_unique<Program>(nullptr, [target](Duration now) {
          target->values[0] = 0.3 * seconds(now);
          target->values[1] = -0.2 * seconds(now);
        });
      },
      two_arms(step));
  EXPECT_EQ(labels, (std::vector<std::string>{"first", "second"}));
  robot.rig.run(0.5);
  const double first = robot.robot.object("first").get(properties::joint_position),
               second = robot.robot.object("second").get(properties::joint_position);
  robot.rig.run(0.005);  // a step of the software begins at 0.5 s, and sees what held then
  EXPECT_EQ(position->time, 500'000'000);
  EXPECT_EQ(position->samples, 51U);
  EXPECT_GT(first, 0.1);
  EXPECT_EQ(position->values[0], step * std::round(first / step));
  EXPECT_NE(position->values[0], first);
  EXPECT_EQ(position->values[1], second);
  EXPECT_NEAR(velocity->values[0], 0.3, 0.05);
}

TEST(RobotPort, KnowsNamesAndSaysTheNearest) {
  EXPECT_EQ(refusal([](RobotPort& port) { return (void)port.signal("joint.positon"), nothing_to_do(); }),
            "unknown signal 'joint.positon'; did you mean 'joint.position'?");
  EXPECT_EQ(refusal([](RobotPort& port) { return (void)port.command("joint.targt"), nothing_to_do(); }),
            "unknown command 'joint.targt'; did you mean 'joint.target'?");
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.command("joint.target");
                               return (void)port.command("walk.velocity"), nothing_to_do();
                             }),
                             {"'joint.target' and 'walk.velocity' exclude each other"}));
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.command("walk.other_joints");
                               return (void)port.command("joint.target"), nothing_to_do();
                             }),
                             {"'walk.other_joints' and 'joint.target' exclude each other"}));
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.command("walk.velocity");
                               return (void)port.command("motion.play"), nothing_to_do();
                             }),
                             {"'walk.velocity' and 'motion.play' exclude each other"}));
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.signal("motion.mode");
                               return (void)port.command("joint.target"), nothing_to_do();
                             }),
                             {"'motion.mode' and 'joint.target' exclude each other"}));
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.command("joint.target");
                               return (void)port.signal("motion.fallen"), nothing_to_do();
                             }),
                             {"'joint.target' and 'motion.fallen' exclude each other"}));
}

// The engine itself: tests/dds/booster/booster_software_test.cpp.
TEST(RobotPort, LeavesJointsToTheMotionEngine) {
  double engine_has_second = 1, angle = 0.3;
  ProgrammedRobot robot(
      [&](RobotPort& port) {
        murosimf_command *engine = port.command("motion.joints"), *target = port.command("joint.target");
        (void)port.command("motion.velocity");
        EXPECT_EQ(engine->values[0], 1);
        EXPECT_TRUE(port.uses_motions());
        return std::make_unique<Program>(nullptr, [&, engine, target](Duration) {
          engine->values[0] = 0;
          engine->values[1] = engine_has_second;
          target->values[0] = target->values[1] = angle;
        });
      },
      two_arms());
  const auto targets = [&] {
    robot.rig.run(0.02);
    const auto& column = *robot.robot.find(properties::joint_target);
    const std::span<const int> joints = robot.robot.model().joints();
    return std::vector<double>{column.values[joints[0]], column.values[joints[1]]};
  };
  EXPECT_EQ(targets(), (std::vector<double>{0.3, 0}));
  engine_has_second = 0;
  EXPECT_EQ(targets(), (std::vector<double>{0.3, 0.3}));
  engine_has_second = 1;
  angle = 0.1;
  EXPECT_EQ(targets(), (std::vector<double>{0.1, 0.3})) << "it stays where it was left";
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.command("joint.target");
                               return (void)port.command("motion.joints"), nothing_to_do();
                             }),
                             {"exclude each other", "once motion.joints has been asked for"}));
  EXPECT_TRUE(fixtures::says(refusal([](RobotPort& port) {
                               (void)port.command("motion.joints");
                               return (void)port.command("walk.velocity"), nothing_to_do();
                             }),
                             {"'motion.joints' and 'walk.velocity' exclude each other"}));
}

TEST(RobotPort, AsksTheMotionEngineForMotionsByName) {
  std::vector<std::string> names;
  ProgrammedRobot robot([&](RobotPort& port) {
    murosimf_command* play = port.command("motion.play");
    murosimf_command* velocity = port.command("motion.velocity");
    names = *port.labels("motion.play");
    return std::make_unique<Program>(nullptr, [play, velocity](Duration) {
      play->values[1] = 3;
      velocity->values[0] = 0.1;
    });
  });
  EXPECT_TRUE(robot.task->port().uses_motions());
  EXPECT_FALSE(robot.task->port().walks());
  const auto& motions = *robot.robot.model().find(properties::given_motions, 0);
  ASSERT_EQ(names.size(), motions.size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i], motions[i].name);
  robot.rig.run(0.1);
  EXPECT_EQ(robot.robot.base().get(properties::motion_request).number[1], 3);
  EXPECT_EQ(robot.robot.base().get(properties::walk_command).x, 0.1);
}

TEST(RobotPort, ShowsWhatTheMotionEngineDoes) {
  const murosimf_signal *mode = nullptr, *phase = nullptr, *odometry = nullptr, *fallen = nullptr;
  std::vector<std::string> names;
  ProgrammedRobot robot([&](RobotPort& port) {
    mode = port.signal("motion.mode");
    phase = port.signal("motion.phase");
    odometry = port.signal("motion.odometry");
    fallen = port.signal("motion.fallen");
    names = *port.labels("motion.phase");
    EXPECT_EQ(*port.labels("motion.odometry"), (std::vector<std::string>{"x", "y", "heading"}));
    return nothing_to_do();
  });
  EXPECT_TRUE(robot.task->port().uses_motions()) << "a reader of the state has it";
  const auto kick = static_cast<std::size_t>(std::ranges::find(names, "kick_left") - names.begin());
  ASSERT_LT(kick, names.size());
  ASSERT_EQ(phase->count, names.size());
  ObjectAccess base = robot.robot.base();
  base.set(properties::motion_state, {.mode = static_cast<double>(locomotion::MotionMode::play),
                                      .motion = static_cast<double>(kick),
                                      .time = 2,
                                      .duration = 4});
  base.set(properties::odometry, {1, 2, 0.5});
  robot.rig.run(0.02);
  EXPECT_EQ(mode->values[0], 2);
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(phase->values[i], i == kick ? 0.5 : -1) << names[i];
  EXPECT_EQ(odometry->values[0], 1);
  EXPECT_EQ(odometry->values[1], 2);
  EXPECT_EQ(odometry->values[2], 0.5);
  EXPECT_EQ(fallen->values[0], 0);
  base.set(properties::motion_state, {.mode = static_cast<double>(locomotion::MotionMode::lie)});
  robot.rig.run(0.02);
  EXPECT_EQ(mode->values[0], 6);
  EXPECT_EQ(phase->values[kick], -1);
  EXPECT_EQ(fallen->values[0], 1);
}

TEST(RobotPort, AsksTheMotionEngineForAKick) {
  ProgrammedRobot robot([&](RobotPort& port) {
    murosimf_command* kick = port.command("motion.kick");
    EXPECT_EQ(*port.labels("motion.kick"),
              (std::vector<std::string>{"number", "direction", "side", "ball_x", "ball_y"}));
    return std::make_unique<Program>(nullptr, [kick](Duration) {
      const std::array numbers{1.0, 0.5, 7.0, 0.2, -0.05};  // 7: no side
      std::ranges::copy(numbers, kick->values);
    });
  });
  EXPECT_TRUE(robot.task->port().uses_motions());
  robot.rig.run(0.1);
  const locomotion::KickRequest request = robot.robot.base().get(properties::kick_request);
  EXPECT_EQ(request.number, 1);
  EXPECT_EQ(request.direction, 0.5);
  EXPECT_EQ(request.side, 0) << "refused";
  EXPECT_EQ(request.ball_x, 0.2);
  EXPECT_EQ(request.ball_y, -0.05);
}

TEST(RobotPort, RefusesMotionsOfARobotThatHasNone) {
  const auto kick = [](RobotPort& port) { return (void)port.command("motion.kick"), nothing_to_do(); };
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { ProgrammedRobot robot(kick, two_arms()); }),
                             {"no motion of the robot's file says where it kicks"}));
  const auto ask = [](RobotPort& port) { return (void)port.command("motion.play"), nothing_to_do(); };
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { ProgrammedRobot robot(ask, two_arms()); }),
                             {"the robot's file names no motions"}));
}

TEST(RobotPort, TakesNoNewCommandsOnceItRuns) {
  RobotPort* later = nullptr;
  ProgrammedRobot robot([&](RobotPort& port) {
    later = &port;
    (void)port.command("joint.target");
    return nothing_to_do();
  });
  EXPECT_EQ(later->command("joint.target")->count, 21U);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)later->command("joint.torque_enabled"); }),
                             {"was not asked for when the robot was set up"}));
}

// Numbers beyond a joint's range, or none, are refused one by one; the others of the row count.
TEST(RobotPort, RefusesNumberByNumber) {
  murosimf_command* target = nullptr;
  std::vector<double> wanted{0, 0};
  ProgrammedRobot robot(
      [&](RobotPort& port) {
        target = port.command("joint.target");
        return std::make_unique<Program>(nullptr, [&](Duration) { std::ranges::copy(wanted, target->values); });
      },
      two_arms());
  const auto targets = [&] {
    robot.rig.run(0.01);
    return std::vector{robot.robot.object("first").get(properties::joint_target),
                       robot.robot.object("second").get(properties::joint_target)};
  };
  wanted = {0.9, -0.5};
  EXPECT_EQ(targets(), wanted);  // the ends belong to the range
  wanted = {0.7, 0.51};
  EXPECT_EQ(targets(), (std::vector{0.7, -0.5}));
  wanted = {std::nan(""), 0.1};
  EXPECT_EQ(targets(), (std::vector{0.7, 0.1}));
  EXPECT_EQ(target->values[0], 0.7) << "the software sees what holds";
  const SoftwareReport* report = software_report(robot.robot);
  EXPECT_EQ(report->refused, 2U);
  EXPECT_EQ(report->first_refusal, "at 0.010 s: joint.target of second is 0.51, not in -0.5 to 0.5");
}

/// [rad] Where the head is half a second after it was told to turn by 0.5 rad, with its torque on or off.
double head_after_turn(double torque_enabled) {
  ProgrammedRobot robot(
      [&](RobotPort& port) {
        murosimf_command* enabled = port.command("joint.torque_enabled");
        murosimf_command* target = port.command("joint.target");
        EXPECT_EQ(enabled->values[0], 1) << "torque is on at the start";
        return std::make_unique<Program>(nullptr, [=](Duration) {
          std::fill_n(enabled->values, enabled->count, torque_enabled);
          target->values[1] = 0.5;
        });
      },
      test::kid21(), "articulated_dynamics");
  EXPECT_EQ((*robot.task->port().labels("joint.target"))[1], "j_neck");
  robot.rig.run(0.5);
  return robot.robot.object("j_neck").get(properties::joint_position);
}

TEST(RobotPort, SwitchesTorqueOff) {
  EXPECT_NEAR(head_after_turn(1), 0.5, 0.05);
  EXPECT_NEAR(head_after_turn(0), 0, 0.05);
}

TEST(RobotPort, LeavesTheLegsToTheWalkEngine) {
  std::vector<std::string> others;
  ProgrammedRobot robot([&](RobotPort& port) {
    murosimf_command* velocity = port.command("walk.velocity");
    murosimf_command* joints = port.command("walk.other_joints");
    others = *port.labels("walk.other_joints");
    return std::make_unique<Program>(nullptr, [velocity, joints](Duration) {
      velocity->values[0] = 0.1;
      std::fill_n(joints->values, joints->count, 0.2);
    });
  });
  EXPECT_TRUE(robot.task->port().walks());
  EXPECT_EQ(others.size(), 21U - 12U);
  robot.rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot.robot, 100);
  robot.rig.run(2);
  EXPECT_EQ(robot.robot.base().get(properties::walk_command).x, 0.1);
  EXPECT_GT(robot.robot.base().get(properties::position).x, 0.05);
  for (const std::string& joint : others) EXPECT_EQ(robot.robot.object(joint).get(properties::joint_target), 0.2);
}

/// What a sensor's signal shows in each step of a scene's robot.
TEST(RobotPort, ShowsSamplesWithTheirTimes) {
  scene::Scene scene("walk", {.overrides = {"walker.controller=none", "walker.sensors.imu.rate=50",
                                            "walker.sensors.imu.delay=0.013", "walker.level=simplified_dynamics"},
                              .cameras = false});
  struct Seen {
    std::int64_t time = 0;
    std::uint64_t samples = 0;
  };
  std::vector<Seen> seen;
  const murosimf_signal* gyroscope = nullptr;
  const SoftwareMaker make = made_by([&](RobotPort& port) {
    gyroscope = port.signal("imu.gyroscope");
    return std::make_unique<Program>(nullptr, [&](Duration) { seen.push_back({gyroscope->time, gyroscope->samples}); });
  });
  scene.simulation().attach<ControllerTask>("program", scene.simulation().world().entity("walker"), 100, make,
                                            ControllerTaskOptions{.software = "program"});
  scene.simulation().run(100ms);
  EXPECT_EQ(gyroscope->count, 3U);
  // at 0 nothing has moved yet; samples of 20, 40, 60 ms arrive 13 ms later, between two steps of the software
  ASSERT_EQ(seen.size(), 10U);
  const std::vector<std::uint64_t> samples{0, 0, 0, 0, 1, 1, 2, 2, 3, 3};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].samples, samples[i]) << i;
    EXPECT_EQ(seen[i].time, static_cast<std::int64_t>(20'000'000 * samples[i])) << i;
  }
}

TEST(RobotPort, ShowsTheGameAsSomebodyHasWrittenIt) {
  const murosimf_signal *state = nullptr, *score = nullptr;
  murosimf_command* answer = nullptr;
  ProgrammedRobot program([&](RobotPort& port) {
    state = port.signal("game.state");
    score = port.signal("game.score");
    EXPECT_EQ(port.signal("game.state"), state);
    answer = port.command("game.answer");
    EXPECT_EQ(*port.labels("game.score"), (std::vector<std::string>{"own", "other"}));
    return nothing_to_do();
  });
  program.rig.simulation.run(20ms);
  EXPECT_EQ(state->samples, 0U);  // nothing was received
  EXPECT_EQ(score->count, 2U);
  GameView& view = program.robot.column(game_view).values[0];
  view.time = 12'000'000;
  view.samples = 3;
  view.state = 2;
  view.score = {4, 5};
  program.rig.simulation.run(20ms);
  EXPECT_EQ(state->values[0], 2);
  EXPECT_EQ(state->samples, 3U);
  EXPECT_EQ(score->values[0], 4);
  EXPECT_EQ(score->values[1], 5);
  EXPECT_EQ(score->time, 12'000'000);
  EXPECT_EQ(program.robot.column(game_answer).values[0], answer_alive);
  answer->values[0] = 4;
  program.rig.simulation.run(20ms);
  EXPECT_EQ(program.robot.column(game_answer).values[0], 4);
  answer->values[0] = 5;
  program.rig.simulation.run(20ms);
  EXPECT_EQ(program.robot.column(game_answer).values[0], 4);  // there is no such answer
}

TEST(RobotPort, HasNoColumnsOfTheGameForWhoDoesNotAsk) {
  ProgrammedRobot program([](RobotPort&) { return nothing_to_do(); });
  EXPECT_EQ(program.robot.find(properties::motion_state), nullptr);
  EXPECT_EQ(program.robot.find(game_view), nullptr);
  EXPECT_EQ(program.robot.find(message_box), nullptr);
  EXPECT_EQ(refusal([](RobotPort& port) {
              (void)port.signal("game.stat");
              return nothing_to_do();
            }),
            "unknown signal 'game.stat'; did you mean 'game.state'?");
}

}  // namespace
}  // namespace murosimf::control_software
