#include "murosimf/collision/contact_laws/island_solver.h"

#include <algorithm>
#include <cmath>

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/inline.h"

namespace murosimf::collision {
namespace {

constexpr double least_damping = 1e-6;  // [N s/m] a contact without damping would have an infinite compliance

/// A frame whose first axis is the unit vector n; deterministic.
Mat3d frame_about(const Vec3d& n) {
  // a direction that is not nearly parallel to n: the larger angle keeps the cross product accurate
  const Vec3d away = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d across = tangential(away, n);
  const Vec3d t = (1 / norm(across)) * across;
  return {n, t, cross(n, t)};
}

/// Extrapolates the rest after `sweeps` whose changes [m/s] have decreased geometrically.
IslandSolver::Rest rest_of(int sweeps, double at_half, double at_end) {
  MUROSIMF_ASSERT(sweeps >= 0);
  constexpr double most = 100;  // [1] times the number of sweeps
  const double fall = 2 * std::log(at_half / at_end), missing = std::log(at_end / IslandSolver::nearly_settled);
  const bool falls = missing < most * fall;
  return {falls ? std::max(0.0, missing / fall) : most, at_end * sweeps * (falls ? std::min(most, 1 / fall) : most)};
}

/// Merges rows with equal indices if both sides of a contact are bodies of one entity. The second side's rows begin at `middle`.
void merge_equal(ResponseRows& rows, std::size_t middle) {
  MUROSIMF_ASSERT(middle <= rows.index.size() && rows.index.size() == rows.value.size());
  std::size_t end = middle;
  for (std::size_t k = middle; k < rows.index.size(); ++k) {
    const auto same =
        std::find(rows.index.begin(), rows.index.begin() + static_cast<std::ptrdiff_t>(middle), rows.index[k]);
    const auto at = static_cast<std::size_t>(same - rows.index.begin());
    if (at < middle) {
      rows.value[at] += rows.value[k];
    } else {
      rows.index[end] = rows.index[k];
      rows.value[end++] = rows.value[k];
    }
  }
  rows.index.resize(end);
  rows.value.resize(end);
}

}  // namespace

void IslandSolver::start(double dt) {
  MUROSIMF_ASSERT(dt > 0);
  dt_ = dt;
  members_.clear();
  z_.assign(1, 0.0);  // number 0 belongs to no entity: padding of rows to fours points to it
  contacts_.clear();
  index_.clear();
  rows_.clear();
  columns_.clear();
}

int IslandSolver::add(ImpulseResponse& response) {
  members_.push_back({&response, z_.size(), response.coordinates()});
  z_.resize(z_.size() + response.coordinates(), 0.0);
  return static_cast<int>(members_.size()) - 1;
}

void IslandSolver::add_side(Contact& contact, double sign, const Side& side) {
  MUROSIMF_ASSERT(side.member < static_cast<int>(members_.size()));
  const Vec3d& point = contact.point->point;
  if (side.member < 0) {
    contact.free += sign * transposed_times(contact.frame, side.velocity);
    return;
  }
  const Member& member = members_[side.member];
  const Vec3d velocity = member.response->free_velocity(side.object, point, side.velocity);
  contact.free += sign * transposed_times(contact.frame, velocity);
  const std::size_t first = response_.index.size();
  const Mat3d directions{sign * contact.frame.x, sign * contact.frame.y, sign * contact.frame.z};
  member.response->respond(side.object, point, directions, response_);
  for (std::size_t k = first; k < response_.index.size(); ++k) response_.index[k] += static_cast<int>(member.offset);
}

/// Stores the response in the layout that sweeps read: rows for velocities, columns by fours for impulses.
void IslandSolver::keep_response(Contact& c) {
  const std::size_t count = response_.index.size();
  c.first = index_.size();
  c.last = c.first + count;
  MUROSIMF_ASSERT(response_.value.size() == count && c.first % 4 == 0);
  const std::size_t end = c.first + (count + 3) / 4 * 4;
  index_.resize(end);
  rows_.resize(end);
  columns_.resize(end / 4);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3d& row = response_.value[k];
    MUROSIMF_ASSERT(static_cast<std::size_t>(response_.index[k]) < z_.size());
    index_[c.first + k] = static_cast<std::size_t>(response_.index[k]);
    rows_[c.first + k] = Four(row.x, row.y, row.z, 0.0);
  }
  for (std::size_t k = c.first; k < end; k += 4) {
    const Four &a = rows_[k], &b = rows_[k + 1], &d = rows_[k + 2], &e = rows_[k + 3];
    columns_[k / 4] = {{a[0], b[0], d[0], e[0]}, {a[1], b[1], d[1], e[1]}, {a[2], b[2], d[2], e[2]}};
  }
}

