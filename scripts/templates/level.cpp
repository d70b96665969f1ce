#include "murosimf/dynamics/new_name.h"

#include "murosimf/collision/contact_properties.h"

namespace murosimf::dynamics {

NewName::NewName(Setup& setup, const JointReferenceOptions& reference)
    : entity_(setup.entity()),
      columns_(setup),
      reference_(setup, reference),
      dynamic_(setup.write(properties::dynamic)[0]) {}

void NewName::initialize() {
  reference_.initialize(columns_);
  place_at_start(columns_, entity_);
  dynamic_ = 0;  // 1 if contact forces move the base: then `has` says so, and step() adds external_force
  move_links();
}

void NewName::take_over(const Momentum&) {  // a level that keeps momentum goes on with it
  reference_.take_over(columns_);
  dynamic_ = 0;
  move_links();
}

void NewName::step(const Instant& instant) noexcept {
  if (!reference_.advance(columns_, seconds(instant.period))) {
    columns_.stop();
    return entity_.freeze("a joint position or target is no sensible number");
  }
  move_links();
}

/// The base is at rest where it was, or where it was placed since. What moves a base changes row 0 here.
void NewName::move_links() noexcept {
  columns_.R[0] = to_matrix(columns_.Q[0]);
  columns_.v[0] = columns_.w[0] = {};
  columns_.update_poses();
  columns_.update_velocities();
  columns_.remember_base();
}

}  // namespace murosimf::dynamics
