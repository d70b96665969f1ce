// How hard a push a standing robot withstands: stiffly, and with a controller that reads its inertial sensor.
//
//     example_ankle_strategy             # a table
//     example_ankle_strategy push.png    # and both runs of one push as a plot
#include <cmath>
#include <cstdio>
#include <string>

#include <murosimf/collision/contact_properties.h>
#include <murosimf/logging/plot.h>
#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>
#include <murosimf/sensors/reading.h>

using namespace murosimf;
using namespace std::chrono_literals;

namespace {

constexpr Duration push_time = 1s, push_duration = 100ms, end = 4s;

/// What is seen of one run, every 5 ms.
struct Curves {
  std::vector<double> time, lean, gyroscope, ankle;  // [s], [rad], [rad/s], [rad]
};

double lean_of(Entity& robot) {
  const Vec3d up = robot.base().get(properties::orientation).z;
  return std::atan2(up.x, up.z);
}

/// Whether the robot still stands 3 s after a push [N s] forward on its trunk. "walk" stands stiffly.
bool stands(const std::string& controller, double impulse, Curves* curves = nullptr) {
  scene::Scene scene("nudge", {.overrides = {"events=[]", "robot.controller=" + controller}});
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("robot");
  const auto push = [&](double newtons) {
    robot.object("torso").set(properties::applied_force, {{}, {newtons, 0, 0}});
  };
  simulation.at(push_time, [&] { push(impulse / seconds(push_duration)); });
  simulation.at(push_time + push_duration, [&] { push(0); });
  while (simulation.now() < end) {
    simulation.run(5ms);
    if (!curves) continue;
    curves->time.push_back(seconds(simulation.now()));
    curves->lean.push_back(lean_of(robot));
    curves->gyroscope.push_back(sensors::find_reading(robot, "imu")->output("gyroscope")[1]);
    curves->ankle.push_back(robot.object("j_l_ankle").get(properties::joint_target));
  }
  return std::abs(lean_of(robot)) < 0.5;
}

/// [N s] that it just withstands, in steps of 0.02, forward (1) or backward (-1).
double largest(const std::string& controller, double direction) {
  double impulse = 1.5;
  while (stands(controller, direction * (impulse + 0.02))) impulse += 0.02;
  return impulse;
}

void plot(const std::string& file, double impulse) {
  Curves stiff, balancing;
  stands("walk", impulse, &stiff);
  stands("balance", impulse, &balancing);
  logging::write_plot(
      file,
      {.title = "A push of " + std::to_string(impulse).substr(0, 3) + " N s in the back",
       .x_label = "time [s]",
       .panels = {{.y_label = "lean [rad]",
                   .curves = {{"stiff", stiff.time, stiff.lean}, {"balancing", balancing.time, balancing.lean}}},
                  {.y_label = "gyroscope [rad/s]",
                   .curves = {{"stiff", stiff.time, stiff.gyroscope},
                              {"balancing", balancing.time, balancing.gyroscope}}},
                  {.y_label = "target of the ankle [rad]",
                   .curves = {{"stiff", stiff.time, stiff.ankle}, {"balancing", balancing.time, balancing.ankle}}}}});
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("largest push [N s]   forward  backward\n");
  for (const char* controller : {"walk", "balance"}) {
    std::printf("%-20s %8.2f  %8.2f\n", controller, largest(controller, 1), largest(controller, -1));
  }
  if (argc > 1) plot(argv[1], 2.1);
}
