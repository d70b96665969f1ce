/// contact_trials.h - motion and contact law agree on one step: trial steps until the law accepts one.
#pragma once

#include <span>

#include "murosimf/collision/contact_law.h"

namespace murosimf::motion {

/// `trial` solves the step with the present external_force and external_damping, and fills
/// contacts.next_velocity. It returns false if the motion itself asks for another one. `r` [m] origins of the objects.
template <class Trial>
void settle_contacts(collision::ContactSet& contacts, std::span<const Vec3d> r, std::span<Wrenchd> external_force,
                     std::span<Sym6d> external_damping, const Trial& trial) noexcept {
  bool settled = trial();
  for (int pass = 1; pass < collision::max_passes; ++pass) {
    if (contacts.law && !contacts.law->accept(contacts)) {
      collision::write_loads(contacts, r, external_force, external_damping);
      settled = false;
    }
    if (settled) return;
    settled = trial();
  }
}

}  // namespace murosimf::motion
