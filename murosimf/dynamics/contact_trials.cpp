#include "murosimf/dynamics/contact_trials.h"

#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {

ContactTrials::ContactTrials(Setup& setup)
    : set_(setup.write(collision::contacts)[0]),
      interface_(setup.write(collision::contact_interface)[0]),
      r_(setup.write(properties::position)),
      external_force_(setup.write(properties::external_force)),
      external_damping_(setup.write(properties::external_damping)) {}

bool ContactTrials::accept() noexcept {
  MUROSIMF_ASSERT(!interface_.law || next_velocity_.size() == set_.points.size());
  if (!interface_.law || interface_.law->accept(set_.points, interface_.terms, next_velocity_)) return true;
  collision::write_loads(set_, r_, external_force_, external_damping_);
  return false;
}

void ContactTrials::commit() noexcept {
  if (!interface_.law || set_.solved) return;
  MUROSIMF_ASSERT(next_velocity_.size() == set_.points.size());
  interface_.law->commit(set_.points, interface_.terms, next_velocity_);
  // the final forces replace those of the trial: sensors and recorders read what has acted
  collision::write_final_forces(set_, r_, external_force_);
}

}  // namespace murosimf::dynamics
