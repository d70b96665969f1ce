// Recordings of a servo that is simulated: what a bench with a pendulum would write (docs/servos.md, "What to record").
//   example_record_servo FOLDER     writes the files of examples/data/recordings
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <murosimf/component_files/servo_table.h>
#include <murosimf/identification/bench_servo.h>
#include <murosimf/model/error.h>
#include <murosimf/multibody/servo/servo_pendulum.h>

using namespace murosimf;

namespace {

constexpr double mass = 0.5, length = 0.1;                    // [kg], [m] of the pendulum
constexpr double voltage = 7.4, offset = 0.02;                // [V] of the supply, [rad] of the mounting
constexpr double fine = 2.5e-4, period = 12.5e-3, lasts = 5;  // [s] of a step, between entries, of a recording
constexpr double encoder_step = 2 * 3.14159265358979 / 4096;  // [rad]

struct Course {
  const char* name;
  double gain;                          // P gain in the register
  std::function<double(double)> goal;   // [rad] at a time [s]
  std::function<bool(double)> enabled;  // torque, at a time [s]
};

std::string recording(const multibody::BenchServo& servo, double duty_per_gain, const Course& course) {
  char line[256];
  std::snprintf(
      line, sizeof line,
      "{\"comment\": \"simulated by examples/record_servo.cpp: servos/xl330_m4.toml\",\n"
      " \"mass\": %g, \"length\": %g, \"kp\": %g, \"motor\": \"xl330\", \"trajectory\": \"%s\",\n \"entries\": [",
      mass, length, course.gain, course.name);
  std::string text = line;
  const multibody::Bench<double> bench{.inertia = mass * length * length,
                                       .weight = mass * 9.80665 * length,
                                       .gain = duty_per_gain * course.gain};
  multibody::BenchState<double> state;
  const int every = static_cast<int>(std::lround(period / fine));
  for (int k = 0; k * fine <= lasts; ++k) {
    const double t = k * fine;
    if (k % every == 0) {
      std::snprintf(line, sizeof line,
                    "%s\n  {\"timestamp\": %.4f, \"position\": %.5f, \"speed\": %.3f, \"goal_position\": %.5f, "
                    "\"input_volts\": %g, \"torque_enable\": %s}",
                    k == 0 ? "" : ",", t, encoder_step * std::round(state.position / encoder_step), state.rate,
                    course.goal(t), voltage, course.enabled(t) ? "true" : "false");
      text += line;
    }
    const multibody::BenchInput<double> input{course.goal(t + fine / 2), voltage, course.enabled(t) ? 1.0 : 0.0};
    multibody::advance(servo, bench, input, fine, state);
  }
  return text + "\n ]}\n";
}

const Course courses[] = {{"lift_and_drop", 400, [](double t) { return t < 2.5 ? 1.2 : -1.2; },
                           [](double t) { return std::fmod(t, 2.5) < 1.3; }},
                          {"sin_sin", 200,
                           [](double t) { return 1.57 * std::sin(t) + 0.5 * std::sin(5 * t) * std::sin(2 * t); },
                           [](double) { return true; }},
                          {"up_and_down", 100, [](double t) { return 1.5 * std::sin(1.2 * t); },
                           [](double) { return true; }}};

}  // namespace

int main(int argc, char** argv) {
  try {
    const Servo type = component_files::read_servo("xl330_m4");
    const multibody::BenchServo servo = identification::bench_servo(type, offset);
    for (const Course& course : courses) {
      const std::string text = recording(servo, identification::duty_per_gain(type), course);
      std::printf("%s, gain %g: %zu bytes\n", course.name, course.gain, text.size());
      if (argc < 2) continue;
      std::filesystem::create_directories(argv[1]);
      std::ofstream(std::filesystem::path(argv[1]) / (std::string(course.name) + ".json")) << text;
    }
  } catch (const SetupError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
