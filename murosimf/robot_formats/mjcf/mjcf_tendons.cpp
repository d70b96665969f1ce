#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"
#include "murosimf/robot_formats/mjcf/mjcf_joint_tendons.h"
#include "murosimf/robot_formats/mjcf/mjcf_spatial_tendons.h"
#include "murosimf/robot_formats/mjcf/mjcf_tendon_ties.h"

namespace murosimf::robot_formats::mjcf {
namespace {

MjcfAttributes own(const files::XmlElement& element) {
  MjcfAttributes attributes(element);
  attributes.overlay(element);
  return attributes;
}

struct Coupling {
  std::string leader;
  double ratio = 1;
};

/// Couplings of the robot's joints.
class Joints {
 public:
  Joints(const files::XmlElement& root, const MjcfDefaults& defaults, const MjcfCompiler& compiler,
         const MjcfNames& names)
      : names_(names) {
    for (const files::XmlElement& world : root.children("worldbody")) find_bent(world, "", defaults, compiler);
    for (const files::XmlElement& section : root.children("equality")) {
      for (const files::XmlElement& element : section.children("joint")) add(own(element));
    }
  }

  /// The joint at the end of the chain of leaders from `joint`, itself if it follows none, with the product of the ratios; nothing if L would
  /// have an offset.
  [[nodiscard]] std::optional<Coupling> leader_of(const std::string& joint) const {
    Coupling result{joint, 1};
    // At most as many steps as couplings: more are a circle.
    for (std::size_t steps = 0; steps <= couplings_.size(); ++steps) {
      if (!names_.is_joint(result.leader) || special_.contains(result.leader)) return std::nullopt;
      const auto next = couplings_.find(result.leader);
      if (next == couplings_.end()) return result;
      result = {next->second.leader, result.ratio * next->second.ratio};
    }
    return std::nullopt;  // a circle
  }

 private:
  /// Finds joints with a zero that is not their start, or with a spring that rests elsewhere.
  void find_bent(const files::XmlElement& body, const std::string& outer_class, const MjcfDefaults& defaults,
                 const MjcfCompiler& compiler) {
    const std::string child_class = defaults.child_class(body, outer_class);
    for (const MjcfChild& child : children_in(body, child_class, defaults, compiler)) {
      if (child.element.tag() == "body") find_bent(child.element, child.child_class, defaults, compiler);
      if (child.element.tag() != "joint") continue;
      const MjcfAttributes attributes = defaults.resolve(child.element, child.child_class);
      const auto name = child.element.attribute("name");
      if (name && (attributes.number("ref", 0) != 0 || attributes.number("springref", 0) != 0)) special_.insert(*name);
    }
  }

  void add(const MjcfAttributes& coupling) {
    if (!coupling.has("joint1") || !coupling.has("joint2") || coupling.text("active") == "false") return;
    const auto polynomial = coupling.numbers("polycoef", 1, 5);
    const std::string follower = coupling.text("joint1");
    if (!polynomial.empty() && polynomial[0] != 0) special_.insert(follower);
    couplings_[follower] = {coupling.text("joint2"), polynomial.size() > 1 ? polynomial[1] : 1};
  }

