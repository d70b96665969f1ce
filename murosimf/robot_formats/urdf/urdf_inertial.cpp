#include "murosimf/robot_formats/urdf/urdf_inertial.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

/// Warns if a file has both halves of the tensor and they differ.
void compare_halves(const UrdfLink& link, const files::XmlElement& element, UrdfLog& log) {
  constexpr const char* halves[][2] = {{"ixy", "iyx"}, {"ixz", "izx"}, {"iyz", "izy"}};
  for (const auto& [upper, lower] : halves) {
    if (!element.attribute(lower) || needed_number(element, lower) == number_or(element, upper, 0)) continue;
    log.warn(element, fmt::format("inertia of link '{0}' is not symmetric: {2} is not {1}; {1} is taken", link.name,
                                  upper, lower));
  }
}

SymMat3d read_tensor(const UrdfLink& link, const files::XmlElement& inertial, UrdfLog& log) {
  const files::XmlElement element = needed_child(inertial, "inertia");
  compare_halves(link, element, log);
  return {needed_number(element, "ixx"), needed_number(element, "iyy"), needed_number(element, "izz"),
          number_or(element, "ixy", 0),  number_or(element, "ixz", 0),  number_or(element, "iyz", 0)};
}

constexpr double rounding = 1e-15;  // [kg m^2] written by programs for zero

bool is_zero(const SymMat3d& I) {
  const double sum =
      std::abs(I.xx) + std::abs(I.yy) + std::abs(I.zz) + std::abs(I.xy) + std::abs(I.xz) + std::abs(I.yz);
  return sum <= rounding;
}

double read_mass(const UrdfLink& link, const files::XmlElement& inertial) {
  const files::XmlElement element = needed_child(inertial, "mass");
  const double mass = needed_number(element, "value");
  if (mass < 0) element.fail(fmt::format("mass {} kg of link '{}' is negative; correct it", mass, link.name));
  return mass;
}

void balance_moments(const UrdfLink& link, const files::XmlElement& inertial, robot_formats::MassProperties& solid,
                     UrdfLog& log) {
  // The mean is the moment of a ball, which every solid can have.
  solid.inertia = diagonal((solid.inertia.xx + solid.inertia.yy + solid.inertia.zz) / 3.0);
  log.note(inertial, fmt::format("inertia of link '{}' replaced by its mean: balanceinertia", link.name));
}

void check_tensor(const UrdfLink& link, const files::XmlElement& inertial, bool balance,
                  robot_formats::MassProperties& solid, UrdfLog& log) {
  const Vec3d moments = robot_formats::principal_moments(solid.inertia);
  if (!robot_formats::breaks_triangle_inequality(moments)) return;
  if (balance) return balance_moments(link, inertial, solid, log);
  log.warn(inertial,
           fmt::format("no solid body has the principal moments {:.4g} {:.4g} {:.4g} kg m^2 of link '{}': two "
                       "of them must not be less than the third",
                       moments.x, moments.y, moments.z, link.name));
}

}  // namespace

robot_formats::MassProperties read_inertial(const UrdfLink& link, bool balance, UrdfLog& log) {
  const auto inertial = only_child(link.element, "inertial");
  if (!inertial) return {};
  robot_formats::MassProperties solid;
  const Transformd place = read_origin(*inertial);
  solid.mass = read_mass(link, *inertial);
  solid.center = place.position;
  // The tensor is given in the axes of the inertial frame.
  solid.inertia = rotated(place.orientation, read_tensor(link, *inertial, log));
  if (is_zero(solid.inertia)) {
    solid.inertia = {};
    if (solid.mass > 0) log.note(*inertial, "links with mass and without inertia are points");
    return solid;
  }
  if (solid.mass == 0) log.note(*inertial, "links with inertia and without mass turn but weigh nothing");
  check_tensor(link, *inertial, balance, solid, log);
  MUROSIMF_ASSERT(solid.mass >= 0);
  return solid;
}

}  // namespace murosimf::robot_formats::urdf
