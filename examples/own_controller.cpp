// Control software as a class of the program: a robot waves, what its IMU feels is printed, and the run is recorded and read back.
//
//     example_own_controller wave.mcap
#include <cmath>
#include <cstdio>
#include <memory>

#include <murosimf/recording.h>

namespace {

/// Waves with one joint.
class Wave final : public murosimf::Controller {
 public:
  explicit Wave(std::size_t joint) : joint_(joint) {}
  void step(murosimf::ControlCycle& cycle) override { cycle.joint_target[joint_] = 0.8 * std::sin(6 * cycle.time); }

 private:
  std::size_t joint_;
};

}  // namespace

int main(int count, char** arguments) {
  using namespace murosimf;
  Scene scene = Scene::of_robot("kid21");
  Robot robot = scene.robot();
  std::size_t shoulder = 0;
  while (robot.joints()[shoulder].name != "j_l_upper_arm" && shoulder + 1 < robot.joints().size()) ++shoulder;
  robot.set_controller(std::make_shared<Wave>(shoulder), 100);

  const char* file = count > 1 ? arguments[1] : nullptr;
  std::unique_ptr<Recorder> recorder;
  if (file) recorder = std::make_unique<Recorder>(scene, file);
  const Sensor imu = robot.sensor("imu");
  for (int i = 0; i < 4; ++i) {
    scene.run(0.25);
    const auto f = imu.values("accelerometer");  // [m/s^2] axes of the sensor
    std::printf("%.2f s: joint at %+.2f rad, the IMU feels (%+.1f, %+.1f, %+.1f) m/s^2\n", scene.time(),
                robot.joint_position()[shoulder], f[0], f[1], f[2]);
  }
  if (!recorder) return 0;
  recorder->finish();
  const auto series = Recording(file).series("robot." + robot.joints()[shoulder].name + ".joint_position");
  std::printf("recorded: %zu values of %s\n", series.at(0).values.size(), series.at(0).name.c_str());
}
