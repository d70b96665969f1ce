#include "murosimf/robot/mesh_fit.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::robot {
namespace {

using geometry::PrimitiveKind;

std::set<std::string> meshes_of_files(const robot_formats::RobotDescription& description) {
  std::set<std::string> names;
  for (const robot_formats::MeshDescription& mesh : description.meshes) {
    if (!mesh.file.empty()) names.insert(mesh.name);
  }
  return names;
}

/// The mesh itself, for drawing.
robot_formats::VisualDescription visual_of(const robot_formats::ShapeDescription& shape) {
  const Transformd place = shape.placed.place() * Transformd{-shape.middle, {}};
  return {"", shape.where, shape.mesh, place, shape.placed.color};
}

bool shows(const robot_formats::BodyDescription& body, const std::string& mesh) {
  return std::ranges::any_of(body.visuals,
                             [&](const robot_formats::VisualDescription& visual) { return visual.mesh == mesh; });
}

void replace(robot_formats::ShapeDescription& shape, const geometry::FittedPrimitive& fitted) {
  const Transformd place = shape.placed.place() * Transformd{fitted.position, fitted.orientation};
  shape.placed.shape = fitted.shape;
  shape.placed.position = place.position;
  shape.placed.orientation = place.orientation;
  shape.mesh.clear();
  shape.middle = {};
}

class Fitter {
 public:
  Fitter(const robot_formats::RobotDescription& description, PrimitiveKind kind)
      : kind_(kind), files_(meshes_of_files(description)) {}

  void fit(robot_formats::BodyDescription& body) {
    std::vector<robot_formats::VisualDescription> visuals;
    for (robot_formats::ShapeDescription& shape : body.shapes) {
      const auto* convex = std::get_if<Convex>(&shape.placed.shape);
      if (!convex) continue;
      const bool first_part =
          // Parts of one mesh follow each other: the mesh is drawn once.
          visuals.empty() || visuals.back().where != shape.where || visuals.back().mesh != shape.mesh;
      if (files_.contains(shape.mesh) && !shows(body, shape.mesh) && first_part) visuals.push_back(visual_of(shape));
      const auto fitted = fit_primitive(*convex->hull, kind_);
      fits.push_back({body.name, shape.mesh, shape_name(fitted.shape), fitted.overlap});
      replace(shape, fitted);
      if (const int part = ++parts_[shape.name]; part > 1 && !shape.name.empty()) {
        shape.name += fmt::format(".{}", part);
      }
    }
    body.visuals.insert(body.visuals.end(), visuals.begin(), visuals.end());
  }

  std::vector<MeshFit> fits;

 private:
  PrimitiveKind kind_;
  std::set<std::string> files_;
  std::map<std::string, int> parts_;  ///< number so far, by name of the geom
};

}  // namespace

std::vector<MeshFit> fit_meshes(robot_formats::RobotDescription& description, PrimitiveKind kind) {
  Fitter fitter(description, kind);
  for (robot_formats::BodyDescription& body : description.bodies) fitter.fit(body);
  return fitter.fits;
}

PrimitiveKind primitive_kind(const std::string& name) {
  constexpr std::array kinds{std::pair{"sphere", PrimitiveKind::sphere}, std::pair{"capsule", PrimitiveKind::capsule},
                             std::pair{"cylinder", PrimitiveKind::cylinder}, std::pair{"box", PrimitiveKind::box},
                             std::pair{"best", PrimitiveKind::best}};
  std::vector<std::string_view> known;
  for (const auto& [word, kind] : kinds) {
    if (word == name) return kind;
    known.emplace_back(word);
  }
  throw SetupError(unknown_name("kind of primitive", name, known));
}

}  // namespace murosimf::robot