void IslandSolver::add(ContactPoint& point, const ContactParameters& p, const Side& a, const Side& b) {
  MUROSIMF_ASSERT(dt_ > 0 && p.friction >= 0);
  Contact& c = contacts_.emplace_back();
  c.point = &point;
  c.parameters = &p;
  c.frame = frame_about(point.normal);
  response_.index.clear();
  response_.value.clear();
  add_side(c, 1, a);
  const std::size_t middle = response_.index.size();
  add_side(c, -1, b);
  if (a.member >= 0 && a.member == b.member) merge_equal(response_, middle);
  for (const Vec3d& row : response_.value) c.W += outer(row);
  keep_response(c);
  const double b_n = std::max(least_damping, implicit_damping(point, p, dt_));
  const double b_t = std::max(least_damping, implicit_tangent_damping(point, p, dt_));
  c.R_n = 1 / (dt_ * b_n);
  c.R_t = 1 / (dt_ * b_t);
  invert(c);
  const Vec3d spring = (-p.tangent_stiffness / b_t) * tangential(point.stretch, point.normal);
  c.request_n = resting_force(point, p, dt_) / b_n;
  c.request_1 = dot(spring, c.frame.y);
  c.request_2 = dot(spring, c.frame.z);
  // warm start: the normal force of the preceding step, and the force of the spring
  const double held = -dt_ * p.tangent_stiffness;
  push(c, {dt_ * point.last_normal_force, held * dot(point.stretch, c.frame.y), held * dot(point.stretch, c.frame.z)});
}

void IslandSolver::invert(Contact& c) noexcept {
  // with R > 0 these are regular, also for contacts that move no mass
  c.mass_n = 1 / (c.W.xx + c.R_n);
  const double a = c.W.yy + c.R_t, b = c.W.yz, d = c.W.zz + c.R_t;
  const double scale = 1 / (a * d - b * b);
  c.mass_1 = scale * d;
  c.mass_12 = -scale * b;
  c.mass_2 = scale * a;
  c.slide_mass = 1 / (0.5 * (a + d) + std::sqrt(0.25 * (a - d) * (a - d) + b * b));
}

MUROSIMF_INLINE Vec3d IslandSolver::velocity(const Contact& c) const noexcept {
  Four v(c.free.x, c.free.y, c.free.z, 0.0);
  for (std::size_t k = c.first; k < c.last; ++k) v = v + z_[index_[k]] * rows_[k];
  return {v[0], v[1], v[2]};
}

MUROSIMF_INLINE void IslandSolver::push(Contact& c, const Vec3d& impulse) noexcept {
  c.lambda += impulse;
  for (std::size_t k = c.first; k < c.last; k += 4) {
    const Columns& rows = columns_[k / 4];
    const Four change = impulse.x * rows.x + impulse.y * rows.y + impulse.z * rows.z;
    const std::size_t* const index = &index_[k];
    z_[index[0]] += change[0];
    z_[index[1]] += change[1];
    z_[index[2]] += change[2];
    z_[index[3]] += change[3];
  }
}

/// Solves one contact; returns the change [m/s] of its velocity.
double IslandSolver::solve(Contact& c) noexcept {
  const Vec3d v = velocity(c);
  const double rest = v.x + c.R_n * c.lambda.x - c.request_n;
  const double normal = std::max(0.0, c.lambda.x - c.mass_n * rest);
  const double pushed = normal - c.lambda.x;
  // friction sees the velocity after the new normal impulse: one contact is solved exactly in one step
  const Vec3d friction = solve_friction(c, normal, v + pushed * Vec3d{c.W.xx, c.W.xy, c.W.xz});
  const Vec3d change = Vec3d{normal, friction.y, friction.z} - c.lambda;
  if (is_zero(change)) return 0;  // still open: the most frequent case
  push(c, change);
  return std::abs(c.W.xx * change.x) + std::abs(c.W.yy * change.y) + std::abs(c.W.zz * change.z);
}

