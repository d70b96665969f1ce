#include "murosimf/collision/island_solver.h"

#include <algorithm>
#include <cmath>

#include "murosimf/collision/contact_force.h"

namespace murosimf::collision {
namespace {

constexpr double least_damping = 1e-6;  // [N s/m] a contact without any would have no end of compliance

/// Two unit vectors across the unit vector n; the same for the same n.
std::array<Vec3d, 3> frame_about(const Vec3d& n) {
  const Vec3d away = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d across = tangential(away, n);
  const Vec3d t = (1 / norm(across)) * across;
  return {n, t, cross(n, t)};
}

/// y . y of two rows of the same side: their numbers belong to the same coordinates.
double product(const ResponseRow& a, const ResponseRow& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.value.size(); ++k) sum += a.value[k] * b.value[k];
  return sum;
}

}  // namespace

void IslandSolver::start(double dt) {
  dt_ = dt;
  members_.clear();
  z_.clear();
  count_ = 0;
}

int IslandSolver::add(ImpulseResponse& response) {
  members_.push_back({&response, z_.size(), response.coordinates()});
  z_.resize(z_.size() + response.coordinates(), 0.0);
  return static_cast<int>(members_.size()) - 1;
}

void IslandSolver::add_side(Contact& contact, int which, const Side& side) {
  const double sign = which == 0 ? 1 : -1;
  contact.member[which] = side.member;
  const Vec3d& point = contact.point->point;
  Vec3d velocity = side.velocity;
  if (side.member >= 0) velocity = members_[side.member].response->free_velocity(side.object, point, velocity);
  for (int i = 0; i < 3; ++i) {
    ResponseRow& y = contact.row[i].y[which];
    y.clear();
    if (side.member >= 0) members_[side.member].response->respond(side.object, point, sign * contact.frame[i], y);
    contact.row[i].free += sign * dot(velocity, contact.frame[i]);
  }
}

void IslandSolver::add(ContactPoint& point, const ContactParameters& p, const Side& a, const Side& b) {
  if (count_ == contacts_.size()) contacts_.emplace_back();
  Contact& c = contacts_[count_++];
  c.point = &point;
  c.parameters = &p;
  c.frame = frame_about(point.normal);
  for (Row& row : c.row) row.free = 0;
  add_side(c, 0, a);
  add_side(c, 1, b);
  const auto w = [&](int i, int j) {
    return product(c.row[i].y[0], c.row[j].y[0]) + product(c.row[i].y[1], c.row[j].y[1]);
  };
  c.W_n = w(0, 0);
  c.W_11 = w(1, 1);
  c.W_12 = w(1, 2);
  c.W_22 = w(2, 2);
  const double b_n = std::max(least_damping, p.damping + p.theta * dt_ * p.stiffness);
  const double b_t = std::max(least_damping, p.tangent_damping + dt_ * p.tangent_stiffness);
  c.R_n = 1 / (dt_ * b_n);
  c.R_t = 1 / (dt_ * b_t);
  const Vec3d spring = (-p.tangent_stiffness / b_t) * tangential(point.stretch, point.normal);
  c.wish_n = p.stiffness * point.depth / b_n;
  c.wish_1 = dot(spring, c.frame[1]);
  c.wish_2 = dot(spring, c.frame[2]);
  c.lambda = {};
  // start from the memory of the step before: its normal force, and what the spring holds
  change(c, 0, dt_ * point.last_normal_force);
  for (int i = 1; i < 3; ++i) change(c, i, -dt_ * p.tangent_stiffness * dot(point.stretch, c.frame[i]));
}

double IslandSolver::velocity(const Contact& c, int row) const noexcept {
  double v = c.row[row].free;
  for (int side = 0; side < 2; ++side) {
    if (c.member[side] < 0) continue;
    const Member& m = members_[c.member[side]];
    v += c.row[row].y[side].times({z_.data() + m.offset, m.size});
  }
  return v;
}

void IslandSolver::change(Contact& c, int row, double lambda) noexcept {
  const double difference = lambda - c.lambda[row];
  if (difference == 0) return;
  c.lambda[row] = lambda;
  for (int side = 0; side < 2; ++side) {
    if (c.member[side] < 0) continue;
    const Member& m = members_[c.member[side]];
    c.row[row].y[side].add_to({z_.data() + m.offset, m.size}, difference);
  }
}

void IslandSolver::solve(Contact& c) noexcept {
  const double rest = velocity(c, 0) + c.R_n * c.lambda[0] - c.wish_n;
  change(c, 0, std::max(0.0, c.lambda[0] - rest / (c.W_n + c.R_n)));

  solve_friction(c);
}

void IslandSolver::solve_friction(Contact& c) noexcept {
  const double r1 = velocity(c, 1) + c.R_t * c.lambda[1] - c.wish_1;
  const double r2 = velocity(c, 2) + c.R_t * c.lambda[2] - c.wish_2;
  const double a = c.W_11 + c.R_t, b = c.W_12, d = c.W_22 + c.R_t;
  const double determinant = a * d - b * b;
  double l1 = c.lambda[1] - (d * r1 - b * r2) / determinant;
  double l2 = c.lambda[2] - (a * r2 - b * r1) / determinant;
  const auto limit = [&] {
    const double size = std::hypot(l1, l2);
    return friction_limit(*c.parameters, c.lambda[0], sliding_direction(l1 * c.frame[1] + l2 * c.frame[2], size)) /
           size;
  };
  c.point->state = c.lambda[0] > 0 ? ContactState::stick : ContactState::open;
  if (c.lambda[0] <= 0) {
    l1 = l2 = 0;
  } else if (limit() < 1) {
    // what stops the point is not along its motion, since pushing it also turns the body; sliding friction is
    c.point->state = ContactState::slip;
    const double step = 1 / (0.5 * (a + d) + std::hypot(0.5 * (a - d), b));
    l1 = c.lambda[1] - step * r1;
    l2 = c.lambda[2] - step * r2;
    const double scale = std::min(1.0, limit());
    l1 *= scale;
    l2 *= scale;
  }
  change(c, 1, l1);
  change(c, 2, l2);
}

void IslandSolver::sweep(int sweeps) noexcept {
  for (int i = 0; i < sweeps; ++i) {
    for (std::size_t k = 0; k < count_; ++k) solve(contacts_[i % 2 == 0 ? k : count_ - 1 - k]);
  }
}

void IslandSolver::finish(Contact& c) noexcept {
  ContactPoint& point = *c.point;
  const ContactParameters& p = *c.parameters;
  const Vec3d v_t = velocity(c, 1) * c.frame[1] + velocity(c, 2) * c.frame[2];
  const Vec3d f_t = (1 / dt_) * (c.lambda[1] * c.frame[1] + c.lambda[2] * c.frame[2]);
  point.last_normal_force = c.lambda[0] / dt_;
  point.force = point.last_normal_force * c.frame[0] + f_t;
  point.slip_direction = sliding_direction(f_t, norm(f_t));
  switch (point.state) {
    case ContactState::open: point.stretch = {}; break;
    case ContactState::stick: point.stretch = tangential(point.stretch, point.normal) + dt_ * v_t; break;
    case ContactState::slip: point.stretch = (-1.0 / p.tangent_stiffness) * (f_t + p.tangent_damping * v_t); break;
  }
}

void IslandSolver::finish() noexcept {
  for (std::size_t k = 0; k < count_; ++k) finish(contacts_[k]);
  for (const Member& m : members_) m.response->apply({z_.data() + m.offset, m.size});
}

}  // namespace murosimf::collision
