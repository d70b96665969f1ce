// Gyroscope and accelerometer against closed forms: at rest, in free fall, on a turntable, in a tumbling body.
#include "murosimf/sensors/inertial.h"

#include <cmath>

#include "murosimf/component_files/sensor_types.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/rig.h"
#include "tests/sensors/puppet.h"

namespace murosimf::sensors {
namespace {

constexpr double g = 9.81;

Vec3d vector_of(const Reading& reading, std::string_view output) {
  const auto numbers = reading.output(output);
  return {numbers[0], numbers[1], numbers[2]};
}

TEST(Accelerometer, ShowsGravityUpwardsAtRest) {
  test::SensorRig<Accelerometer> rig(test::at_rest, {.name = "a"});
  rig.run_until(0.1);
  EXPECT_EQ(fixtures::difference(vector_of(rig.reading(), "accelerometer"), {0, 0, g}), 0);
}

// A sensor that leans by 30 degrees about y, mounted another 20 degrees.
TEST(Accelerometer, ShowsGravityInItsOwnAxes) {
  const double lean = 50 * test::degree;
  const auto leaning = [](double) { return test::BodyMotion{.orientation = rotation_y(30 * test::degree)}; };
  test::SensorRig<Accelerometer> rig(leaning, {.name = "a", .orientation = rotation_y(20 * test::degree)});
  rig.run_until(0.01);
  EXPECT_LT(fixtures::difference(vector_of(rig.reading(), "accelerometer"),
                                 {-g * std::sin(lean), 0, g * std::cos(lean)}),
            1e-12);
}

TEST(Accelerometer, ShowsNothingInFreeFall) {
  test::Rig rig;
  Entity& box = rig.add("box", test::box_model(), {.position = {0, 0, 5}});
  auto& sensor =
      component_files::attach_sensor(rig.simulation, box, {.name = "a", .type = "accelerometer"}, {}, rig.rate);
  rig.attach_dynamics(box, {.on_ground = false});
  rig.run(0.5);
  law::expect_below({.law = "free fall: specific force",
                     .level = "simplified_dynamics",
                     .source = "nothing carries it"},
                    norm(vector_of(sensor.reading(), "accelerometer")), 1e-9, "m/s^2");
}

/// The first sample, and when it was taken [s].
std::pair<double, Vec3d> first_sample_in_free_fall(double rate) {
  test::Rig rig;
  Entity& box = rig.add("box", test::box_model(), {.position = {0, 0, 5}});
  auto& sensor = component_files::attach_sensor(rig.simulation, box,
                                                {.name = "a", .type = "accelerometer", .rate = rate}, {}, rig.rate);
  rig.attach_dynamics(box, {.on_ground = false});
  for (int i = 0; i < 100 && sensor.reading().samples == 0; ++i) rig.simulation.step();
  return {seconds(sensor.reading().time), vector_of(sensor.reading(), "accelerometer")};
}

TEST(Accelerometer, ItsFirstSampleIsOfAFirstPeriod) {
  for (const double rate : {100.0, 1000.0}) {
    const auto [time, force] = first_sample_in_free_fall(rate);
    EXPECT_EQ(time, 1 / rate);
    EXPECT_LT(norm(force), 1e-9);
  }
}

// Before there is a sample, a reader must not see a body that falls, or no axes at all.
TEST(Accelerometer, BeforeTheFirstSampleItShowsRest) {
  const auto leaning = [](double) { return test::BodyMotion{.orientation = rotation_y(0.3)}; };
  test::SensorRig<Imu> rig(leaning, {.name = "imu", .rate = 100});
  rig.simulation.step();
  EXPECT_EQ(rig.reading().samples, 0U);
  EXPECT_LT(fixtures::difference(vector_of(rig.reading(), "accelerometer"), {-g * std::sin(0.3), 0, g * std::cos(0.3)}),
            1e-12);
  EXPECT_NEAR(rig.reading().output("orientation")[0], std::cos(0.15), 1e-12);
}

// Back at the instant 0 nothing is left of the window: a body that no longer speeds up shows nothing.
TEST(Accelerometer, ForgetsWhatWasBeforeItsStart) {
  const auto motion = [](double t) { return test::BodyMotion{.velocity = {std::min(t, 0.055), 0, 0}}; };
  test::SensorRig<Accelerometer> rig(motion, {.name = "a", .rate = 100});
  rig.run_until(0.056);
  rig.sensor.initialize();
  rig.run_until(0.060);
  ASSERT_EQ(rig.reading().samples, 1U);
  EXPECT_NEAR(vector_of(rig.reading(), "accelerometer").x, 0, 1e-9);
}

// A velocity that goes up in stairs, as that of a walker whose controller has a period of 10 ms: what a sample sees must not
// depend on where in the period it is taken.
TEST(Accelerometer, SamplesAddUpToTheChangeOfVelocity) {
  const auto stairs = [](double t) {
    return test::BodyMotion{.velocity = {0.02 * std::floor(t / 0.010 + 1e-6), 0, 0}};
  };
  for (const double rate : {100.0, 200.0, 500.0, 1000.0}) {
    test::SensorRig<Accelerometer> rig(stairs, {.name = "a", .rate = rate});
    double change = 0;
    std::uint64_t seen = 0;
    for (int i = 0; i <= 1000; ++i) {
      rig.simulation.step();
      if (rig.reading().samples > seen) change += vector_of(rig.reading(), "accelerometer").x / rate;
      seen = rig.reading().samples;
    }
    EXPECT_EQ(seen, static_cast<std::uint64_t>(rate));
    EXPECT_NEAR(change, 2.0, 1e-9) << rate << " Hz";
  }
}

// Law: every sample is the change of velocity over its period, without gravity, also where the force is another in each step.
TEST(Accelerometer, EverySampleIsTheMeanOverItsPeriod) {
  const auto velocity = [](double t) { return Vec3d{std::sin(40 * t), 3 * t * t, std::cos(17 * t)}; };
  const auto shaken = [&](double t) { return test::BodyMotion{.velocity = velocity(t)}; };
  for (const double rate : {100.0, 250.0, 500.0}) {
    test::SensorRig<Accelerometer> rig(shaken, {.name = "a", .rate = rate});
    for (int k = 2; k < 12; ++k) {
      rig.run_until(k / rate);
      ASSERT_EQ(rig.reading().time, from_seconds(k / rate));
      const Vec3d mean = rate * (velocity(k / rate) - velocity((k - 1) / rate)) + Vec3d{0, 0, g};
      EXPECT_LT(fixtures::difference(vector_of(rig.reading(), "accelerometer"), mean), 1e-9) << rate << " Hz, " << k;
    }
  }
}

/// On a turntable about the world's z, the sensor 0.3 m off its axis and turned outwards along x.
test::BodyMotion turntable(double t) {
  constexpr double rate = 6;
  return {.orientation = rotation_z(rate * t), .angular_velocity = {0, 0, rate}};
}

TEST(Accelerometer, ShowsTheCentripetalForceOfATurntable) {
  const SensorSpec spec{.name = "imu", .position = {0.3, 0, 0}};
  test::SensorRig<Imu> rig(turntable, spec);
  rig.run_until(1.2345);
  const double rate = 6, step = rate * 0.001;
  law::expect_below({.law = "turntable: specific force at 0.3 m from its axis, 6 rad/s",
                     .level = "accelerometer",
                     .source = "-w^2 r inwards, g upwards; a mean over a step of 1 ms is (w h)^2/6 less"},
                    fixtures::difference(vector_of(rig.reading(), "accelerometer"), {-rate * rate * 0.3, 0, g}),
                    rate * rate * 0.3 * step * step / 6 * 1.01, "m/s^2");
  EXPECT_LT(fixtures::difference(vector_of(rig.reading(), "gyroscope"), {0, 0, rate}), 1e-12);
}

// Torque-free symmetric body: its rate runs around its own axis with W = (I3 - I1)/I1 w3.
TEST(Gyroscope, FollowsATumblingBody) {
  const double I1 = 0.02, I3 = 0.035;
  PlacedShape shape;
  shape.shape = Box{{0.1, 0.1, 0.05}};
  const auto top = std::make_shared<const Model>("top", Chain{}
                                                            .base("top")
                                                            .with(properties::mass, 1.5)
                                                            .with(properties::inertia, SymMat3d{I1, I1, I3, 0, 0, 0})
                                                            .with(properties::shapes, Shapes{shape}));
  for (const std::string& level : test::dynamic_levels()) {
    test::Rig rig;
    Entity& body = rig.add("top", top, {.position = {0, 0, 50}});
    auto& sensor = component_files::attach_sensor(rig.simulation, body, {.name = "imu", .type = "imu"}, {}, rig.rate);
    rig.attach_dynamics(body, {.level = level,
                               .law = test::law_named("kelvin_voigt"),
                               .on_ground = false,
                               .tree = {.integrator = dynamics::Integrator::rk4}});
    rig.simulation.initialize();
    const double w1 = 2, w3 = 5, W = (I3 - I1) / I1 * w3;
    test::Rig::launch(body, {}, {w1, 0, w3});
    law::Worst worst;
    for (int i = 0; i < 2000; ++i) {
      const double t = seconds(rig.simulation.now());
      rig.simulation.step();
      const Vec3d exact{w1 * std::cos(W * t), w1 * std::sin(W * t), w3};
      worst.see(fixtures::difference(vector_of(sensor.reading(), "gyroscope"), exact));
    }
    law::expect_below({.law = "tumbling symmetric body, 5 rad/s for 2 s: error of the gyroscope",
                       .level = level + ", rk4",
                       .source = "Euler's equations: w runs around the axis with (I3 - I1)/I1 w3"},
                      worst, 1e-6, "rad/s");
  }
}

TEST(Orientation, IsThatOfTheSensorInTheWorld) {
  const Mat3d turn = rotation_z(0.7) * rotation_x(0.4);
  const auto turned = [&](double) { return test::BodyMotion{.orientation = turn}; };
  test::SensorRig<Orientation> rig(turned, {.name = "o", .orientation = rotation_y(0.3)});
  rig.run_until(0.01);
  const auto q = rig.reading().output("orientation");
  EXPECT_LT(fixtures::difference(to_matrix(Quaterniond{q[0], q[1], q[2], q[3]}), turn * rotation_y(0.3)), 1e-12);
}

TEST(Orientation, ErrorsAreARotationAndKeepTheLength) {
  const SensorSpec spec{.name = "o", .signals = {{"", {.noise = 0.05}}}};
  test::SensorRig<Orientation> rig(test::at_rest, spec);
  double squares = 0;
  Vec3d products;  // of neighbors
  const int count = 3000;
  for (int i = 0; i < count; ++i) {
    rig.simulation.step();
    const auto q = rig.reading().output("orientation");
    EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-12);
    const Vec3d error = rotation_vector({q[0], q[1], q[2], q[3]});
    squares += dot(error, error) / 3;
    products += Vec3d{error.x * error.y, error.y * error.z, error.z * error.x};
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.002);
  for (const double product : {products.x, products.y, products.z}) {
    EXPECT_LT(std::abs(product / squares), 0.08) << "each axis has an error of its own";
  }
}

class EveryLevel : public testing::TestWithParam<std::string> {};

// A standing robot: the same sensor, whatever moves the robot.
TEST_P(EveryLevel, ImuOfAStandingRobotShowsRest) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  auto& sensor = component_files::attach_sensor(rig.simulation, robot, {.name = "imu", .type = "imu", .frame = "torso"},
                                                {}, rig.rate);
  rig.attach_motion(robot, {.level = GetParam()});
  rig.run(2);
  EXPECT_NEAR(norm(vector_of(sensor.reading(), "accelerometer")), g, 0.05);
  EXPECT_LT(norm(vector_of(sensor.reading(), "gyroscope")), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Inertial, EveryLevel, testing::ValuesIn(test::all_levels()), test::level_name);

}  // namespace
}  // namespace murosimf::sensors
