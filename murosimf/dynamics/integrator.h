/// integrator.h - methods by which a step advances positions and velocities: chosen by name, per entity.
///
/// * semi_implicit_euler (default): velocities first, then positions with the new velocities (multibody/integrate.h). First
///   order; contacts, servos and stops are settled for the end of the step, so long steps are stable.
/// * rk4: the classical Runge-Kutta method of fourth order, for validation. Servos and stops are explicit, contact
///   forces are constant during the step, so it needs an explicit contact law and steps that resolve every motion.
///   A step that an island solver has settled (collision/body_contact.h) is a semi-implicit one.
///
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, sec. II.1.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "murosimf/collision/contact_interface.h"
#include "murosimf/math/assert.h"

namespace murosimf::dynamics {

enum class Integrator { semi_implicit_euler, rk4 };

struct IntegratorEntry {
  std::string_view name, meaning;
  Integrator integrator;
};

[[nodiscard]] std::span<const IntegratorEntry> integrators();

/// Throws SetupError if the entity's contact does not go with the integrator, or has another period than its motion [s].
void check_contacts(Integrator integrator, const collision::ContactInterface& contacts, double period);

/// One step of h [s] > 0 of y' = rate(y) by the classical Runge-Kutta method; rate(y, dy) fills dy.
class RungeKutta4 {
 public:
  template <class Rate>
  void step(std::vector<double>& y, double h, const Rate& rate) {
    MUROSIMF_ASSERT(h > 0);
    start_ = y;
    sum_.assign(y.size(), 0.0);
    slope_.resize(y.size());
    constexpr double weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    constexpr double way[] = {0.5, 0.5, 1.0, 0.0};
    for (int stage = 0; stage < 4; ++stage) {
      rate(y, slope_);
      MUROSIMF_ASSERT(slope_.size() == y.size());
      for (std::size_t i = 0; i < y.size(); ++i) {
        sum_[i] += weight[stage] * slope_[i];
        y[i] = start_[i] + way[stage] * h * slope_[i];
      }
    }
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = start_[i] + h * sum_[i];
  }

 private:
  std::vector<double> start_, sum_, slope_;  // working memory
};

}  // namespace murosimf::dynamics
