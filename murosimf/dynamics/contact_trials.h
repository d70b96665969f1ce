/// contact_trials.h - iteration of motion and contact law in one step: trial steps until the law accepts one.
///
/// Order of calls in a level's step: settle() (unless an island solver has settled the step already, solved()), with
/// predict() in each trial; commit() before anything moves; renew() at the end.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/contact_interface.h"
#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/dynamics/integrator.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

/// The contacts of an entity, as seen by the level that moves it.
class ContactTrials {
 public:
  /// Takes the columns of contacts, and of external force and damping; the level itself writes the origins of the objects.
  explicit ContactTrials(Setup& setup);

  /// Throws SetupError if contact does not go with the integrator, or has another period than the motion [s].
  void check(Integrator integrator, double period) const { check_contacts(integrator, interface_, period); }
  /// Sets the object that answers impulses; null: none.
  void answer_by(collision::ImpulseResponse* response) noexcept { interface_.response = response; }

  /// Whether an island solver has settled the present step.
  [[nodiscard]] bool solved() const noexcept { return set_.solved; }
  /// Whether the entity is free in this step: neither points of its own nor of its island hold it.
  [[nodiscard]] bool none() const noexcept { return set_.points.empty() && !(set_.solved && set_.island_stands); }

  /// Objects with a point that touches the environment.
  [[nodiscard]] std::span<const int> touching() const noexcept { return set_.loaded; }

  /// Velocity after the step of every point: next_velocity(point) [m/s], world frame.
  template <class NextVelocity>
  void predict(const NextVelocity& next_velocity) noexcept {
    next_velocity_.clear();
    for (const collision::ContactPoint& c : set_.points) next_velocity_.push_back(next_velocity(c));
  }

  /// `trial` solves the step with the present external_force and external_damping, and calls predict(). It returns false
  /// if the motion itself requires another trial.
  template <class Trial>
  void settle(const Trial& trial) noexcept {
    bool settled = trial();
    for (int pass = 1; pass < collision::max_passes; ++pass) {
      if (!accept()) settled = false;
      if (settled) return;
      settled = trial();
    }
  }

  /// Whether the law accepts the velocities of the last predict(). If not, the law has changed the state of a point: the loads are
  /// updated, and the step must be repeated.
  [[nodiscard]] bool accept() noexcept;

  /// Ends a settled step: updates the law's memory, and the forces in the column, by the velocities of the last
  /// predict(). Does nothing if an island solver has done it already.
  void commit() noexcept;
  /// Marks the next step as not settled.
  void renew() noexcept { set_.solved = false; }

 private:
  collision::ContactSet& set_;
  collision::ContactInterface& interface_;
  std::span<const Vec3d> r_;  // [m] origins of the objects, world
  std::span<Wrenchd> external_force_;
  std::span<Sym6d> external_damping_;
  std::vector<Vec3d> next_velocity_;  // [m/s] of every point after the trial step; working memory
};

}  // namespace murosimf::dynamics
