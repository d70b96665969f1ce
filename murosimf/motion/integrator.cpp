#include "murosimf/motion/integrator.h"

#include <array>

#include "murosimf/collision/contact_law.h"
#include "murosimf/model/error.h"

namespace murosimf::motion {
namespace {

constexpr std::array entries{
    IntegratorEntry{"semi_implicit_euler", "first order, contacts and servos implicit; the default",
                    Integrator::semi_implicit_euler},
    IntegratorEntry{"rk4", "Runge-Kutta of fourth order, for validation; needs an explicit contact law",
                    Integrator::rk4},
};

}  // namespace

std::span<const IntegratorEntry> integrators() { return entries; }

void check_integrator(Integrator integrator, const collision::ContactSet& contacts) {
  if (integrator != Integrator::rk4 || !contacts.law) return;
  if (contacts.law->island_use() == collision::IslandUse::never) return;
  throw SetupError(
      "integrator 'rk4' needs an explicit contact law (kelvin_voigt, paper or paper_multipoint): implicit_stick and "
      "island_gauss_seidel settle the whole step");
}

}  // namespace murosimf::motion
