#include "murosimf/robot_formats/mjcf/mjcf_actuator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_gains.h"
#include "murosimf/robot_formats/mjcf/mjcf_schema.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// A range from lowest to highest.
struct Limits {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
};

Limits scaled(double factor, double offset, const std::vector<double>& range) {
  MUROSIMF_ASSERT(range.size() == 2);
  const auto [lowest, highest] = std::minmax({offset + factor * range[0], offset + factor * range[1]});
  return {lowest, highest};
}

Limits clamped(const Limits& limits, const Limits& by) {
  MUROSIMF_ASSERT(by.lowest <= by.highest);
  return {std::clamp(limits.lowest, by.lowest, by.highest), std::clamp(limits.highest, by.lowest, by.highest)};
}

class ActuatorReader {
 public:
  /// `moment`: length of the transmission per position of the joint; 1 for a joint.
  ActuatorReader(const MjcfAttributes& attributes, const MjcfGains& gains, double moment, const MjcfCompiler& compiler)
      : attributes_(attributes), gains_(gains), compiler_(compiler) {
    const auto gears = attributes.numbers("gear", 1, 6);
    gear_ = moment * (gears.empty() ? 1.0 : gears[0]);
  }

  [[nodiscard]] MjcfActuator read() const {
    MjcfActuator actuator;
    Servo& servo = actuator.servo;
    servo.type = attributes_.element().tag();
    servo.law = "ideal_pd";
    servo.position_gain = gear_ * gear_ * -gains_.bias[1] + 0.0;  // no -0, which would be written to files
    servo.velocity_gain = gear_ * gear_ * -gains_.bias[2] + 0.0;
    servo.command_filter = gains_.time_constant;
    actuator.damping_ratio = gains_.damping_ratio;
    set_torque(servo);
    set_target_range(actuator);
    return actuator;
  }

  [[nodiscard]] MjcfControl control(std::string joint) const {
    const double gain = per_target();
    // Without gain the control has no position that it could mean.
    if (gain == 0 || gains_.integrates) return {std::move(joint)};
    return {std::move(joint), gains_.bias[1] != 0, gains_.gain / gain, gains_.bias[0] / gain};
  }

 private:
  [[nodiscard]] bool is_motor() const { return gains_.bias[1] == 0 && gains_.bias[2] == 0; }
  /// [N m per rad or rad/s, at the actuator] Gain of position or rate; 0: a motor, or no gain at all.
  [[nodiscard]] double per_target() const { return -(gains_.bias[1] != 0 ? gains_.bias[1] : gains_.bias[2]) * gear_; }
  [[nodiscard]] bool holds_control() const { return is_limited(attributes_, "ctrllimited", "ctrlrange", compiler_); }

  void set_torque(Servo& servo) const {
    Limits limits;
    // The control of a motor is its torque.
    if (is_motor() && holds_control()) limits = scaled(gains_.gain, 0, attributes_.numbers("ctrlrange", 2, 2));
    if (is_limited(attributes_, "forcelimited", "forcerange", compiler_)) {
      limits = clamped(limits, scaled(1, 0, attributes_.numbers("forcerange", 2, 2)));
    }
    if (std::isfinite(limits.lowest)) {
      set_torque_range(servo, gear_ * limits.lowest, gear_ * limits.highest);
    }
  }

  void set_target_range(MjcfActuator& actuator) const {
    if (is_motor() || per_target() == 0) return;
    if (gains_.inherited_range > 0) {
      actuator.inherited_range = gains_.inherited_range;
      actuator.per_range = gains_.gain / per_target();
    } else if (gains_.integrates) {
      set_range_of_activation(actuator);
    } else if (gains_.gain == 0) {  // the control has no effect
      const double rest = gains_.bias[0] / per_target();
      actuator.target_range = Vec3d{rest, rest, 0};
    } else if (holds_control()) {
      const auto [lowest, highest] =
          scaled(gains_.gain / per_target(), gains_.bias[0] / per_target(), attributes_.numbers("ctrlrange", 2, 2));
      actuator.target_range = Vec3d{lowest, highest, 0};
    }
  }

  /// Sets the target range of an integrated control: the integral replaces the control.
  void set_range_of_activation(MjcfActuator& actuator) const {
    if (!is_limited(attributes_, "actlimited", "actrange", compiler_)) return;
    const auto [lowest, highest] =
        scaled(gains_.gain / per_target(), gains_.bias[0] / per_target(), attributes_.numbers("actrange", 2, 2));
    actuator.target_range = Vec3d{lowest, highest, 0};
  }

  const MjcfAttributes& attributes_;
  const MjcfGains& gains_;
  const MjcfCompiler& compiler_;
  double gear_ = 1;
};

