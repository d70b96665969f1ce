#include "murosimf/formats/mjcf/mjcf_actuator.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "murosimf/formats/mjcf/mjcf_schema.h"
#include "murosimf/model/error.h"

namespace murosimf::formats::mjcf {
namespace {

double largest(const std::vector<double>& range) { return std::max(std::abs(range[0]), std::abs(range[1])); }

double read_stall_torque(const MjcfAttributes& attributes, double gear, const MjcfCompiler& compiler) {
  if (is_limited(attributes, "forcelimited", "forcerange", compiler)) {
    return gear * largest(attributes.numbers("forcerange", 2, 2));
  }
  // the control of a motor is its torque
  const bool motor = attributes.element().tag() == "motor";
  if (motor && is_limited(attributes, "ctrllimited", "ctrlrange", compiler)) {
    return gear * largest(attributes.numbers("ctrlrange", 2, 2));
  }
  return 0;
}

/// Torque per angle and per rate; force = gainprm[0] u + biasprm . (1, length, velocity) for general actuators.
struct Gains {
  double position = 0, velocity = 0;
};

Gains read_gains(const MjcfAttributes& attributes) {
  const std::string& tag = attributes.element().tag();
  if (tag == "position") return {attributes.number("kp", 1.0), attributes.number("kv", 0.0)};
  if (tag == "velocity") return {0, attributes.number("kv", 1.0)};
  if (tag == "general" && attributes.text("biastype") == "affine") {
    auto bias = attributes.numbers("biasprm", 1, 10);
    bias.resize(3);
    return {0 - bias[1], 0 - bias[2]};  // no -0
  }
  return {};
}

double read_damping_ratio(const MjcfAttributes& attributes, double velocity_gain) {
  const double ratio = attributes.number("dampratio", 0);
  if (ratio < 0) attributes.source("dampratio").fail("dampratio is negative; it must be at least 0");
  if (ratio > 0 && velocity_gain > 0) attributes.element().fail("both kv and dampratio; keep one");
  if (ratio > 0 && attributes.element().tag() != "position") {
    attributes.source("dampratio").fail("dampratio belongs to position actuators; remove it");
  }
  return ratio;
}

MjcfActuator read_actuator(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  const auto gears = attributes.numbers("gear", 1, 6);
  const double gear = gears.empty() ? 1.0 : std::abs(gears[0]);
  const auto [position, velocity] = read_gains(attributes);
  if (position < 0 || velocity < 0) attributes.element().fail("a gain of this actuator is negative; correct it");
  Servo servo;
  servo.type = attributes.element().tag();
  servo.law = "ideal_pd";
  servo.stall_torque = read_stall_torque(attributes, gear, compiler);
  servo.position_gain = gear * gear * position;
  servo.velocity_gain = gear * gear * velocity;
  return {servo, read_damping_ratio(attributes, velocity)};
}

void add(MjcfActuator& actuator, const MjcfActuator& other) {
  Servo& servo = actuator.servo;
  const Servo& more = other.servo;
  actuator.damping_ratio = std::max(actuator.damping_ratio, other.damping_ratio);
  servo.stall_torque = std::max(servo.stall_torque, more.stall_torque);
  servo.position_gain = std::max(servo.position_gain, more.position_gain);
  servo.velocity_gain = std::max(servo.velocity_gain, more.velocity_gain);
}

std::string read_joint(const MjcfAttributes& attributes, const MjcfNames& names) {
  const std::string joint = attributes.text("joint");
  if (!names.is_joint(joint)) {
    const std::vector<std::string_view> known(names.joints().begin(), names.joints().end());
    attributes.source("joint").fail(unknown_name("joint", joint, known));
  }
  return joint;
}

}  // namespace

std::map<std::string, MjcfActuator> read_actuators(const files::XmlElement& root, const MjcfDefaults& defaults,
                                                   const MjcfCompiler& compiler, const MjcfNames& names, bool lenient,
                                                   std::vector<std::string>& warnings) {
  std::map<std::string, MjcfActuator> actuators;
  std::set<std::string> taken;
  for (const files::XmlElement& section : root.children("actuator")) {
    for (const files::XmlElement& element : section.children()) {
      if (!is_actuator(element.tag())) continue;
      const auto name = element.attribute("name");
      if (name && !taken.insert(*name).second)
        element.fail(fmt::format("actuator '{}' appears twice; rename one", *name));
      const MjcfAttributes attributes = defaults.resolve(element);
      if (attributes.has("joint")) {
        const MjcfActuator actuator = read_actuator(attributes, compiler);
        const auto [place, fresh] = actuators.emplace(read_joint(attributes, names), actuator);
        if (!fresh) add(place->second, actuator);
      } else if (lenient) {
        warnings.push_back(fmt::format("{}: actuator ignored: it moves no joint", element.where()));
      } else {
        element.fail("actuator without joint; add joint=\"...\"");
      }
    }
  }
  return actuators;
}

}  // namespace murosimf::formats::mjcf