/// Impulses along the tangents (y, z) for the velocity after the normal impulse.
Vec3d IslandSolver::solve_friction(const Contact& c, double normal, const Vec3d& v) const noexcept {
  if (normal <= 0) {
    c.point->state = ContactState::open;
    return {};
  }
  const double r1 = v.y + c.R_t * c.lambda.y - c.request_1;
  const double r2 = v.z + c.R_t * c.lambda.z - c.request_2;
  const Vec3d held{0, c.lambda.y - (c.mass_1 * r1 + c.mass_12 * r2), c.lambda.z - (c.mass_12 * r1 + c.mass_2 * r2)};
  c.point->state = ContactState::stick;
  if (within_cone(c, normal, held) >= 1) return held;
  // the impulse that stops the point is not along its motion, since it also turns the body; sliding friction is
  c.point->state = ContactState::slip;
  const Vec3d sliding{0, c.lambda.y - c.slide_mass * r1, c.lambda.z - c.slide_mass * r2};
  return within_cone(c, normal, sliding) * sliding;
}

/// Factor of the friction that the cone allows: 1 inside.
double IslandSolver::within_cone(const Contact& c, double normal, const Vec3d& friction) noexcept {
  const double square = friction.y * friction.y + friction.z * friction.z;
  const ContactParameters& p = *c.parameters;
  if (is_zero(p.friction_direction)) {  // isotropic: a square root only outside the cone
    const double most = p.friction * normal;
    return square <= most * most ? 1 : most / std::sqrt(square);
  }
  const double size = std::sqrt(square);
  const double most = friction_limit(p, normal, sliding_direction(c.frame * friction, size));
  return size <= most ? 1 : most / size;
}

int IslandSolver::sweep(int sweeps) noexcept {
  MUROSIMF_ASSERT(sweeps >= 0);
  double change = 0, at_half = 0;  // [m/s]
  for (int i = 0; i < sweeps; ++i) {
    change = 0;
    const std::size_t count = contacts_.size();
    for (std::size_t k = 0; k < count; ++k) {
      // alternating direction: information travels both ways through a stack
      change = std::max(change, solve(contacts_[i % 2 == 0 ? k : count - 1 - k]));
    }
    if (change < (i < usual_sweeps ? settled : nearly_settled)) {
      rest_ = {};
      return i + 1;
    }
    if (i + 1 == sweeps / 2) at_half = change;
  }
  rest_ = rest_of(sweeps, at_half, change);
  return sweeps;
}

void IslandSolver::finish(Contact& c) noexcept {
  ContactPoint& point = *c.point;
  const ContactParameters& p = *c.parameters;
  MUROSIMF_ASSERT(dt_ > 0);
  const Vec3d v = velocity(c);
  const Vec3d v_t = v.y * c.frame.y + v.z * c.frame.z;
  const Vec3d f_t = (1 / dt_) * (c.lambda.y * c.frame.y + c.lambda.z * c.frame.z);
  point.last_normal_force = c.lambda.x / dt_;
  point.force = point.last_normal_force * c.frame.x + f_t;
  point.slip_direction = sliding_direction(f_t, norm(f_t));
  switch (point.state) {
    case ContactState::open: point.stretch = {}; break;
    case ContactState::stick: point.stretch = tangential(point.stretch, point.normal) + dt_ * v_t; break;
    case ContactState::slip: point.stretch = (-1.0 / p.tangent_stiffness) * (f_t + p.tangent_damping * v_t); break;
  }
}

void IslandSolver::finish() noexcept {
  finish_points();
  for (int i = 0; i < static_cast<int>(members_.size()); ++i) apply(i);
}

void IslandSolver::finish_points() noexcept {
  for (Contact& contact : contacts_) finish(contact);
}

void IslandSolver::apply(int member) const noexcept {
  MUROSIMF_ASSERT(member >= 0 && static_cast<std::size_t>(member) < members_.size());
  const Member& m = members_[member];
  m.response->apply({z_.data() + m.offset, m.size});
}

}  // namespace murosimf::collision
