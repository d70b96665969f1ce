// What joints and servos report, at every level; and that levels which come and go leave nothing stale behind.
#include "murosimf/sensors/joint_sensors.h"

#include <cmath>

#include "murosimf/component_files/sensor_types.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::sensors {
namespace {

/// A robot that stands with sensors of all its joints.
struct Standing {
  explicit Standing(const std::string& level, std::vector<std::string> types = every_type())
      : robot(rig.add("robot", test::kid21())) {
    for (const std::string& type : types) {
      component_files::attach_sensor(rig.simulation, robot, {.name = type, .type = type}, {}, rig.rate);
    }
    rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, 100);
    rig.attach_motion(robot, {.level = level});
  }
  static std::vector<std::string> every_type() {
    return {"joint_position", "joint_velocity", "joint_torque", "motor_current", "motor_voltage", "motor_temperature"};
  }
  [[nodiscard]] double of(const std::string& sensor, const std::string& joint) const {
    const Reading& reading = *find_reading(robot, sensor);
    const auto& labels = reading.info->outputs[0].labels;
    const auto place = std::find(labels.begin(), labels.end(), joint) - labels.begin();
    return reading.values.at(static_cast<std::size_t>(place));
  }

  test::Rig rig;
  Entity& robot;
};

class Joints : public testing::TestWithParam<std::string> {};

TEST_P(Joints, ShowPositionAndRate) {
  Standing standing(GetParam(), {"joint_position", "joint_velocity"});
  standing.rig.run(1);
  const double position = standing.robot.object("j_l_shin").get(properties::joint_position);
  const double rate = standing.robot.object("j_l_shin").get(properties::joint_velocity);
  standing.rig.simulation.step();
  EXPECT_EQ(standing.of("joint_position", "j_l_shin"), position);
  EXPECT_EQ(standing.of("joint_velocity", "j_l_shin"), rate);
  EXPECT_GT(std::abs(position), 0.1) << "its knees are bent";
}

TEST_P(Joints, EverySensorHasNumbers) {
  Standing standing(GetParam());
  standing.rig.run(0.5);
  for (const Reading* reading : readings_of(standing.robot)) {
    for (const double value : reading->values) EXPECT_TRUE(std::isfinite(value)) << reading->info->name;
    EXPECT_EQ(reading->info->outputs[0].labels.size(), 21u);
  }
}

INSTANTIATE_TEST_SUITE_P(JointSensors, Joints, testing::ValuesIn(test::all_levels()), test::level_name);

TEST(JointPosition, CountsTheStepsOfAnEncoder) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  const double step = 2 * pi / 4096;
  auto& sensor = component_files::attach_sensor(rig.simulation, robot,
                                                {.name = "e",
                                                 .type = "joint_position",
                                                 .objects = {"j_l_shin", "j_neck"},
                                                 .signals = {{"", {.resolution = step}}}},
                                                {}, rig.rate);
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, 100, Vec3d{0.1, 0, 0});
  rig.attach_motion(robot, {.level = "kinematic_walking"});
  EXPECT_EQ(sensor.reading().info->outputs[0].labels, (std::vector<std::string>{"j_l_shin", "j_neck"}));
  for (int i = 0; i < 500; ++i) {
    const double exact = i == 0 ? 0 : robot.object("j_l_shin").get(properties::joint_position);
    rig.simulation.step();
    const double shown = sensor.reading().values[0];
    EXPECT_NEAR(shown / step, std::round(shown / step), 1e-9);
    if (i > 0) {
      EXPECT_LE(std::abs(shown - exact), 0.5 * step * (1 + 1e-9));
    }
  }
}

/// A bolted arm of one link, 2 kg at 0.2 m, held level by a servo without friction.
ModelPtr arm() {
  Servo servo{.voltage = 12, .stall_torque = 10, .no_load_speed = 6, .position_gain = 500, .rotor_inertia = 0.01};
  return std::make_shared<const Model>("arm", Chain{}
                                                  .base("base")
                                                  .with(properties::mass, 1.0)
                                                  .revolute("shoulder", {0, 1, 0})
                                                  .with(properties::mass, 2.0)
                                                  .with(properties::center_of_mass, {0.2, 0, 0})
                                                  .with(properties::inertia, SymMat3d{0.01, 0.01, 0.01, 0, 0, 0})
                                                  .with(properties::servo, servo));
}

