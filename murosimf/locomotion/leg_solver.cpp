#include "murosimf/locomotion/leg_solver.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/math/spatial.h"

namespace murosimf::locomotion {
namespace {

using Angles = std::array<double, most_hinges>;

constexpr double first_damping = 1e-7;   // [m^2] mu
constexpr double least_damping = 1e-14;  // [m^2]
constexpr double most_damping = 1e4;     // [m^2] steps are below any number that counts
constexpr double longest_step = 0.5;     // [rad] longer ones may lead to another solution
constexpr double exact = 1e-12;          // [m] of |e|: rounding

/// The error e, and the pose of the chain that it belongs to.
struct Miss {
  ChainPose pose;
  Twistd error;
  double size = 0;  ///< |e|^2
};

Miss miss(const LegChain& chain, const TipTarget& target, double weight, std::span<const double> q) {
  Miss m;
  m.pose = pose_of(chain, q);
  if (weight > 0) {
    m.error.w = weight * rotation_vector(from_matrix(target.sole * transpose(m.pose.sole)));
  }
  m.error.v = target.tip - m.pose.tip;
  m.size = dot(m.error.w, m.error.w) + dot(m.error.v, m.error.v);
  return m;
}

/// Column of the Jacobian.
Twistd column(const ChainPose& pose, double weight, std::size_t i) {
  MUROSIMF_ASSERT(i < most_hinges);
  return {weight * pose.axis[i], cross(pose.axis[i], pose.tip - pose.place[i])};
}

Sym6d product_with_itself(const Twistd& c) { return {outer(c.w), {c.v.x * c.w, c.v.y * c.w, c.v.z * c.w}, outer(c.v)}; }

/// The damped step of the free hinges; hinges that reach their ends are fixed there.
class Step {
 public:
  Step(const LegChain& chain, const Miss& miss, double weight, std::span<const double> q)
      : chain_(chain), q_(q), rest_{miss.error.w, miss.error.v} {
    MUROSIMF_ASSERT(q.size() == chain.hinges.size() && q.size() <= most_hinges);
    for (std::size_t i = 0; i < q.size(); ++i) columns_[i] = column(miss.pose, weight, i);
  }

  void find(double damping) {
    MUROSIMF_ASSERT(damping > 0);
    // Each round fixes at least one hinge more, so there are at most as many rounds as hinges.
    while (move_free(damping)) {
    }
  }

  /// [rad] Largest change of a hinge.
  [[nodiscard]] double size() const {
    double most = 0;
    for (const double change : change_) most = std::max(most, std::abs(change));
    return most;
  }
  /// Writes the angles after the step.
  void apply(Angles& q) const {
    for (std::size_t i = 0; i < q_.size(); ++i) {
      q[i] = std::clamp(q_[i] + change_[i], chain_.hinges[i].lowest, chain_.hinges[i].highest);
    }
  }

 private:
  /// True if a hinge reached its end, so that the others must move again.
  bool move_free(double damping) {
    // The 6x6 form costs the same for any number of hinges and is regular where J^T J of more than six is not.
    Sym6d A{diagonal(damping), {Vec3d{}, Vec3d{}, Vec3d{}}, diagonal(damping)};
    for (std::size_t i = 0; i < q_.size(); ++i) {
      if (!stopped_[i]) A += product_with_itself(columns_[i]);
    }
    const Cholesky6<double> factor(A);
    const Twistd y = factor.backward(factor.forward(rest_));
    bool stopped = false;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      if (stopped_[i]) continue;
      change_[i] = dot(columns_[i], Wrenchd{y.w, y.v});
      stopped = stop_at_end(i) || stopped;
    }
    return stopped;
  }

  bool stop_at_end(std::size_t i) {
    const LegHinge& hinge = chain_.hinges[i];
    const double wanted = q_[i] + change_[i];
    if (!(wanted < hinge.lowest || wanted > hinge.highest)) return false;
    MUROSIMF_ASSERT(!stopped_[i]);
    stopped_[i] = true;
    change_[i] = (wanted < hinge.lowest ? hinge.lowest : hinge.highest) - q_[i];
    rest_ -= Wrenchd{change_[i] * columns_[i].w, change_[i] * columns_[i].v};
    return true;
  }

  const LegChain& chain_;
  std::span<const double> q_;
  Wrenchd rest_;  // what is left of e, as the factors of a 6x6 matrix take it
  std::array<Twistd, most_hinges> columns_;
  Angles change_{};
  std::array<bool, most_hinges> stopped_{};
};

}  // namespace

SolverResult solve_leg(const LegChain& chain, const TipTarget& target, const SolverOptions& options,
                       std::span<double> q) noexcept {
  MUROSIMF_ASSERT(q.size() == chain.hinges.size() && q.size() <= most_hinges);
  MUROSIMF_ASSERT(options.weight >= 0 && options.reached > 0);
  SolverResult result;
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = std::clamp(q[i], chain.hinges[i].lowest, chain.hinges[i].highest);
  }
  Miss now = miss(chain, target, options.weight, q);
  double damping = first_damping;
  while (result.steps < options.most_steps && now.size > exact * exact && damping < most_damping) {
    ++result.steps;
    Step step(chain, now, options.weight, q);
    step.find(damping);
    Angles tried{};
    step.apply(tried);
    const Miss next = miss(chain, target, options.weight, std::span(tried).first(q.size()));
    // A long step is rejected even if it helps: the cycle after would jump to another solution.
    if (next.size < now.size && step.size() < longest_step) {
      std::copy_n(tried.begin(), q.size(), q.begin());
      now = next;
      damping = std::max(0.1 * damping, least_damping);
    } else {
      damping *= 10;
    }
  }
  result.distance = norm(now.error.v);
  if (options.weight > 0) result.angle = norm(now.error.w) / options.weight;
  result.reached = result.distance <= options.reached && result.angle <= options.reached;
  return result;
}

}  // namespace murosimf::locomotion
