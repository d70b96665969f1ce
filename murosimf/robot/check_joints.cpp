#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/loops.h"
#include "murosimf/robot/robot_checks.h"
#include "murosimf/robot_formats/tendon_path.h"

namespace murosimf::robot {
namespace {

constexpr std::size_t enough_joints = 6;  // fewer may be alike by chance
constexpr double alike = 0.75;            // [1] share of joints with the same number that is no coincidence
constexpr double full_turn = 6.3;         // [rad] a wider range is no limit

std::vector<const robot_formats::JointDescription*> joints_of(const robot_formats::RobotDescription& description) {
  std::vector<const robot_formats::JointDescription*> joints;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) joints.push_back(&joint);
  }
  return joints;
}

/// The text that most joints share, the first of them and their number; empty texts do not count.
struct Most {
  std::string text;
  const robot_formats::JointDescription* first = nullptr;
  std::size_t count = 0;
};

template <class F>
Most most_common(const std::vector<const robot_formats::JointDescription*>& joints, const F& text_of) {
  std::map<std::string, Most> found;
  for (const robot_formats::JointDescription* joint : joints) {
    const std::string text = text_of(*joint);
    if (text.empty()) continue;
    Most& most = found[text];
    if (most.count++ == 0) most = {text, joint, 1};
  }
  Most best;
  for (const auto& [text, most] : found) {
    if (most.count > best.count) best = most;
  }
  return best;
}

template <class F>
void examine_placeholders(const std::vector<const robot_formats::JointDescription*>& joints, const char* what,
                          const F& text_of, std::vector<Finding>& findings) {
  const Most most = most_common(joints, text_of);
  const auto needed =
      std::max(enough_joints, static_cast<std::size_t>(std::ceil(alike * static_cast<double>(joints.size()))));
  if (most.count < needed) return;
  MUROSIMF_ASSERT(most.first != nullptr);
  findings.push_back(
      {Severity::warning, most.first->where,
       fmt::format("{} of {} joints have the {} {}: a placeholder?", most.count, joints.size(), what, most.text),
       "write what the robot's joints can do"});
}

std::string range_text(const robot_formats::JointDescription& joint) {
  return joint.range ? fmt::format("{:.6g} to {:.6g}", joint.range->x, joint.range->y) : "";
}
std::string number_text(double number) { return number > 0 ? fmt::format("{:.6g}", number) : ""; }

void examine_ranges(const std::vector<const robot_formats::JointDescription*>& joints, std::vector<Finding>& findings) {
  for (const robot_formats::JointDescription* joint : joints) {
    if (!joint->range || joint->kind != Kind::revolute || joint->range->y - joint->range->x < full_turn) continue;
    findings.push_back({Severity::warning, joint->where,
                        fmt::format("joint '{}' may turn from {:.3g} to {:.3g} rad, more than once around", joint->name,
                                    joint->range->x, joint->range->y),
                        "write its real range, or none"});
  }
}

/// Joints without a drive that are not moved by a coupling, a tendon with an actuator or a loop either.
std::vector<std::string> idle_joints(const robot_formats::RobotDescription& description, const Model& model) {
  std::set<std::string> coupled;
  for (const robot_formats::MimicDescription& mimic : description.mimics) coupled.insert(mimic.joint);
  for (const robot_formats::TendonDescription& tendon : description.tendons) {
    if (!tendon.joint.servo) continue;
    for (const std::string& joint : robot_formats::joints_of(description, tendon)) coupled.insert(joint);
  }
  const auto loops = multibody::loops_of(model);
  std::vector<std::string> idle;
  for (const robot_formats::JointDescription* joint : joints_of(description)) {
    const int object = model.object_index(joint->name);
    const bool driven = model.find(properties::servo, object) != nullptr;
    if (driven || coupled.contains(joint->name) || multibody::is_in_loop(model, loops, object)) continue;
    idle.push_back(joint->name);
  }
  return idle;
}

}  // namespace

std::vector<Finding> examine_joints(const robot_formats::RobotDescription& description, const Model& model) {
  std::vector<Finding> findings;
  const auto joints = joints_of(description);
  if (const auto idle = idle_joints(description, model); !idle.empty()) {
    findings.push_back({Severity::warning, description.bodies[0].where,
                        fmt::format("no servo moves {}", fmt::join(idle, ", ")),
                        "add actuators, or [servos] in the TOML file beside the robot"});
  }
  examine_placeholders(joints, "range", range_text, findings);
  examine_placeholders(
      joints, "largest torque", [](const robot_formats::JointDescription& j) { return number_text(j.effort_limit); },
      findings);
  examine_placeholders(
      joints, "largest rate", [](const robot_formats::JointDescription& j) { return number_text(j.rate_limit); },
      findings);
  examine_ranges(joints, findings);
  return findings;
}

}  // namespace murosimf::robot