void add(MjcfActuator& actuator, const MjcfActuator& other) {
  Servo& servo = actuator.servo;
  const Servo& more = other.servo;
  // Only actuators of one kind add up exactly; the largest of each number is what the strongest one does.
  actuator.damping_ratio = std::max(actuator.damping_ratio, other.damping_ratio);
  if (more.stall_torque > servo.stall_torque) {
    servo.lowest_share = more.lowest_share;
    servo.highest_share = more.highest_share;
  }
  if (more.position_gain > servo.position_gain) {
    actuator.target_range = other.target_range;
    actuator.inherited_range = other.inherited_range;
    actuator.per_range = other.per_range;
    servo.command_filter = more.command_filter;
  }
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

/// Reader of the whole section.
class Reader {
 public:
  Reader(const MjcfDefaults& defaults, const MjcfCompiler& compiler, const MjcfNames& names,
         const std::map<std::string, MjcfTendon>& tendons, robot_formats::RobotDescription& description)
      : defaults_(defaults), compiler_(compiler), names_(names), tendons_(tendons), description_(description) {}

  void read(const files::XmlElement& element) {
    const auto name = element.attribute("name");
    if (name && !taken_.insert(*name).second)
      element.fail(fmt::format("actuator '{}' appears twice; rename one", *name));
    if (!is_actuator(element.tag())) return leave_out(element, fmt::format("a {} is not simulated", element.tag()));
    const MjcfAttributes attributes = defaults_.resolve(element);
    const MjcfGains gains = read_gains(defaults_.settings(element), element);
    if (!attributes.has("joint")) return read_at_tendon(attributes, gains);
    if (names_.is_elsewhere("joint", attributes.text("joint")))
      return leave_out(element, "its joint is not the robot's");
    if (!gains.obstacle.empty()) return leave_out(element, gains.obstacle);
    add_at(read_joint(attributes, names_), 1, attributes, gains);
  }

  [[nodiscard]] MjcfActuators result() && { return std::move(result_); }

 private:
  void read_at_tendon(const MjcfAttributes& attributes, const MjcfGains& gains) {
    const files::XmlElement& element = attributes.element();
    const auto tendon = tendons_.find(attributes.text("tendon"));
    if (tendon == tendons_.end()) return leave_out(element, why_without_joint(attributes));
    if (!gains.obstacle.empty()) return leave_out(element, gains.obstacle);
    if (gains.inherited_range > 0) return leave_out(element, "inheritrange of a tendon is not supported");
    if (gains.damping_ratio > 0) return leave_out(element, "dampratio at a tendon is not supported");
    add_at(tendon->second.joint, tendon->second.gear, attributes, gains);
  }

  void add_at(const std::string& joint, double moment, const MjcfAttributes& attributes, const MjcfGains& gains) {
    const files::XmlElement& element = attributes.element();
    if (gains.integrates) name_integral(element);
    const ActuatorReader reader(attributes, gains, moment, compiler_);
    result_.controls.push_back(reader.control(joint));
    // Controls have the order of the file, as keyframes need it: also those of actuators that are left out.
    const auto [place, fresh] = result_.by_joint.emplace(joint, reader.read());
    if (fresh) return;
    add(place->second, reader.read());
    description_.notes.push_back(files::one_line(fmt::format(
        "{}: joint '{}' has several actuators: of each gain and limit the largest counts, they have one target",
        element.where(), joint)));
  }

  void leave_out(const files::XmlElement& element, const std::string& reason) {
    description_.warnings.push_back(files::one_line(fmt::format("{}: actuator '{}' moves nothing: {}", element.where(),
                                                                element.attribute("name").value_or(""), reason)));
    result_.controls.emplace_back();
  }

  [[nodiscard]] static std::string why_without_joint(const MjcfAttributes& attributes) {
    constexpr std::array others{std::pair{"tendon", "a tendon"},
                                std::pair{"site", "a site"},
                                std::pair{"body", "a body"},
                                std::pair{"jointinparent", "a joint in its parent's frame"},
                                std::pair{"slidersite", "a crank"},
                                std::pair{"cranksite", "a crank"}};
    for (const auto& [word, what] : others) {
      if (attributes.has(word)) return fmt::format("it acts on {}, which is not simulated", what);
    }
    return "it has no joint; add joint=\"...\"";
  }

  void name_integral(const files::XmlElement& element) {
    description_.notes.push_back(files::one_line(
        fmt::format("{}: the control of this actuator is a rate in MuJoCo; here its joint has a target position",
                    element.where())));
  }

  const MjcfDefaults& defaults_;
  const MjcfCompiler& compiler_;
  const MjcfNames& names_;
  const std::map<std::string, MjcfTendon>& tendons_;
  robot_formats::RobotDescription& description_;
  std::set<std::string> taken_;
  MjcfActuators result_;
};

}  // namespace

MjcfActuators read_actuators(const files::XmlElement& root, const MjcfDefaults& defaults, const MjcfCompiler& compiler,
                             const MjcfNames& names, const std::map<std::string, MjcfTendon>& tendons,
                             robot_formats::RobotDescription& description) {
  Reader reader(defaults, compiler, names, tendons, description);
  for (const files::XmlElement& section : root.children("actuator")) {
    for (const files::XmlElement& element : section.children()) {
      reader.read(element);
    }
  }
  return std::move(reader).result();
}

void drop_idle_controls(MjcfActuators& actuators, robot_formats::RobotDescription& description) {
  std::set<std::string> known;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) known.insert(joint.name);
  }
  for (const robot_formats::TendonDescription& tendon : description.tendons) known.insert(tendon.joint.name);
  for (const auto& [joint, actuator] : actuators.by_joint) {
    if (known.contains(joint)) continue;
    description.warnings.push_back(
        files::one_line(fmt::format("{}: actuators of joint '{}' move nothing: it is neither a hinge nor a slide",
                                    description.file.string(), joint)));
  }
  for (MjcfControl& control : actuators.controls) {
    if (!known.contains(control.joint)) control = {};
  }
}

void set_torque_range(Servo& servo, double one, double other) {
  const auto [lowest, highest] = std::minmax(one, other);
  servo.stall_torque = std::max(std::abs(lowest), std::abs(highest));
  if (!(servo.stall_torque > 0)) return;
  servo.lowest_share = lowest / servo.stall_torque;
  servo.highest_share = highest / servo.stall_torque;
}

}  // namespace murosimf::robot_formats::mjcf
