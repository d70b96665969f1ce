#include <algorithm>

#include <fmt/format.h>

#include "murosimf/geometry/distance.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/body_overlaps.h"
#include "murosimf/robot/robot_checks.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot {
namespace {

constexpr double overlap = 0.001;              // [m] less is a matter of rounding
constexpr std::size_t many_triangles = 50000;  // of one mesh: drawing it costs more than the physics

/// [m] Largest depth of penetration of two bodies, in the pose of the file; 0: none.
double deepest(const robot_formats::BodyDescription& a, const Transformd& at_a, const robot_formats::BodyDescription& b,
               const Transformd& at_b) {
  double depth = 0;
  robot::any_touching_pair(a, at_a, b, at_b,
                           [&](const Shape& one, const Transformd& at_one, const Shape& other,
                               const Transformd& at_other) {
                             const double reach = bounding_radius(one) + bounding_radius(other);
                             if (norm(at_one.position - at_other.position) <= reach)
                               // Bounding spheres first: the exact distance is expensive.
                               depth = std::max(depth, -geometry::distance(one, at_one, other, at_other).distance);
                             return false;  // continue with all pairs
                           });
  return depth;
}

void examine_overlaps(const robot_formats::RobotDescription& description, std::vector<Finding>& findings) {
  const auto places = robot::body_places(description);
  MUROSIMF_ASSERT(places.size() == description.bodies.size());
  for (std::size_t a = 0; a < description.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < description.bodies.size(); ++b) {
      const bool neighbors = description.bodies[b].parent == static_cast<int>(a);
      if (neighbors || robot::is_excluded(description, description.bodies[a].name, description.bodies[b].name))
        continue;
      const double depth = deepest(description.bodies[a], places[a], description.bodies[b], places[b]);
      if (depth <= overlap) continue;
      findings.push_back(
          {Severity::warning, description.bodies[b].where,
           fmt::format("shapes of '{}' and '{}' overlap by {:.1f} mm in the pose of the file",
                       description.bodies[a].name, description.bodies[b].name, 1000 * depth),
           "they cannot touch each other while inner collisions are on; make one smaller if they should"});
    }
  }
}

void examine_meshes(const robot_formats::RobotDescription& description, std::vector<Finding>& findings) {
  for (const robot_formats::MeshDescription& mesh : description.meshes) {
    std::error_code none;
    if (mesh.file.empty() || !std::filesystem::is_regular_file(mesh.file, none)) continue;
    std::size_t triangles = 0;
    try {
      triangles = robot_formats::mesh::read_mesh_file(mesh.file).mesh.triangles.size();
    } catch (const SetupError& error) {
      findings.push_back({Severity::warning, mesh.where, error.what(), "it cannot be drawn"});
    }
    if (triangles <= many_triangles) continue;
    findings.push_back({Severity::warning, mesh.where, fmt::format("mesh '{}' has {} triangles", mesh.name, triangles),
                        fmt::format("{} are plenty for a picture", many_triangles)});
  }
}

}  // namespace

std::vector<Finding> examine_shapes(const robot_formats::RobotDescription& description) {
  std::vector<Finding> findings;
  examine_overlaps(description, findings);
  examine_meshes(description, findings);
  return findings;
}

}  // namespace murosimf::robot
