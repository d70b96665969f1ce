// The rule of docs/scenes.md, tried with every property at every level: what is set acts, is refused, or is warned about.
#include <cmath>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

#include "murosimf/io/registry.h"
#include "murosimf/io/scene.h"
#include "murosimf/model/properties.h"

namespace murosimf::io {
namespace {

using namespace std::chrono_literals;
using Columns = std::map<std::string, std::vector<double>>;

/// Stands still for 60 ms, so that every walk cycle begins at the same time.
class Trial {
 public:
  Trial(std::string level, std::string controller) : level_(std::move(level)), controller_(std::move(controller)) {}

  /// All columns after the run but `without`. Throws SetupError if the setting is refused.
  Columns run(const std::vector<std::string>& settings, std::string_view without) {
    SceneOptions options{.overrides = {"walker.sensors=false", "walker.level=" + level_, "duration=1",
                                       "walker.controller=" + controller_}};
    if (controller_ == "none") options.overrides.emplace_back("walker.command=[0,0,0]");
    options.overrides.insert(options.overrides.end(), settings.begin(), settings.end());
    Scene scene("walk", options);
    scene.simulation().run(60ms);
    warnings = scene.report({}).warnings;
    return numbers_of(scene.simulation().world().entity("walker"), without);
  }

  /// Names and numbers of what could be set, at the beginning.
  std::map<std::string, std::vector<double>> settable(const std::string& object) const {
    SceneOptions options{
        .overrides = {"walker.sensors=false", "walker.level=" + level_, "walker.controller=" + controller_}};
    Scene scene("walk", options);
    scene.simulation().initialize();
    Entity& robot = scene.simulation().world().entity("walker");
    std::map<std::string, std::vector<double>> found;
    for (const auto& entry : properties::catalog()) {
      const ColumnBase* column = entry.constant ? nullptr : robot.find(entry.info.name);
      if (!column || column->numbers() == 0) continue;
      if (column->info().scope != Scope::object && object != "pelvis") continue;
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

  std::string level_, controller_;
};

/// Other numbers that the property can have.
std::vector<double> changed(const std::string& property, std::vector<double> numbers) {
  if (property == "base_quaternion") return {std::cos(0.05), std::sin(0.05), 0, 0};
  if (property == "stance_foot" || property == "torque_enabled") return {1 - numbers[0]};
  for (double& number : numbers) number += property == "applied_force" ? 5 : 0.02;
  return numbers;
}

/// What is neither refused nor warned about nor changes any other number.
std::set<std::string> ignored_at(const std::string& level, const std::string& controller) {
  std::set<std::string> ignored;
  Trial trial(level, controller);
  for (const std::string object : {"pelvis", "j_l_shin", "l_shin"}) {
    for (const auto& [property, numbers] : trial.settable(object)) {
      const std::string setting =
          fmt::format("walker.{}.{}=[{}]", object, property, fmt::join(changed(property, numbers), ","));
      try {
        const Columns with = trial.run({setting}, property);
        const bool said = std::ranges::any_of(trial.warnings, [&](const std::string& warning) {
          return warning.find(property) != std::string::npos;
        });
        if (!said && with == trial.run({}, property)) ignored.insert(object + "." + property);
      } catch (const SetupError&) {
        continue;
      }
    }
  }
  return ignored;
}

TEST(Settings, ActOrAreRefusedOrWarnedAboutAtEveryLevel) {
  for (const Level& level : levels()) {
    for (const char* controller : {"walk", "none"}) {
      EXPECT_EQ(ignored_at(std::string(level.name), controller), std::set<std::string>{})
          << level.name << " " << controller;
    }
  }
}

}  // namespace
}  // namespace murosimf::io
