// The rule of docs/scenes.md, tried with every property at every level: what is set acts, is refused, or is warned about.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/catalog/property_catalog.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using Columns = std::map<std::string, std::vector<double>>;

/// A robot, and objects of it: its base, joints, a link.
struct Subject {
  std::string model, level, controller;
  std::vector<std::string> objects;

  [[nodiscard]] std::vector<std::string> overrides() const {
    std::vector<std::string> all{"walker.sensors=false", "walker.model=" + model, "walker.level=" + level,
                                 "walker.controller=" + controller};
    if (controller == "none") all.emplace_back("walker.command=[0,0,0]");
    return all;
  }
};

/// Runs for 60 ms.
class Trial {
 public:
  explicit Trial(Subject subject) : subject_(std::move(subject)) {}

  /// All columns after the run but `without`. Throws SetupError if the setting is refused.
  Columns run(const std::vector<std::string>& settings, std::string_view without) {
    SceneOptions options{.overrides = subject_.overrides()};
    options.overrides.insert(options.overrides.end(), settings.begin(), settings.end());
    Scene scene("walk", options);
    scene.simulation().run(60ms);
    warnings = make_report(scene).warnings;
    return numbers_of(scene.simulation().world().entity("walker"), without);
  }

  /// Names and numbers of what could be set, at the beginning.
  std::map<std::string, std::vector<double>> settable(const std::string& object) const {
    Scene scene("walk", {.overrides = subject_.overrides()});
    scene.simulation().initialize();
    Entity& robot = scene.simulation().world().entity("walker");
    std::map<std::string, std::vector<double>> found;
    for (const auto& entry : properties::catalog()) {
      const ColumnBase* column = entry.constant ? nullptr : robot.find(entry.info.name);
      if (!column || column->numbers() == 0) continue;
      if (column->info().scope != Scope::object && object != subject_.objects.front()) continue;
      found[std::string(entry.info.name)] = robot.object(object).get(entry.info.name).numbers;
    }
    return found;
  }

  std::vector<std::string> warnings;

 private:
  static Columns numbers_of(const Entity& entity, std::string_view without) {
    Columns columns;
    for (const auto& [name, column] : entity.columns()) {
      if (name == without || column->info().scope == Scope::sensor) continue;
      const std::size_t rows =
          column->info().scope == Scope::object ? static_cast<std::size_t>(entity.model().size()) : 1;
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < column->numbers(); ++i) columns[name].push_back(column->get(row, i));
      }
    }
    return columns;
  }

  Subject subject_;
};

/// Other numbers that the property can have.
std::vector<double> changed(const std::string& property, std::vector<double> numbers) {
  if (property == "base_quaternion") return {std::cos(0.05), std::sin(0.05), 0, 0};
  if (property == "stance_foot" || property == "torque_enabled") return {1 - numbers[0]};
  if (property == "path_curvature") return {0.5};  // less is steered back in one cycle
  for (double& number : numbers) number += property == "applied_force" ? 5 : 0.02;
  return numbers;
}

/// What is neither refused nor warned about nor changes any other number.
std::set<std::string> ignored_of(const Subject& subject) {
  std::set<std::string> ignored;
  Trial trial(subject);
  for (const std::string& object : subject.objects) {
    for (const auto& [property, numbers] : trial.settable(object)) {
      const std::string setting =
          fmt::format("walker.{}.{}=[{}]", object, property, fmt::join(changed(property, numbers), ","));
      try {
        const Columns with = trial.run({setting}, property);
        const bool said = std::ranges::any_of(trial.warnings, [&, &name = property](const std::string& warning) {
          return warning.find(name) != std::string::npos;
        });
        if (!said && with == trial.run({}, property)) ignored.insert(object + "." + property);
      } catch (const SetupError&) {
        continue;  // refused
      }
    }
  }
  return ignored;
}

void expect_nothing_ignored(const Subject& subject) {
  EXPECT_EQ(ignored_of(subject), std::set<std::string>{})
      << subject.model << " at " << subject.level << " with " << subject.controller;
}

TEST(Settings, ActOrAreRefusedOrWarnedAboutAtEveryLevel) {
  for (const catalog::LevelType& level : catalog::levels()) {
    for (const char* controller : {"walk", "none"}) {
      expect_nothing_ignored({"kid21", std::string(level.name), controller, {"pelvis", "j_l_shin", "l_shin"}});
    }
  }
}

TEST(Settings, ActOrAreRefusedOrWarnedAboutOnWheels) {
  for (const char* level : {"full_dynamics", "articulated_dynamics"}) {
    for (const char* controller : {"drive", "none"}) {
      expect_nothing_ignored({"car", level, controller, {"chassis", "steer_left", "turn_rear_left"}});
    }
  }
}

/// An arm on a heavy base, with a servo that has everything and one that has little.
std::string write_arm() {
  const std::string stem = fmt::format("{}settings_arm_{}", testing::TempDir(), getpid());
  std::ofstream(stem + ".xml") << R"(<mujoco><worldbody><body name="base" pos="0 0 1"><freejoint/><geom size=".1"/>
<body name="upper" pos="0 .2 0"><joint name="shoulder" axis="0 1 0"/><geom size=".05" pos=".1 0 0"/>
<body name="lower" pos=".2 0 0"><joint name="elbow" axis="0 1 0"/><geom size=".05" pos=".1 0 0"/>
</body></body></body></worldbody></mujoco>)";
  std::ofstream(stem + ".toml") << R"([servos.warm]
type = "mx106"
backlash = 0.02
heat_capacity = 60
thermal_resistance = 4
command_period = 0.01
joints = ["shoulder"]
[servos.plain]
stall_torque = 6
no_load_speed = 6
position_gain = 30
rotor_inertia = 0.01
coulomb_friction = 0.05
joints = ["elbow"]
)";
  return stem + ".xml";
}

TEST(Settings, ActOrAreRefusedOrWarnedAboutWithServosOfAllKinds) {
  const std::string arm = write_arm();
  expect_nothing_ignored({arm, "articulated_dynamics", "none", {"base", "shoulder", "elbow", "lower"}});
}

}  // namespace
}  // namespace murosimf::scene
