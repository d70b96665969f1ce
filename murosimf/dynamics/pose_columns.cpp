#include "murosimf/dynamics/pose_columns.h"

#include <algorithm>
#include <limits>

#include "murosimf/collision/ground_points.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/link_motion.h"

namespace murosimf::dynamics {
namespace {

/// Height [m] of the robot's lowest point at the present pose; 0 without shapes.
double lowest_point(const PoseColumns& columns) noexcept {
  const auto& shapes = collision::ground_shapes(columns.model);
  if (shapes.empty()) return 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& shape : shapes) {
    lowest = std::min(lowest, collision::lowest_point(shape, columns.r[shape.object], columns.R[shape.object], {}));
  }
  return lowest;
}

}  // namespace

PoseColumns::PoseColumns(Setup& setup)
    : model(setup.model()),
      r(setup.write(properties::position)),
      R(setup.write(properties::orientation)),
      v(setup.write(properties::linear_velocity)),
      w(setup.write(properties::angular_velocity)),
      q(setup.write(properties::joint_position)),
      qd(setup.write(properties::joint_velocity)),
      Q(setup.write(properties::base_quaternion)),
      written_r(setup.write(properties::written_position)[0]),
      written_v(setup.write(properties::written_velocity)[0]) {
  MUROSIMF_ASSERT(r.size() == static_cast<std::size_t>(model.size()) && R.size() == r.size() && q.size() == r.size());
  MUROSIMF_ASSERT(v.size() == r.size() && w.size() == r.size() && qd.size() == r.size() && Q.size() == 1);
}

void PoseColumns::update_poses() noexcept { multibody::poses<double>(model.tree(), q, r, R); }

void PoseColumns::update_velocities() noexcept { multibody::velocities<double>(model.tree(), qd, r, R, v, w); }

Momentum PoseColumns::momentum() const {
  std::vector<multibody::LinkMotion<double>> links(model.tree().links.size());
  multibody::link_motions<double>(model.tree(), r, R, w[0], qd, links);
  const auto whole = multibody::composite_inertia<double>(links);
  const Wrenchd about_base = multibody::momentum<double>(links);
  return {about_base.f + whole.mass * v[0], about_base.n - (1 / whole.mass) * cross(whole.first, about_base.f)};
}

void PoseColumns::stop() noexcept {
  std::fill(v.begin(), v.end(), Vec3d{});
  std::fill(w.begin(), w.end(), Vec3d{});
  std::fill(qd.begin(), qd.end(), 0.0);
}

void PoseColumns::remember_base() noexcept {
  written_r = r[0];
  written_v = v[0];
}

Vec3d PoseColumns::take_displacement() noexcept {
  const Vec3d change = r[0] - written_r;
  written_r = r[0];
  return change;
}

Vec3d PoseColumns::take_velocity_change() noexcept {
  const Vec3d change = v[0] - written_v;
  written_v = v[0];
  return change;
}

void place_at_start(PoseColumns& columns, const Entity& entity) noexcept {
  // poses at the origin first: the turn that makes the first sole flat, then the lowest point, follow from them
  const Model& model = columns.model;
  const EntityOptions& options = entity.options();
  columns.stop();
  columns.r[0] = {};
  columns.R[0] = Mat3d{};
  columns.update_poses();
  // robots stand on their first sole, unless the base is to be level or bolted
  const bool fixed = has_fixed_base(model);
  if (const auto soles = model.having(properties::sole); !soles.empty() && !options.base_level && !fixed) {
    columns.R[0] = transpose(columns.R[soles.front()]);
  }
  columns.R[0] = rotation_z(options.heading) * (options.attitude * columns.R[0]);
  columns.update_poses();
  columns.r[0] = {options.position.x, options.position.y, options.position.z - (fixed ? 0 : lowest_point(columns))};
  columns.Q[0] = from_matrix(columns.R[0]);
  columns.update_poses();
}

}  // namespace murosimf::dynamics