// Holding torque m g l, and the current i = torque/k_t with k_t = voltage/no_load_speed = 2 N m/A.
TEST(MotorCurrent, IsThatOfTheTorqueThatHoldsALoad) {
  test::Rig rig;
  Entity& robot = rig.add("arm", arm(), {.position = {0, 0, 1}});
  auto& current =
      component_files::attach_sensor(rig.simulation, robot, {.name = "i", .type = "motor_current"}, {}, rig.rate);
  auto& torque =
      component_files::attach_sensor(rig.simulation, robot, {.name = "t", .type = "joint_torque"}, {}, rig.rate);
  auto& voltage =
      component_files::attach_sensor(rig.simulation, robot, {.name = "u", .type = "motor_voltage"}, {}, rig.rate);
  rig.attach_dynamics(robot, {.level = "articulated_dynamics", .on_ground = false, .tree = {.fixed_base = true}});
  rig.run(3);
  const double angle = robot.object("shoulder").get(properties::joint_position);
  const double holding = -2.0 * test::g * 0.2 * std::cos(angle);  // the arm along x; gravity turns it down, about +y
  law::expect_near({.law = "servo that holds an arm level: its torque",
                    .level = "articulated_dynamics",
                    .source = "m g l"},
                   torque.reading().values[0], holding, 1e-6, "N m");
  law::expect_near({.law = "servo that holds an arm level: its current",
                    .level = "articulated_dynamics",
                    .source = "torque/k_t, k_t = voltage/no-load rate"},
                   current.reading().values[0], holding / 2, 1e-6, "A");
  EXPECT_EQ(voltage.reading().values[0], 12);
  robot.object("shoulder").set(properties::supply_voltage, 11);
  rig.run(0.01);
  EXPECT_EQ(voltage.reading().values[0], 11);
}

/// Does nothing but let the test write torques.
struct Torques final : Algorithm {
  explicit Torques(Setup& setup) : torque(setup.write(properties::joint_torque)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
  void initialize() override { std::ranges::fill(torque, 3.0); }
  void step(const Instant&) noexcept override {}
  std::span<double> torque;
};

// Rule: where there is no motor, or one whose data do not say its constant, no current flows, whatever the joint bears.
TEST(MotorCurrent, IsThatOfMotorsOnly) {
  Simulation simulation;
  Chain chain = Chain{}.base("base").with(properties::mass, 1.0);
  const auto joint = [&](const std::string& name, const std::optional<Servo>& servo) {
    chain.revolute(name, {0, 1, 0}).with(properties::mass, 1.0).with(properties::inertia, diagonal(0.1));
    if (servo) chain.with(properties::servo, *servo);
  };
  joint("motor", Servo{.voltage = 12, .stall_torque = 10, .no_load_speed = 6});
  joint("hinge", {});
  joint("weak", Servo{.voltage = 0, .stall_torque = 10, .no_load_speed = 6});
  joint("stuck", Servo{.voltage = 12, .stall_torque = 10, .no_load_speed = 0});
  Entity& robot = simulation.world().add("robot", std::make_shared<const Model>("arm", chain));
  auto& sensor = simulation.attach<MotorCurrent>("current", robot, 1000, SensorSpec{.name = "i"}, SensorSurroundings{});
  simulation.attach<Torques>("torques", robot, 1000);
  simulation.initialize();
  simulation.step();
  const std::vector<double>& current = sensor.reading().values;
  EXPECT_EQ(current, (std::vector<double>{3 * 6 / 12.0, 0, 0, 0}));
}

TEST(ServoSensors, NothingStaleIsLeftByALevelThatWent) {
  Standing standing("articulated_dynamics");
  standing.rig.run(1);
  EXPECT_NE(standing.of("joint_torque", "j_l_shin"), 0);
  standing.rig.exchange(standing.robot, "simplified_dynamics");
  standing.rig.run(0.1);
  EXPECT_EQ(standing.of("joint_torque", "j_l_shin"), 0);
  EXPECT_EQ(standing.of("motor_temperature", "j_l_shin"), 25);
  standing.rig.exchange(standing.robot, "articulated_dynamics");
  standing.rig.run(0.1);
  EXPECT_NE(standing.of("joint_torque", "j_l_shin"), 0);
}

TEST(ServoSensors, SayWhatTheyReportWhereThereIsNoTorque) {
  Standing standing("kinematic_walking", {});
  auto& sensor = component_files::attach_sensor(standing.rig.simulation, standing.robot,
                                                {.name = "t", .type = "joint_torque"}, {}, 1000);
  EXPECT_EQ(sensor.diagnostic({}), "torques of joints are not known: it reports 0");
  EXPECT_EQ(sensor.diagnostic({.dynamic = true, .joint_torque = true, .servos = true}), "");
  auto& current = component_files::attach_sensor(standing.rig.simulation, standing.robot,
                                                 {.name = "i", .type = "motor_current"}, {}, 1000);
  EXPECT_EQ(current.diagnostic({}), "torques of joints are not known: it reports 0");
  EXPECT_EQ(current.diagnostic({.dynamic = true, .joint_torque = true}),
            "joints move without servos: it reports the current for the torque that that would take");
  EXPECT_EQ(current.diagnostic({.dynamic = true, .joint_torque = true, .servos = true}), "");
  auto& temperature = component_files::attach_sensor(standing.rig.simulation, standing.robot,
                                                     {.name = "c", .type = "motor_temperature"}, {}, 1000);
  EXPECT_EQ(temperature.diagnostic({.dynamic = true, .joint_torque = true}),
            "servos get warm only at a level that has them: it reports the temperature of the air");
  EXPECT_EQ(temperature.diagnostic({.servos = true}), "");
}

}  // namespace
}  // namespace murosimf::sensors
