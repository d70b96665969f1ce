// A plug-in: a controller, a contact law, a sensor, a format of robot files and a command of one's own, loaded by the program
// that is there (docs/add_an_algorithm.md).
//   murosimf list options --plugin build/release/own_plugin.so
//   murosimf run walk --plugin build/release/own_plugin.so --set walker.controller=circle --set walker.options.radius=0.5
//   murosimf --plugin build/release/own_plugin.so weigh kid21 --gravity 1.62
#include <murosimf/plugin/command.h>
#include <murosimf/plugin/contact_law.h>
#include <murosimf/plugin/controller.h>
#include <murosimf/plugin/format.h>
#include <murosimf/plugin/sensor.h>

#include <fstream>
#include <iostream>

using namespace murosimf;

namespace {

struct CircleOptions {
  double speed = 0.1;      // [m/s]
  double radius = 1;       // [m]
  bool clockwise = false;  // seen from above
};

/// Walks in a circle: writes the command that the walk engine turns into joint targets.
class Circle final : public Algorithm {
 public:
  Circle(Setup& setup, const CircleOptions& options)
      : options_(options), command_(setup.write(properties::walk_command)[0]) {}

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { command_ = {}; }
  void step(const Instant&) noexcept override {
    const double turning = options_.speed / options_.radius;  // [rad/s]
    command_ = {options_.speed, 0, options_.clockwise ? -turning : turning};
  }

 private:
  CircleOptions options_;
  Vec3d& command_;  // [m/s, m/s, rad/s]
};

/// Defaults are those of the struct; units, bounds and meanings stand here, for scene files and `murosimf list options`.
const OptionTable<CircleOptions>& circle_options() {
  static const OptionTable<CircleOptions> table{
      {"speed", &CircleOptions::speed, "m/s", "forward", 0, 0.25},
      {"radius", &CircleOptions::radius, "m", "of the circle", 0.2, 100},
      {"clockwise", &CircleOptions::clockwise, "", "seen from above"},
  };
  return table;
}

void attach_circle(Simulation& simulation, Entity& robot, const catalog::ControllerOptions& options) {
  CircleOptions circle;
  circle_options().apply(options.own, circle);
  simulation.attach<Circle>("circle", robot, 20, circle);
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

/// A damped spring without friction, as on ice; explicit, for steps of 1 ms.
class Ice final : public collision::ContactLaw {
 public:
  using Points = std::span<collision::ContactPoint>;
  using Velocities = std::span<const Vec3d>;

  void prepare(std::vector<collision::ContactPoint>& points,
               const collision::ContactTerms& terms) const noexcept override {
    for (collision::ContactPoint& c : points) {
      collision::clear_force(c);
      c.last_normal_force = spring_force(terms.parameters[c.surface], c.depth, dot(c.velocity, c.normal));
      c.state = c.last_normal_force > 0 ? collision::ContactState::slip : collision::ContactState::open;
      c.force = c.last_normal_force * c.normal;
    }
  }
  [[nodiscard]] bool accept(Points, const collision::ContactTerms&, Velocities) const noexcept override {
    return true;  // the force does not depend on the velocity after the step
  }
  void commit(Points, const collision::ContactTerms&, Velocities) const noexcept override {}  // it remembers nothing
};

/// Its height above the plane z = 0.
class Altimeter final : public sensors::Sensor {
 public:
  Altimeter(Setup& setup, const sensors::SensorSpec& spec, const sensors::SensorSurroundings& surroundings)
      : Sensor(setup, spec, surroundings, {{"height", "m", {}}}), mounting_(setup, spec) {}

 private:
  void measure(std::span<double> values) noexcept override { values[0] = mounting_.position().z; }

  sensors::Mounting mounting_;
};

std::unique_ptr<sensors::Sensor> make_altimeter(Setup& setup, const sensors::SensorSpec& spec,
                                                const sensors::SensorSurroundings& surroundings) {
  return std::make_unique<Altimeter>(setup, spec, surroundings);
}

/// A robot that is a ball, from a file with two numbers: its radius [m] and its mass [kg].
robot_formats::RobotDescription read_lump(const std::filesystem::path& file, const robot_formats::ReaderOptions&) {
  double radius = 0, mass = 0;
  if (!(std::ifstream(file) >> radius >> mass && radius > 0 && mass > 0)) {
    throw SetupError(file.string() + ": two numbers above 0 are needed: a radius [m] and a mass [kg]");
  }
  robot_formats::BodyDescription ball;
  ball.name = "ball";
  ball.where = file.string();
  ball.solid = {mass, {}, mass * robot_formats::unit_inertia(Sphere{radius})};
  ball.shapes.emplace_back().placed.shape = Sphere{radius};
  robot_formats::RobotDescription robot;
  robot.name = "lump";
  robot.file = file;
  robot.bodies = {ball};
  return robot;
}

struct WeighOptions {
  std::string model;
  double gravity = 9.81;  // [m/s^2]
};

/// The first is the command's argument, the other is --gravity.
const OptionTable<WeighOptions>& weigh_options() {
  static const OptionTable<WeighOptions> table{
      {"model", &WeighOptions::model, "", "a robot file, or the name of one that comes with the program"},
      {"gravity", &WeighOptions::gravity, "m/s^2", "where it stands", 0, 1000},
  };
  return table;
}

int weigh(const OptionValues& given) {
  WeighOptions options;
  weigh_options().apply(given, options);
  const auto robot = robot::read_robot(files::find_data_file(options.model, "models", ".xml"));
  std::cout << robot.model->tree().mass * options.gravity << " N\n";
  return 0;
}

}  // namespace

extern "C" const char* murosimf_plugin_version() { return catalog::plugin_version; }

extern "C" void murosimf_register(catalog::Registries& registries) {
  registries.controllers.add({"circle", "walks in a circle", "", attach_circle, circle_options().infos()});
  registries.contacts.add({"ice",
                           "a damped spring without friction; explicit, for steps of 1 ms",
                           [](const OptionValues&) { return std::make_shared<Ice>(); },
                           {0.002, 0.001}});
  registries.sensors.add({"altimeter", "of the sensor: its height above the plane z = 0, world", "",
                          sensors::Watch::samples, make_altimeter});
  registries.formats.add({"lump", "a ball: two numbers, radius [m] and mass [kg]", ".lump", "", read_lump});
  registries.commands.add({"weigh", "Say what a robot weighs", weigh_options().infos(), 1, weigh});
}
