#include "murosimf/appearance/viewed_shapes.h"

#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::appearance {
namespace {

/// Poses of all objects with shapes, world frame.
struct Poses {
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
};

Poses poses_of(const Entity& entity) {
  const auto* r = entity.find(properties::position);
  const auto* R = entity.find(properties::orientation);
  if (r && R) return {r->values, R->values};
  const auto rows = static_cast<std::size_t>(entity.model().size());
  Poses rest{std::vector<Vec3d>(rows), std::vector<Mat3d>(rows)};
  const std::vector<double> q(rows, 0.0);
  multibody::poses<double>(entity.model().tree(), q, rest.r, rest.R);
  return rest;
}

}  // namespace

std::vector<render::ViewedShape> viewed_shapes(const Entity& entity) {
  const Poses poses = poses_of(entity);
  std::vector<render::ViewedShape> result;
  for (const int i : entity.model().having(properties::shapes)) {
    for (const PlacedShape& placed : *entity.model().find(properties::shapes, i)) {
      if (std::holds_alternative<Plane>(placed.shape)) continue;
      result.push_back({placed.shape, poses.r[i] + poses.R[i] * placed.position, poses.R[i] * placed.orientation,
                        render::color_on(entity, placed.color)});
    }
  }
  return result;
}

}  // namespace murosimf::appearance