  const MjcfNames& names_;
  std::map<std::string, Coupling> couplings_;  // by follower
  std::set<std::string> special_;
};

std::optional<MjcfTendon> read_tendon(const files::XmlElement& element, const MjcfDefaults& defaults,
                                      const MjcfCompiler& compiler, const Joints& joints) {
  const MjcfAttributes settings = defaults.resolve(element);
  // The joint's own actuators have another limit.
  if (is_limited(settings, "actuatorfrclimited", "actuatorfrcrange", compiler)) return std::nullopt;
  // Two different lengths are a dead band, which a linear spring at the joint does not have.
  const auto lengths = settings.numbers("springlength", 1, 2);
  if (lengths.size() == 2 && lengths[0] != lengths[1]) return std::nullopt;
  MjcfTendon tendon{element, {}, 0, {}};
  for (const files::XmlElement& part : element.children("joint")) {
    const MjcfAttributes attributes = own(part);
    const auto leader = joints.leader_of(attributes.text("joint"));
    if (!leader || (!tendon.joint.empty() && tendon.joint != leader->leader)) return std::nullopt;
    tendon.joint = leader->leader;
    tendon.gear += attributes.number("coef", 1) * leader->ratio;
  }
  return tendon.gear == 0 ? std::nullopt : std::optional(tendon);
}

/// One over several joints or through sites, which gets a joint of its own.
std::optional<MjcfTendon> read_over_joints(const files::XmlElement& element, const std::string& name,
                                           const MjcfNames& names) {
  const bool spatial = element.tag() == "spatial";
  MjcfTendon tendon{element, names.is_joint(name) ? name + ".tendon" : name, 1, {}};
  if (spatial) tendon.path = path_of_tendon(element, names);
  if (!spatial) tendon.parts = joints_of_tendon(element, names);
  return tendon.has_slider() ? std::optional(tendon) : std::nullopt;
}

/// Adds a second spring at the joint: stiffnesses add up, and the rest position is where both together have no torque.
void add_spring(const MjcfAttributes& attributes, double gear, robot_formats::JointDescription& joint) {
  const double stiffness = gear * gear * tendon_number(attributes, "stiffness");
  if (stiffness == 0) return;
  const auto lengths = attributes.numbers("springlength", 1, 2);
  const double rest = lengths.empty() || lengths[0] < 0 ? 0 : lengths[0] / gear;
  const double sum = joint.stiffness + stiffness;
  joint.spring_reference = (joint.stiffness * joint.spring_reference + stiffness * rest) / sum;
  joint.stiffness = sum;
}

void add_limit(const MjcfAttributes& attributes, double gear, const MjcfCompiler& compiler,
               robot_formats::JointDescription& joint) {
  if (!is_limited(attributes, "limited", "range", compiler)) return;
  const auto range = attributes.numbers("range", 2, 2);
  MUROSIMF_ASSERT(gear != 0);
  auto [lowest, highest] = std::minmax({range[0] / gear, range[1] / gear});  // a negative gear swaps the ends
  if (joint.range) {
    lowest = std::max(lowest, joint.range->x);
    highest = std::min(highest, joint.range->y);
  }
  if (lowest > highest) {
    attributes.element().fail(
        fmt::format("no position of joint '{}' is within its own range and that of this tendon", joint.name));
  }
  joint.range = Vec3d{lowest, highest, 0};
}

}  // namespace

double tendon_number(const MjcfAttributes& attributes, const char* name) {
  const double number = attributes.number(name, 0);
  if (number < 0) attributes.source(name).fail(fmt::format("{} of tendon is negative; it must be at least 0", name));
  return number;
}

std::map<std::string, MjcfTendon> find_tendons(const files::XmlElement& root, const MjcfDefaults& defaults,
                                               const MjcfCompiler& compiler, const MjcfNames& names) {
  std::map<std::string, MjcfTendon> tendons;
  const Joints joints(root, defaults, compiler, names);
  const std::set<std::string> tied = tied_tendons(root);
  for (const files::XmlElement& section : root.children("tendon")) {
    for (const files::XmlElement& element : section.children()) {
      const auto name = element.attribute("name");
      const bool is_tied = name && tied.contains(*name);
      std::optional<MjcfTendon> tendon;
      if (element.tag() == "fixed" && !is_tied) tendon = read_tendon(element, defaults, compiler, joints);
      if (!tendon) tendon = read_over_joints(element, name.value_or(fmt::format("tendon.{}", tendons.size())), names);
      if (!tendon) continue;
      tendon->tied = is_tied;
      tendons.emplace(name.value_or(element.where()), *tendon);
    }
  }
  return tendons;
}

void apply_tendons(const std::map<std::string, MjcfTendon>& tendons, const MjcfDefaults& defaults,
                   const MjcfCompiler& compiler, robot_formats::RobotDescription& description) {
  for (const auto& [name, tendon] : tendons) {
    if (tendon.has_slider()) continue;
    const MjcfAttributes attributes = defaults.resolve(tendon.element);
    for (robot_formats::BodyDescription& body : description.bodies) {
      const auto joint = std::ranges::find(body.joints, tendon.joint, &robot_formats::JointDescription::name);
      if (joint == body.joints.end()) continue;
      // Powers of the gear: stiffness, damping and inertia are quadratic, forces linear.
      add_spring(attributes, tendon.gear, *joint);
      joint->damping += tendon.gear * tendon.gear * tendon_number(attributes, "damping");
      joint->friction += std::abs(tendon.gear) * tendon_number(attributes, "frictionloss");
      joint->armature += tendon.gear * tendon.gear * tendon_number(attributes, "armature");
      add_limit(attributes, tendon.gear, compiler, *joint);
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf
