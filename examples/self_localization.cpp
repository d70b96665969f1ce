// Errors of a robot's estimated pose on the field, which it computes from the lines that its camera sees.
//
// <!-- not run (example_self_localization  ): takes minutes -->
//     example_self_localization                        # a table over thirteen seeds; takes minutes
//     example_self_localization 3                      # one run of 3 s each
//     example_self_localization localization.png 0.1   # the particles at a time [s], as in the paper's Fig. 7
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <murosimf/files/output_file.h>
#include <murosimf/render/field_picture.h>
#include <murosimf/scene/scene.h>
#include <murosimf/scene_file/field.h>
#include <murosimf/soccer/behavior_properties.h>
#include <murosimf/soccer/localize.h>

using namespace murosimf;
using namespace std::chrono_literals;

namespace {

constexpr double near_enough = 0.2;  // [m]
constexpr double time_to_find = 2;   // [s] errors count from then on
constexpr Color dark_blue{0, 0, 0.5}, blue{0.2, 0.55, 1}, red{0.95, 0.1, 0.1}, yellow{1, 0.9, 0.1};

/// What the camera of a run is like.
struct Setting {
  const char* name;
  std::vector<std::string> overrides;
};

const std::vector<Setting> settings{
    {"plain", {}},
    {"blurred and noisy",
     {"robot.sensors.camera.blur=1.5", "robot.sensors.camera.shot_noise=0.03", "robot.sensors.camera.read_noise=0.01"}},
    {"distorted, mounted 2 deg off",
     {"robot.sensors.camera.k1=-0.25", "robot.sensors.camera.k2=0.05",
      "robot.sensors.camera.mounting_error_deg=[0,2,0]"}},
};

/// x, y and heading, true values.
Vec3d truth(Entity& robot) {
  const Vec3d place = robot.base().get(properties::position);
  return {place.x, place.y, heading(robot.base().get(properties::orientation))};
}

struct Errors {
  std::vector<double> place, heading;  // [m], [rad]; of all instants
  std::vector<double> found;           // [s] by run: from then on the place was near enough for a second
};

/// Makes one run. [s] `duration`; 0: the scene's.
void run(const Setting& setting, std::uint64_t seed, double duration, Errors& errors) {
  scene::Scene scene("self_localization", {.seed = seed, .overrides = setting.overrides});
  if (duration == 0) duration = scene.spec().duration;
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("robot");
  double near_since = 0, found = std::numeric_limits<double>::infinity();
  while (simulation.now() < from_seconds(duration)) {
    simulation.run(50ms);
    const double now = seconds(simulation.now());
    const Vec3d is = truth(robot), believed = robot.base().get(properties::pose_estimate);
    const double away = std::hypot(believed.x - is.x, believed.y - is.y);
    if (away > near_enough) near_since = now;
    if (now >= near_since + 1) found = std::min(found, near_since);
    if (now <= time_to_find) continue;
    errors.place.push_back(away);
    errors.heading.push_back(std::abs(soccer::wrapped(believed.z - is.z)));
  }
  errors.found.push_back(found);
}

/// Mean, median, what 95 % are below, largest.
void print(std::vector<double> numbers, double unit, const char* format) {
  if (numbers.empty()) return;
  std::sort(numbers.begin(), numbers.end());
  const auto count = static_cast<double>(numbers.size());
  const auto share = [&](double part) { return unit * numbers[static_cast<std::size_t>(part * (count - 1))]; };
  double sum = 0;
  for (const double number : numbers) sum += number;
  std::printf(format, unit * sum / count, share(0.5), share(0.95), share(1));
}

void print_row(const char* camera, const char* seed, const Errors& errors) {
  std::printf("%-29s %4s  ", camera, seed);
  print(errors.place, 1, "%.3f  %.3f   %.3f  %.3f    ");
  print(errors.heading, 180 / pi, "%5.1f  %5.1f   %5.1f  %5.1f    ");
  std::printf("%5.1f\n", *std::max_element(errors.found.begin(), errors.found.end()));
  std::fflush(stdout);
}

void append(std::vector<double>& all, const std::vector<double>& some) {
  all.insert(all.end(), some.begin(), some.end());
}

/// Every seed, then all of them together. No seed is left out.
void print_table(double duration) {
  std::printf(
      "                                    position [m]                     heading [deg]                   within "
      "%.1f m\n"
      "camera                        seed  mean   median  95 %%   largest   mean  median   95 %%  largest     after "
      "[s]\n",
      near_enough);
  const std::uint64_t runs = duration == 0 ? 13 : 1;
  for (const Setting& setting : settings) {
    Errors all;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      Errors errors;
      run(setting, seed, duration, errors);
      print_row(setting.name, std::to_string(seed).c_str(), errors);
      append(all.place, errors.place);
      append(all.heading, errors.heading);
      append(all.found, errors.found);
    }
    print_row(setting.name, "all", all);
  }
}

/// Particles red, the estimate dark blue, the truth blue, points on lines yellow.
void draw(const std::string& file, double time) {
  scene::Scene scene("self_localization");
  scene.simulation().run(from_seconds(time));
  Entity& robot = scene.simulation().world().entity("robot");
  const soccer::Particles& particles = robot.base().get(soccer::possible_poses);
  const Vec3d believed = robot.base().get(properties::pose_estimate);
  render::Overlay overlay;
  for (const soccer::Particle& particle : particles.all) overlay.arrows.push_back({particle.pose, 0.18, red});
  for (const soccer::LinePoint& point : particles.points) {
    overlay.circles.push_back({soccer::from_frame(believed, point.place), 0.02, yellow, true});
  }
  overlay.arrows.push_back({truth(robot), 0.5, blue});
  overlay.arrows.push_back({believed, 0.4, dark_blue});
  char title[80];
  std::snprintf(title, sizeof title, "%s: %.1f s", scene.spec().name.c_str(), time);
  files::write_file(file, render::field_picture_png(scene_file::field_markings(scene_file::kid_size_2008), {},
                                                    {.pixels_per_meter = 100, .title = title, .overlay = overlay}));
}

}  // namespace

int main(int argc, char** argv) try {
  const double number = argc > 1 ? std::atof(argv[argc - 1]) : 0;
  if (argc > 2) {
    draw(argv[1], number);
  } else {
    print_table(number);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
