#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot/body_names.h"
#include "murosimf/robot/robot_checks.h"
#include "murosimf/robot/robot_soles.h"

namespace murosimf::robot {
namespace {

constexpr double mass_difference = 0.01;     // [1] of the mass; rounding in files is smaller
constexpr double center_difference = 0.003;  // [m]
constexpr double range_difference = 0.02;    // [rad | m]

Vec3d mirrored(const Vec3d& v) { return {v.x, -v.y, v.z}; }

void compare_masses(const robot_formats::BodyDescription& left, const robot_formats::BodyDescription& right,
                    std::vector<Finding>& findings) {
  const double larger = std::max(left.solid.mass, right.solid.mass);
  if (std::abs(left.solid.mass - right.solid.mass) <= mass_difference * larger) return;
  findings.push_back(
      {Severity::warning, right.solid_where.empty() ? right.where : right.solid_where,
       fmt::format("'{}' weighs {:.4g} kg, '{}' {:.4g} kg", right.name, right.solid.mass, left.name, left.solid.mass),
       "correct one of them, unless the robot is like that"});
}

void compare_centers(const robot_formats::BodyDescription& left, const robot_formats::BodyDescription& right,
                     const Transformd& at_left, const Transformd& at_right, std::vector<Finding>& findings) {
  const Vec3d l = at_left.position + at_left.orientation * left.solid.center;
  const Vec3d r = at_right.position + at_right.orientation * right.solid.center;
  const double apart = norm(mirrored(l) - r);
  // Left is mirrored at the plane y = 0 of the base.
  if (!(left.solid.mass > 0) || !(right.solid.mass > 0) || apart <= center_difference) return;
  findings.push_back(
      {Severity::warning, right.solid_where.empty() ? right.where : right.solid_where,
       fmt::format("the centers of mass of '{}' and '{}' are {:.2g} m from being each other's mirror image", left.name,
                   right.name, apart),
       "compare both, a sign may be wrong"});
}

/// Ranges of a left and a right joint are equal, or negated and swapped where the axes are mirrored.
void compare_ranges(const robot_formats::JointDescription& left, const robot_formats::JointDescription& right,
                    std::vector<Finding>& findings) {
  if (left.range.has_value() != right.range.has_value()) {
    findings.push_back({Severity::warning, right.where,
                        fmt::format("only one of joints '{}' and '{}' has a range", left.name, right.name),
                        "write it for both"});
    return;
  }
  if (!left.range) return;
  const Vec3d& l = *left.range;
  const Vec3d& r = *right.range;
  const bool same = std::abs(l.x - r.x) <= range_difference && std::abs(l.y - r.y) <= range_difference;
  const bool negated = std::abs(l.x + r.y) <= range_difference && std::abs(l.y + r.x) <= range_difference;
  if (same || negated) return;
  findings.push_back({Severity::warning, right.where,
                      fmt::format("joint '{}' reaches from {:.4g} to {:.4g}, '{}' from {:.4g} to {:.4g}", right.name,
                                  r.x, r.y, left.name, l.x, l.y),
                      "compare both, one may be wrong"});
}

}  // namespace

std::vector<Finding> examine_symmetry(const robot_formats::RobotDescription& description) {
  std::map<std::string, std::size_t> bodies;
  std::map<std::string, const robot_formats::JointDescription*> joints;
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    bodies[description.bodies[i].name] = i;
    for (const robot_formats::JointDescription& joint : description.bodies[i].joints) joints[joint.name] = &joint;
  }
  std::vector<Finding> findings;
  const auto places = robot::body_places(description);
  MUROSIMF_ASSERT(places.size() == description.bodies.size());
  for (std::size_t l = 0; l < description.bodies.size(); ++l) {
    const auto twin = bodies.find(robot::right_name(description.bodies[l].name));
    if (twin == bodies.end()) continue;
    compare_masses(description.bodies[l], description.bodies[twin->second], findings);
    compare_centers(description.bodies[l], description.bodies[twin->second], places[l], places[twin->second], findings);
  }
  for (const auto& [name, joint] : joints) {
    const auto twin = joints.find(robot::right_name(name));
    if (twin != joints.end()) compare_ranges(*joint, *twin->second, findings);
  }
  return findings;
}

}  // namespace murosimf::robot
