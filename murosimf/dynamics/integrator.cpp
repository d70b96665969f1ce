#include "murosimf/dynamics/integrator.h"

#include <array>

#include <fmt/format.h>

#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/model/error.h"

namespace murosimf::dynamics {
namespace {

constexpr std::array entries{
    IntegratorEntry{"semi_implicit_euler", "first order, contacts and servos implicit; the default",
                    Integrator::semi_implicit_euler},
    IntegratorEntry{"rk4", "Runge-Kutta of fourth order, for validation; needs an explicit contact law",
                    Integrator::rk4},
};

}  // namespace

std::span<const IntegratorEntry> integrators() { return entries; }

void check_contacts(Integrator integrator, const collision::ContactInterface& contacts, double period) {
  if (contacts.terms.dt > 0 && contacts.terms.dt != period) {
    throw SetupError(fmt::format("its motion has steps of {:.3g} ms, its contact of {:.3g} ms; attach both at one rate",
                                 1e3 * period, 1e3 * contacts.terms.dt));
  }
  if (integrator != Integrator::rk4) return;
  // a damper that another algorithm has made implicit would be explicit here, and unstable
  if (contacts.damped_by_others) {
    throw SetupError("integrator 'rk4' does not go with 'carry' between bodies, which counts on implicit steps");
  }
  if (!contacts.law || contacts.law->island_use() == collision::IslandUse::never) return;
  throw SetupError(
      "integrator 'rk4' needs an explicit contact law (kelvin_voigt, paper or paper_multipoint): implicit_stick and "
      "island_gauss_seidel settle the whole step");
}

}  // namespace murosimf::dynamics
