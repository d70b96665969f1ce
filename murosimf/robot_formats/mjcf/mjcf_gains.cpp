#include "murosimf/robot_formats/mjcf/mjcf_gains.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// The default actuator of a class, as MuJoCo stores it.
struct State {
  std::array<double, 10> gain{1}, bias{}, dynamics{1};
  std::string gain_type = "fixed", bias_type = "none", dynamics_type = "none";
  std::string shortcut;  ///< that set them last; empty: none
  double inherited_range = 0;
};

/// Attributes of one element alone, without those of its class.
MjcfAttributes own(const files::XmlElement& element) {
  MjcfAttributes attributes(element);
  attributes.overlay(element);
  return attributes;
}

/// Reads the first numbers of a row.
void read_row(const MjcfAttributes& attributes, const char* name, std::array<double, 10>& row) {
  std::ranges::copy(attributes.numbers(name, 1, row.size()), row.begin());
}

double positive_or_zero(const MjcfAttributes& attributes, const char* name, double otherwise) {
  const double number = attributes.number(name, otherwise);
  if (attributes.has(name) && number < 0) {
    attributes.source(name).fail(
        fmt::format("{} of {} is negative; it must be at least 0", name, attributes.element().tag()));
  }
  return number;
}

/// Begins a shortcut; gains of another one are reset.
void begin(const std::string& shortcut, State& state) {
  if (!state.shortcut.empty() && state.shortcut != shortcut) {
    state.gain = {1};
    state.bias = {};
  }
  state.shortcut = shortcut;
}

/// Sets the gains of a position actuator. biasprm[2] above zero is the damping ratio until the inertia is known, as in MuJoCo.
void set_position_gains(const MjcfAttributes& attributes, State& state) {
  const double kp = positive_or_zero(attributes, "kp", state.gain[0]);
  const double kv = positive_or_zero(attributes, "kv", 0), ratio = positive_or_zero(attributes, "dampratio", 0);
  if (kv > 0 && ratio > 0) attributes.element().fail("both kv and dampratio; keep one");
  state.gain[0] = kp;
  state.bias[1] = 0 - kp;  // no -0, which would be written to files
  if (attributes.has("kv")) state.bias[2] = 0 - kv;
  if (attributes.has("dampratio")) state.bias[2] = ratio;
  state.gain_type = "fixed";
  state.bias_type = "affine";
}

/// `range`: the attribute that the joint's range replaces.
void inherit_range(const MjcfAttributes& attributes, const char* range, State& state) {
  state.inherited_range = positive_or_zero(attributes, "inheritrange", state.inherited_range);
  if (state.inherited_range > 0 && attributes.has(range)) {
    attributes.element().fail(fmt::format("both {} and inheritrange; keep one", range));
  }
}

void set_position(const MjcfAttributes& attributes, State& state) {
  begin("position", state);
  set_position_gains(attributes, state);
  if (attributes.has("timeconst")) {
    state.dynamics[0] = positive_or_zero(attributes, "timeconst", 0);
    state.dynamics_type = state.dynamics[0] > 0 ? "filterexact" : "none";
  }
  inherit_range(attributes, "ctrlrange", state);
}

/// Sets a position actuator with a target that is the integral of its control.
void set_integrated_velocity(const MjcfAttributes& attributes, State& state) {
  begin("intvelocity", state);
  set_position_gains(attributes, state);
  state.dynamics_type = "integrator";
  inherit_range(attributes, "actrange", state);
}

void set_velocity(const MjcfAttributes& attributes, State& state) {
  begin("velocity", state);
  const double kv = positive_or_zero(attributes, "kv", state.gain[0]);
  state.gain[0] = kv;
  state.bias = {0, 0, 0 - kv};
  state.gain_type = "fixed";
  state.bias_type = "affine";
  state.dynamics_type = "none";
}

void set_motor(State& state) {
  begin("motor", state);
  state.gain = {1};
  state.bias = {};
  state.gain_type = "fixed";
  state.bias_type = state.dynamics_type = "none";
}

void set_general(const MjcfAttributes& attributes, State& state) {
  state.gain_type = attributes.text("gaintype", state.gain_type);
  state.bias_type = attributes.text("biastype", state.bias_type);
  state.dynamics_type = attributes.text("dyntype", state.dynamics_type);
  read_row(attributes, "gainprm", state.gain);
  read_row(attributes, "biasprm", state.bias);
  read_row(attributes, "dynprm", state.dynamics);
}

void apply(const files::XmlElement& element, State& state) {
  const MjcfAttributes attributes = own(element);
  const std::string tag = element.tag();
  // A range of the element itself revokes the inheritance of its class.
  if (attributes.has(tag == "intvelocity" ? "actrange" : "ctrlrange")) state.inherited_range = 0;
  if (tag == "position") set_position(attributes, state);
  if (tag == "velocity") set_velocity(attributes, state);
  if (tag == "motor") set_motor(state);
  if (tag == "intvelocity") set_integrated_velocity(attributes, state);
  if (tag == "general") set_general(attributes, state);
}

std::string obstacle_of(const State& state) {
  if (state.gain_type != "fixed") return fmt::format("gaintype '{}' is not simulated", state.gain_type);
  if (state.bias_type != "none" && state.bias_type != "affine") {
    return fmt::format("biastype '{}' is not simulated", state.bias_type);
  }
  const bool holds = state.bias_type == "affine" && state.bias[1] < 0;
  if (state.dynamics_type == "integrator" && holds) return {};
  const bool filter = state.dynamics_type == "filter" || state.dynamics_type == "filterexact";
  if (state.dynamics_type != "none" && !filter)
    return fmt::format("dyntype '{}' is not simulated", state.dynamics_type);
  if (filter && !(state.dynamics[0] > 0))
    return fmt::format("dynprm is {}; a filter needs a time constant", state.dynamics[0]);
  return {};
}

}  // namespace

MjcfGains read_gains(const std::vector<files::XmlElement>& settings, const files::XmlElement& actuator) {
  State state;
  for (const files::XmlElement& setting : settings) apply(setting, state);
  apply(actuator, state);
  MjcfGains gains{.gain = state.gain[0], .inherited_range = state.inherited_range, .obstacle = obstacle_of(state)};
  if (!gains.obstacle.empty()) return gains;
  gains.integrates = state.dynamics_type == "integrator";
  if (!gains.integrates && state.dynamics_type != "none") gains.time_constant = state.dynamics[0];
  if (state.bias_type != "affine") return gains;
  std::copy_n(state.bias.begin(), gains.bias.size(), gains.bias.begin());
  // MuJoCo's own test for a damping ratio: only position actuators have opposite gains.
  if (state.bias[2] > 0 && state.gain[0] == -state.bias[1]) {
    gains.damping_ratio = state.bias[2];
    gains.bias[2] = 0;
  }
  if (gains.bias[1] > 0 || gains.bias[2] > 0) actuator.fail("a gain of this actuator is negative; correct it");
  if (gains.bias[0] != 0 && gains.bias[1] == 0 && gains.bias[2] == 0) {
    gains.obstacle = "a constant force (biasprm[0]) without gains is not simulated";
  }
  return gains;
}

}  // namespace murosimf::robot_formats::mjcf
