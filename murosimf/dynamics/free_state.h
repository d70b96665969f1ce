/// free_state.h - the state of a robot with a free base as one row of numbers, for integrators of ordinary differential equations.
///
/// [position; velocity; angular velocity; quaternion; q; qd] of the base (or center of mass) in world axes, and of the
/// joints in order of the model. Rate of the quaternion: Q' = [0; w] Q / 2 (Featherstone 2008, sec. 4.5).
#pragma once

#include <vector>

#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/integrate.h"

namespace murosimf::dynamics {

/// Number of a row's numbers that belong to the base.
inline constexpr std::size_t base_numbers = 13;

/// Whether the state is sane: false for NaN, and for numbers beyond any motion.
[[nodiscard]] bool is_sane_state(const std::vector<double>& y);

/// Writes the numbers of `body` and of the joints' columns to the row y.
void write_state(const multibody::FreeBody<double>& body, const PoseColumns& columns, std::vector<double>& y);

/// The body of a row (quaternion normalized); the joints go into the columns.
[[nodiscard]] multibody::FreeBody<double> read_state(const std::vector<double>& y, PoseColumns& columns);

/// The rate of a row: `acceleration` of the body, qdd(joint object) of the joints.
template <class JointAcceleration>
void write_rate(const multibody::FreeBody<double>& body, const Twistd& acceleration, const PoseColumns& columns,
                const JointAcceleration& qdd, std::vector<double>& dy) {
  const Quaterniond& Q = body.turn;
  const Vec3d& w = body.rate;
  const Quaterniond turn = Quaterniond{0, w.x, w.y, w.z} * Q;
  dy.clear();
  for (const Vec3d& v : {body.velocity, acceleration.v, acceleration.w}) dy.insert(dy.end(), {v.x, v.y, v.z});
  for (const double x : {turn.w, turn.x, turn.y, turn.z}) dy.push_back(0.5 * x);
  for (const int i : columns.model.joints()) dy.insert(dy.end(), {columns.qd[i], qdd(i)});
  MUROSIMF_ASSERT(dy.size() == base_numbers + 2 * columns.model.joints().size());
}

}  // namespace murosimf::dynamics
