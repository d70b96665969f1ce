/// contact_trials.h - motion and contact law agree on one step: trial steps until the law accepts one.
#pragma once

#include <span>

#include "murosimf/collision/contact_law.h"

namespace murosimf::motion {

/// `trial` solves the step with the present external_force and external_damping, and fills
/// contacts.next_velocity. `r` [m] origins of the objects.
template <class Trial>
void settle_contacts(collision::ContactSet& contacts, std::span<const Vec3d> r, std::span<Forced> external_force,
                     std::span<Sym6d> external_damping, const Trial& trial) noexcept {
  trial();
  if (!contacts.law) return;
  for (int pass = 1; pass < collision::max_passes && !contacts.law->accept(contacts); ++pass) {
    collision::write_loads(contacts, r, external_force, external_damping);
    trial();
  }
}

}  // namespace murosimf::motion
