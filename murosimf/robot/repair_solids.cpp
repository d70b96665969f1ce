#include "murosimf/robot/repair_solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"

namespace murosimf::robot {
namespace {

using robot_formats::BodyDescription;
using robot_formats::RobotDescription;

constexpr double water = 1000;         // [kg/m^3]
constexpr double a_point = 1e-12;      // [kg m^2] largest moment of a point: rounding of zero
constexpr double placeholder = 1e-12;  // [kg, kg m^2] mass and largest moment in place of none
constexpr double rod = 1e-12;          // [1] smallest moment over the largest: that of a rod
constexpr double wrong = -1e-6;        // [1] the same: more than rounding to six digits
constexpr double thickened = 1e-3;     // [1] the same, after a repair

/// [kg m^2] of a homogeneous sphere of water: 2/5 m r^2.
// Of a homogeneous sphere: no density is known, and robots are about as dense as water.
double inertia_of_sphere(double mass) {
  const double radius = std::cbrt(3 * mass / (4 * std::numbers::pi * water));
  return std::max(least_inertia, 0.4 * mass * radius * radius);
}

std::string line(const BodyDescription& body, const std::string& what) {
  const std::string& where = body.solid_where.empty() ? body.where : body.solid_where;
  return files::one_line(fmt::format("{}: {}", where, what));
}

std::string without(const BodyDescription& body, const char* what, const std::string& taken) {
  return line(body, fmt::format("link '{}' moves without {}: {} taken; write its {}", body.name, what, taken, what));
}

/// Gives mass to a body that has only inertia.
void give_mass(BodyDescription& body, RobotDescription& description) {
  if (body.solid.mass > 0 || !(robot_formats::principal_moments(body.solid.inertia).z > 0)) return;
  body.solid.mass = least_mass;
  description.notes.push_back(without(body, "mass", fmt::format("{:.2g} kg is", least_mass)));
}

/// Removes what the converter writes for bodies without mass, because other programs need one.
void forget_placeholder(robot_formats::MassProperties& solid) {
  if (solid.mass <= placeholder && robot_formats::principal_moments(solid.inertia).z <= placeholder) solid = {};
}

void give_sphere(BodyDescription& body, RobotDescription& description) {
  const double inertia = inertia_of_sphere(body.solid.mass);
  body.solid.inertia = diagonal(inertia);
  description.notes.push_back(
      without(body, "inertia",
              fmt::format("{:.2g} kg m^2, of a sphere of water of its {:.4g} kg, is", inertia, body.solid.mass)));
}

/// For a body without any positive moment.
void replace_by_sphere(BodyDescription& body, const Vec3d& moments, RobotDescription& description) {
  body.solid.inertia = diagonal(inertia_of_sphere(body.solid.mass));
  description.warnings.push_back(
      line(body, fmt::format("no principal moment of link '{}' is positive ({:.3g} {:.3g} {:.3g} kg m^2): {:.2g}, of a "
                             "sphere of water of its {:.4g} kg, is taken; correct it",
                             body.name, moments.x, moments.y, moments.z, body.solid.inertia.xx, body.solid.mass)));
}

void make_definite(BodyDescription& body, RobotDescription& description) {
  const Vec3d moments = robot_formats::principal_moments(body.solid.inertia);
  if (body.solid.mass == 0 || moments.x > rod * moments.z) return;
  const bool is_wrong = moments.x < std::min(wrong * moments.z, -a_point);
  if (moments.z <= a_point && !is_wrong) return give_sphere(body, description);
  if (moments.z <= 0) return replace_by_sphere(body, moments, description);
  const double least = std::max(moments.z - moments.y, thickened * moments.z);
  // The triangle inequality bounds the least moment from below.
  body.solid.inertia = robot_formats::with_least_moment(body.solid.inertia, least);
  auto& lines = is_wrong ? description.warnings : description.notes;
  lines.push_back(
      line(body, fmt::format("inertia of link '{}' is not positive definite (smallest principal moment {:.3g} "
                             "kg m^2): {:.3g} is taken; correct it",
                             body.name, moments.x, least)));
}

/// Gives mass to moving bodies that carry none, with all bodies behind them. robot_builder.cpp refuses a robot without any mass.
void give_masses(RobotDescription& description) {
  std::vector<double> behind;  // [kg] by body
  for (const BodyDescription& body : description.bodies) behind.push_back(body.solid.mass);
  for (std::size_t i = description.bodies.size(); i-- > 1;) {
    BodyDescription& body = description.bodies[i];
    MUROSIMF_ASSERT(description.bodies[i].parent >= 0 && description.bodies[i].parent < static_cast<int>(i));
    if (!body.joints.empty() && behind[i] == 0) {
      behind[i] = body.solid.mass = least_mass;
      body.solid.inertia = diagonal(least_inertia);
      description.notes.push_back(
          without(body, "mass", fmt::format("{:.2g} kg and {:.2g} kg m^2 are", least_mass, least_inertia)));
    }
    behind[static_cast<std::size_t>(body.parent)] += behind[i];
  }
}

}  // namespace

void repair_solids(RobotDescription& description) {
  for (BodyDescription& body : description.bodies) {
    forget_placeholder(body.solid);
    give_mass(body, description);
    make_definite(body, description);
  }
  give_masses(description);
}

}  // namespace murosimf::robot
