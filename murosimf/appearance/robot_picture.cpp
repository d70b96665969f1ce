#include "murosimf/appearance/robot_picture.h"

#include <algorithm>
#include <array>

#include "murosimf/appearance/visual_meshes.h"
#include "murosimf/description/robot_visuals.h"
#include "murosimf/model/error.h"
#include "murosimf/render/scene_view.h"
#include "murosimf/robot/robot_soles.h"

namespace murosimf::appearance {
namespace {

using render::ViewedShape;

constexpr double gap = 0.15;  // [1] between two views, of their height
constexpr double room = 0.9;  // [1] the title needs some

/// The triangles of a mesh in the frame of its body; none if it cannot be read.
std::vector<std::vector<Vec3d>> facets_of(const VisualMesh& visual) {
  try {
    const geometry::TriangleMesh mesh = visual_triangles(visual);
    std::vector<std::vector<Vec3d>> facets;
    for (const auto& [a, b, c] : mesh.triangles)
      facets.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    return facets;
  } catch (const SetupError&) {
    return {};  // robot_checks names it
  }
}

std::vector<ViewedShape> meshes_for_the_eye(const description::RobotDescription& description,
                                            const description::BodyDescription& body, const Transformd& place) {
  std::vector<ViewedShape> shapes;
  for (const VisualMesh& visual : description::visuals_of(description, body)) {
    ViewedShape shape{Sphere{}, place.position, place.orientation, visual.color, facets_of(visual)};
    if (!shape.facets.empty()) shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::vector<ViewedShape> parts_of(const description::RobotDescription& description) {
  std::vector<ViewedShape> parts;
  const auto places = robot::body_places(description);
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    auto seen = meshes_for_the_eye(description, description.bodies[i], places[i]);
    const bool has_meshes = !seen.empty();
    std::ranges::move(seen, std::back_inserter(parts));
    for (const description::ShapeDescription& shape : description.bodies[i].shapes) {
      if (has_meshes && shape.placed.collides) continue;
      const Transformd at = places[i] * shape.placed.place();
      parts.push_back({shape.placed.shape, at.position, at.orientation, shape.placed.color});
    }
  }
  return parts;
}

/// Corners of the box around all parts, seen after a turn.
struct Extent {
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

Extent extent_of(const std::vector<ViewedShape>& parts, const Mat3d& turn) {
  Extent extent;
  const auto add = [&](const Vec3d& p) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y), std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y), std::max(extent.high.z, p.z)};
  };
  for (const ViewedShape& part : parts) {
    for (const auto& facet : part.facets) {
      for (const Vec3d& p : facet) add(turn * (part.position + part.orientation * p));
    }
    if (!part.facets.empty()) continue;
    const double r = bounding_radius(part.shape);
    const Vec3d middle = turn * part.position;
    add(middle - Vec3d{r, r, r});
    add(middle + Vec3d{r, r, r});
  }
  return extent;
}

}  // namespace

std::string robot_picture_png(const description::RobotDescription& description, int columns, int rows) {
  // the eye looks along y: x is to the right, z up
  const std::array turns{rotation_z(-0.5 * pi), rotation_z(pi), rotation_x(0.5 * pi) * rotation_z(0.5 * pi),
                         rotation_x(0.3) * rotation_z(-0.5 * pi + 0.6)};
  const auto parts = parts_of(description);
  std::vector<ViewedShape> row;
  double right = 0;
  for (const Mat3d& turn : turns) {
    const Extent extent = extent_of(parts, turn);
    const double middle = 0.5 * (extent.low.z + extent.high.z);
    for (ViewedShape part : parts) {
      part.position = turn * part.position + Vec3d{right - extent.low.x, 0, -middle};
      part.orientation = turn * part.orientation;
      row.push_back(std::move(part));
    }
    right += extent.high.x - extent.low.x + gap * (extent.high.z - extent.low.z);
  }
  render::View view = render::view_of(render::view_from(-0.5 * pi, 0), row, columns, rows);
  view.scale *= room;
  return render::scene_view_png({}, row, view, description.name + ": front, left side, top, from an angle");
}

}  // namespace murosimf::appearance
