#include "murosimf/studies/tuning_cases.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/data_path.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::studies {
namespace {

constexpr double lowest_friction = 0.5, highest_friction = 1.0;  // [1]
constexpr double largest_lean = 2 * pi / 180, largest_turn = 5 * pi / 180, largest_shift = 0.01;
constexpr double apart = 3;  // [m]

struct ModelError {
  double mass, gain;  // [1]
};
constexpr std::array model_errors{ModelError{1, 1}, ModelError{1.1, 1.1}, ModelError{0.9, 0.9}, ModelError{1.1, 0.9},
                                  ModelError{0.9, 1.1}};

void check_levels(const std::vector<std::string>& levels) {
  if (levels.empty()) throw SetupError("no level to try it at");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    (void)find_entry(catalog::levels(), "level", levels[i]);
    if (std::find(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(i), levels[i]) !=
        levels.begin() + static_cast<std::ptrdiff_t>(i))
      throw SetupError(fmt::format("level '{}' is named twice", levels[i]));
  }
}

TuningCase case_of(const RandomStream& random, std::size_t i) {
  // multiples of the golden section fill a range evenly, whatever their number, and have nothing to do with the errors' turns
  constexpr double golden = 0.6180339887498949;
  const double spread = std::fmod(0.5 + golden * static_cast<double>(i), 1.0);
  const ModelError& error = model_errors[i % model_errors.size()];
  // Eight numbers belong to each case: another one takes them from no other case.
  const std::uint64_t n = 8 * i;
  const double lean = random.uniform(n, 0, largest_lean), toward = random.uniform(n + 1, 0, 2 * pi);
  TuningCase one;
  one.friction = lowest_friction + spread * (highest_friction - lowest_friction);
  one.mass = error.mass;
  one.gain = error.gain;
  one.roll = lean * std::cos(toward);
  one.pitch = lean * std::sin(toward);
  one.heading = random.uniform(n + 2, -largest_turn, largest_turn);
  one.ball = {random.uniform(n + 3, -largest_shift, largest_shift),
              random.uniform(n + 4, -largest_shift, largest_shift), 0};
  // A double holds 52 bits exactly.
  one.zeros = static_cast<std::uint64_t>(random.uniform(n + 5, 0, 0x1p52));
  return one;
}

ModelPtr with_errors(const Model& model, const ModelError& error) {
  ConstantTable constants = model.constants();
  for (const int object : model.having(properties::mass)) {
    constants.set(properties::mass, object, error.mass * *model.find(properties::mass, object));
    if (const SymMat3d* inertia = model.find(properties::inertia, object))
      constants.set(properties::inertia, object, error.mass * *inertia);
  }
  for (const int joint : model.having(properties::servo)) {
    Servo servo = *model.find(properties::servo, joint);
    servo.position_gain *= error.gain;
    servo.velocity_gain *= error.gain;
    constants.set(properties::servo, joint, servo);
  }
  return std::make_shared<const Model>(model.with(std::move(constants)));
}

}  // namespace

std::vector<TuningCase> tuning_cases(const std::vector<std::string>& levels, std::size_t each, std::uint64_t seed,
                                     std::string_view stream) {
  check_levels(levels);
  const RandomStream random(seed, stream);
  std::vector<TuningCase> cases;
  for (const std::string& level : levels) {
    for (std::size_t i = 0; i < each; ++i) {
      cases.push_back(case_of(random, i));
      cases.back().level = level;
    }
  }
  return cases;
}

double zero_error(const TuningCase& one, std::size_t column) {
  return RandomStream(one.zeros, "tuning zeros").uniform(column, -1, 1);
}

double case_number(const TuningCase& one, std::size_t number) {
  return RandomStream(one.zeros, "tuning numbers").uniform(number, -1, 1);
}

double mean_and_worst(const std::vector<double>& costs, std::size_t levels) {
  MUROSIMF_ASSERT(levels > 0 && costs.size() >= levels && costs.size() % levels == 0);
  const std::size_t each = costs.size() / levels;
  double mean = 0, worst = -HUGE_VAL;
  for (std::size_t level = 0; level < levels; ++level) {
    double sum = 0;
    for (std::size_t i = 0; i < each; ++i) sum += costs[level * each + i];
    const double of_level = sum / static_cast<double>(each);
    mean += of_level / static_cast<double>(levels);
    worst = std::max(worst, of_level);
  }
  return 0.5 * (mean + worst);
}

VariedRobot::VariedRobot(const std::string& model, bool lenient)
    : file_(files::find_data_file(model, "models", ".xml")), lenient_(lenient) {
  const auto kind = std::make_shared<scene::Assets>()->robot(file_, {.lenient = lenient});
  model_ = kind->model;
  for (const ModelError& error : model_errors) {
    scene::RobotKind varied = *kind;
    if (error.mass != 1 || error.gain != 1) varied.model = with_errors(*model_, error);
    assets_.emplace(std::pair(error.mass, error.gain), assets_of(std::move(varied)));
  }
}

std::shared_ptr<scene::Assets> VariedRobot::assets(double mass, double gain) const { return assets_.at({mass, gain}); }

std::shared_ptr<const scene::RobotKind> VariedRobot::kind(double mass, double gain) const {
  return assets(mass, gain)->robot(file_, {.lenient = lenient_});
}

std::shared_ptr<scene::Assets> VariedRobot::assets_of(scene::RobotKind kind) const {
  auto assets = std::make_shared<scene::Assets>();
  assets->put(file_, {.lenient = lenient_}, std::move(kind));
  return assets;
}

scene_file::SceneSpec row_of_robots(const VariedRobot& robot, const TuningCase& one, std::size_t count) {
  MUROSIMF_ASSERT(count > 0);
  const bool leans = find_entry(catalog::levels(), "level", one.level).traits.dynamic;  // others always stand
  scene_file::SceneSpec spec;
  spec.name = "tuning";
  spec.field.goals = false;
  spec.field.friction = one.friction;
  for (std::size_t i = 0; i < count; ++i) {
    scene_file::RobotSpec each;
    each.name = fmt::format("r{}", i);
    each.model = robot.file().string();
    each.level = one.level;
    each.sensors.none = true;
    each.position = {0, apart * static_cast<double>(i), 0};
    each.heading = one.heading;
    each.roll = leans ? one.roll : 0;
    each.pitch = leans ? one.pitch : 0;
    spec.robots.push_back(each);
  }
  return spec;
}

}  // namespace murosimf::studies
