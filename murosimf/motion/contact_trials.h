/// contact_trials.h - motion and contact law agree on one step: trial steps until the law accepts one.
///
/// What a level does about contact, in this order: settle() (unless an island solver has done it already, solved()), with
/// predict() in each trial; commit() before anything moves; renew() at the end.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/contact_interface.h"
#include "murosimf/collision/contact_law.h"
#include "murosimf/model/setup.h"
#include "murosimf/motion/integrator.h"

namespace murosimf::motion {

/// The contacts of an entity, as the level that moves it has them.
class ContactTrials {
 public:
  /// Takes the columns of contacts, and of external force and damping; origins of the objects are the level's own.
  explicit ContactTrials(Setup& setup);

  /// Throws SetupError if contact does not go with the integrator, or has another period than the motion [s].
  void check(Integrator integrator, double period) const { check_contacts(integrator, interface_, period); }
  /// Who answers to impulses from now on; null: nobody.
  void answer_by(collision::ImpulseResponse* response) noexcept { interface_.response = response; }

  /// An island solver has settled the present step.
  [[nodiscard]] bool solved() const noexcept { return set_.solved; }
  /// Nothing holds the entity in this step: neither points of its own nor those of its island.
  [[nodiscard]] bool none() const noexcept { return set_.points.empty() && !(set_.solved && set_.island_stands); }

  /// Objects of which a point touches the environment.
  [[nodiscard]] std::span<const int> touching() const noexcept { return set_.loaded; }

  /// Velocity after the step of every point: next_velocity(point) [m/s], world frame.
  template <class NextVelocity>
  void predict(const NextVelocity& next_velocity) noexcept {
    next_velocity_.clear();
    for (const collision::ContactPoint& c : set_.points) next_velocity_.push_back(next_velocity(c));
  }

  /// `trial` solves the step with the present external_force and external_damping, and calls predict(). It returns false
  /// if the motion itself asks for another one.
  template <class Trial>
  void settle(const Trial& trial) noexcept {
    bool settled = trial();
    for (int pass = 1; pass < collision::max_passes; ++pass) {
      if (!accept()) settled = false;
      if (settled) return;
      settled = trial();
    }
  }

  /// Whether the law agrees with the velocities of the last predict(). False if it has changed its mind: loads are others, and the
  /// step must be repeated.
  [[nodiscard]] bool accept() noexcept;

  /// The step is settled: memory of the law, and the forces that acted in the column, by the velocities of the last
  /// predict(). Does nothing if an island solver has done it already.
  void commit() noexcept;
  /// The next step is to be settled anew.
  void renew() noexcept { set_.solved = false; }

 private:
  collision::ContactSet& set_;
  collision::ContactInterface& interface_;
  std::span<const Vec3d> r_;  // [m] origins of the objects, world
  std::span<Wrenchd> external_force_;
  std::span<Sym6d> external_damping_;
  std::vector<Vec3d> next_velocity_;  // [m/s] of every point after the trial step; working memory
};

}  // namespace murosimf::motion
