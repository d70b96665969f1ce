#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/robot/repair_solids.h"
#include "murosimf/robot/robot_checks.h"

namespace murosimf::robot {
namespace {

constexpr double tiny_mass =
    0.001;                         // [kg] lighter moving bodies are frames, and their joint should be fixed; those that
                                   // were repaired have a note already
constexpr double huge_mass = 500;  // [kg] no humanoid weighs that
constexpr double widest = 1.5;  // [1] radius of gyration over the reach of the body's shapes; of a solid it is below 1
constexpr double narrowest = 0.02;  // [1] the same: all mass in a point

/// [m] farthest point of the body's shapes from its center of mass; 0 without shapes.
double reach(const robot_formats::BodyDescription& body) {
  double farthest = 0;
  for (const robot_formats::ShapeDescription& shape : body.shapes) {
    const PlacedShape& placed = shape.placed;
    farthest = std::max(farthest, norm(placed.position - body.solid.center) + bounding_radius(placed.shape));
  }
  return farthest;
}

std::string where_of(const robot_formats::BodyDescription& body) {
  return body.solid_where.empty() ? body.where : body.solid_where;
}

void examine_inertia(const robot_formats::BodyDescription& body, std::vector<Finding>& findings) {
  const double size = reach(body);
  if (!(body.solid.mass > tiny_mass) || !(size > 0)) return;
  // Bodies without mass or size have no radius of gyration to compare.
  const double gyration = std::sqrt(robot_formats::principal_moments(body.solid.inertia).z / body.solid.mass);  // [m]
  if (gyration > widest * size) {
    findings.push_back({Severity::warning, where_of(body),
                        fmt::format("inertia of '{}' is that of a body of {:.2g} m, but its shapes reach {:.2g} m",
                                    body.name, gyration, size),
                        "correct it; a factor of 1e6 or 1e3 comes from g mm^2 or g"});
  }
  if (gyration < narrowest * size) {
    findings.push_back({Severity::warning, where_of(body),
                        fmt::format("inertia of '{}' is that of a point: {:.2g} m, but its shapes reach {:.2g} m",
                                    body.name, gyration, size),
                        "correct it"});
  }
}

double total_mass(const robot_formats::RobotDescription& description) {
  double total = 0;
  for (const robot_formats::BodyDescription& body : description.bodies) total += body.solid.mass;
  return total;
}

}  // namespace

std::vector<Finding> examine_masses(const robot_formats::RobotDescription& description) {
  std::vector<Finding> findings;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    // The least mass is that of repaired bodies (repair_solids.h), which have a note.
    const bool moves = body.parent >= 0 || !description.fixed_base;
    const bool is_weighed = body.solid.mass > 0 && body.solid.mass != robot::least_mass;
    if (moves && is_weighed && body.solid.mass < tiny_mass) {
      findings.push_back({Severity::warning, where_of(body),
                          fmt::format("'{}' moves and weighs only {:.3g} kg", body.name, body.solid.mass),
                          "fix its joint, or give it its mass"});
    }
    examine_inertia(body, findings);
  }
  if (const double total = total_mass(description); total > huge_mass) {
    findings.push_back({Severity::warning, description.bodies[0].where,
                        fmt::format("the robot weighs {:.4g} kg", total), "masses are in kg: correct them"});
  }
  return findings;
}

}  // namespace murosimf::robot
