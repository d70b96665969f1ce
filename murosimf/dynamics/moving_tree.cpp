#include "murosimf/dynamics/moving_tree.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/multibody/integrate.h"

namespace murosimf::dynamics {

MovingTree::MovingTree(Setup& setup, const MovingTreeOptions& options, std::string_view level)
    : columns(setup),
      links(setup.model().tree().links.size()),
      external_force(setup.write(properties::external_force)),
      external_damping(setup.write(properties::external_damping)),
      contacts(setup),
      gravity(setup.world().gravity),
      entity_(setup.entity()),
      options_(options),
      period_(seconds(setup.period())),
      center_(setup.write(properties::common_center_of_mass)[0]),
      center_velocity_(setup.write(properties::common_center_of_mass_velocity)[0]),
      common_inertia_(setup.write(properties::common_inertia)[0]),
      total_mass_(setup.write(properties::total_mass)[0]),
      dynamic_(setup.write(properties::dynamic)[0]),
      written_(columns) {
  if (has_fixed_base(setup.model())) options_.fixed_base = true;
  if (!(setup.model().tree().mass > 0)) {
    throw SetupError(fmt::format("model '{}' has no mass; {} needs it", setup.model().name(), level));
  }
}

void MovingTree::start() {
  place_at_start(columns, entity_);
  refresh();
  dynamic_ = 1;
  contacts.check(options_.integrator, period_);
  std::fill(external_force.begin(), external_force.end(), Wrenchd{});
  std::fill(external_damping.begin(), external_damping.end(), Sym6d{});
  check_inertia();
}

void MovingTree::check_inertia() const {
  if (options_.fixed_base || is_positive_definite(common_inertia_)) return;
  throw SetupError(
      fmt::format("model '{}' has no inertia about some axis; give its masses an inertia", columns.model.name()));
}

void MovingTree::take_over(const Momentum& momentum) {
  contacts.check(options_.integrator, period_);
  if (options_.fixed_base) columns.v[0] = columns.w[0] = {};
  // the correction needs the momentum of the columns' present velocities
  refresh();
  check_inertia();
  dynamic_ = 1;
  if (!options_.fixed_base) correct_momentum({momentum, center_});
}

Momentum MovingTree::hand_over() noexcept {
  take_links_back();
  contacts.answer_by(nullptr);
  return momentum();
}

void MovingTree::state(StateArchive& archive) {
  bool changed = written_.differs(columns);
  // whether columns were changed since the last step is state: working memory is computed again only then
  archive(changed);
  if (!archive.loads()) return;
  // links are computed where they are needed: lanes have their own
  lanes_ = nullptr;
  has_own_links_ = false;
  // a restored run takes the same branch in its next step as the recorded one
  changed ? written_.forget() : written_.remember(columns);
}

bool MovingTree::goes_with(const MovingTree& other) const noexcept {
  return &columns.model == &other.columns.model && options_ == other.options_ && !options_.fixed_base &&
         options_.integrator == Integrator::semi_implicit_euler;
}

/// Computes the tree's own links from the columns where lanes have not written them (the usual case), and after a state has been loaded.
void MovingTree::take_links_back() noexcept {
  if (!has_own_links_) update_links();
}

void MovingTree::take_changes() noexcept {
  if (!written_.differs(columns)) return take_links_back();
  // the quaternion is the state, the matrix follows from it: users may have written either of the columns
  columns.R[0] = to_matrix(columns.Q[0]);
  if (options_.fixed_base) columns.v[0] = columns.w[0] = {};
  refresh();
}

void MovingTree::refresh() noexcept {
  columns.update_poses();
  columns.update_velocities();
  update_links();
  written_.remember(columns);
}

void MovingTree::update_links() noexcept {
  MUROSIMF_ASSERT(links.size() == columns.model.tree().links.size());
  lanes_ = nullptr;
  has_own_links_ = true;
  multibody::link_motions<double>(columns.model.tree(), columns.r, columns.R, columns.w[0], columns.qd, links);
  whole_ = multibody::composite_inertia<double>(links);
  MUROSIMF_ASSERT(!(whole_.mass <= 0));
  // the composite body about its own center, from moments about the base
  const Vec3d c = (1 / whole_.mass) * whole_.first;
  total_mass_ = whole_.mass;
  center_ = columns.r[0] + c;
  common_inertia_ = whole_.second - whole_.mass * inertia_of_point(c);
  center_velocity_ = columns.v[0] + (1 / whole_.mass) * multibody::linear_momentum<double>(links);
}

Twistd MovingTree::base_acceleration(const Sym6d& inertia, const Wrenchd& force) noexcept {
  if (options_.fixed_base) return {{}, -gravity};
  base_inertia_ = inertia;
  return solve(inertia, force);
}

void MovingTree::factor_base() noexcept {
  if (!options_.fixed_base) factor_.emplace(base_inertia_);
}

void MovingTree::respond_at_base(const collision::ThreeForces& forces, collision::ResponseRows& y) const noexcept {
  if (options_.fixed_base) return;
  MUROSIMF_ASSERT(factor_);
  collision::add_rigid_response(*factor_, forces, y);
}

void MovingTree::respond_at_base(const Wrenchd& force, std::span<double> row) const noexcept {
  if (options_.fixed_base) return;
  MUROSIMF_ASSERT(factor_ && row.size() >= 6);
  const auto y = factor_->forward(force);
  for (std::size_t i = 0; i < y.size(); ++i) row[i] += y[i];
}

Twistd MovingTree::base_change(std::span<const double> z, double dt) const noexcept {
  if (options_.fixed_base) return {};
  MUROSIMF_ASSERT(factor_ && z.size() >= 6 && dt > 0);
  return (1 / dt) * factor_->backward({z[0], z[1], z[2], z[3], z[4], z[5]});
}

bool MovingTree::advance_base(const Twistd& acceleration, double dt) noexcept {
  wanted_momentum_.reset();
  MUROSIMF_ASSERT(dt > 0);
  if (options_.fixed_base) return true;
  if (is_in_flight()) wanted_momentum_ = momentum_after(dt);  // before the base moves: from the state at the beginning
  multibody::FreeBody<double> next = base();
  multibody::advance(next, {acceleration.w, acceleration.v + gravity}, dt);
  if (wanted_momentum_) {
    const Vec3d middle_rate = columns.w[0] + (0.5 * dt) * acceleration.w;
    next.turn = normalized(exponential(dt * middle_rate) * columns.Q[0]);
  }
  if (!is_sane(next)) return false;  // the base stays where it was: a frozen entity has the last sane pose
  place_base(next);
  return true;
}

multibody::FreeBody<double> MovingTree::base() const noexcept {
  return {columns.r[0], columns.v[0], columns.Q[0], columns.w[0]};
}

void MovingTree::place_base(const multibody::FreeBody<double>& base) noexcept {
  columns.r[0] = base.position;
  columns.v[0] = base.velocity;
  columns.Q[0] = base.turn;
  columns.w[0] = base.rate;
  columns.R[0] = to_matrix(base.turn);
}

bool MovingTree::is_in_flight() const noexcept {
  return options_.momentum_correction && contacts.none() &&
         std::all_of(external_damping.begin(), external_damping.end(), [](const Sym6d& d) { return is_zero(d); });
}

MovingTree::CenterMotion MovingTree::momentum() const noexcept {
  const Wrenchd about_base = multibody::momentum<double>(links);
  const Vec3d c = center_ - columns.r[0];
  return {{about_base.f + total_mass_ * columns.v[0], about_base.n - cross(c, about_base.f)}, center_};
}

MovingTree::CenterMotion MovingTree::momentum_after(double dt) const noexcept {
  CenterMotion after = momentum();
  MUROSIMF_ASSERT(dt > 0 && total_mass_ > 0);
  after.linear += (dt * total_mass_) * gravity;
  for (const int object : columns.model.bodies()) {
    const Wrenchd push = moved(external_force[object], center_ - columns.r[object]);
    after.linear += dt * push.f;
    after.angular += dt * push.n;
  }
  after.center += (dt / total_mass_) * after.linear;
  return after;
}

void MovingTree::correct_momentum(const CenterMotion& wanted) noexcept {
  const CenterMotion now = momentum();
  const Vec3d linear = wanted.linear - now.linear;
  const Vec3d angular = wanted.angular - now.angular;
  const Vec3d c = center_ - columns.r[0];
  const Twistd change = solve(to_sym6(whole_), {angular + cross(c, linear), linear});
  // the base's twist that gives the composite body the missing momentum, about the base's origin
  columns.w[0] += change.w;
  columns.v[0] += change.v;
  columns.r[0] += wanted.center - now.center;
  refresh();
}

void MovingTree::finish_step() noexcept {
  contacts.renew();
  refresh();
  // after the poses: the correction is relative to the momentum that the new poses have
  if (wanted_momentum_) correct_momentum(*wanted_momentum_);
}

void MovingTree::halt(const char* reason) noexcept {
  columns.stop();
  center_velocity_ = {};
  dynamic_ = 0;
  entity_.freeze(reason);
}

}  // namespace murosimf::dynamics
