/// moving_entity.h - an entity that moves, as contact between moving bodies sees it.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/compound.h"
#include "murosimf/collision/contact_interface.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/world/setup.h"

namespace murosimf::collision {

struct MovingEntity {
  /// All columns of `setup`'s entity that contact needs.
  explicit MovingEntity(Setup setup);

  [[nodiscard]] const Model& model() const { return entity->model(); }
  [[nodiscard]] bool can_be_pushed() const { return dynamic[0] != 0; }
  /// It touches none: absent, frozen, or alone with steps of its own (multirate_stepping.h).
  [[nodiscard]] bool apart() const { return entity->idle() || (!step_ratio.empty() && step_ratio[0] > 1); }
  /// Self-collision is wanted and can move something: where joints are given, it could not.
  [[nodiscard]] bool limbs_can_touch() const;
  /// Around it in any posture.
  [[nodiscard]] geometry::BoundingSphere reach() const { return {r[0], compound.reach()}; }
  /// Has the tree enclose the present poses.
  void refit() noexcept;
  /// How often the tree had to change.
  [[nodiscard]] std::uint64_t fits() const { return fits_; }
  /// Around a shape, without margin.
  [[nodiscard]] geometry::BoundingSphere sphere(int shape) const noexcept;
  /// [m] of a shape (interpenetration.h).
  [[nodiscard]] double thickness(int shape) const { return thicknesses_[shape]; }
  /// Pose of a shape in the world; computed at the first request of a step.
  [[nodiscard]] const Transformd& pose(int shape) noexcept;
  /// Velocity [m/s] of the point of a body at `arm` [m] from its origin; world axes.
  [[nodiscard]] Vec3d velocity_at(int object, const Vec3d& arm) const { return v[object] + cross(w[object], arm); }

  /// What was pushed in the last step; all else is worked out anew.
  void state(StateArchive& archive) { archive(pushed_); }
  void forget_pushes() { pushed_.clear(); }

  /// Of another model of the same objects.
  void take_shapes();

  /// Takes away what `push` has left of the step before; poses are new.
  void start_step() noexcept;
  /// A force [N] at a point [m] of a body, world frame; what cannot be pushed adds its impulse to the ledger.
  void push(int object, const Vec3d& point, const Vec3d& force, double dt) noexcept;
  /// The same of a moment [N m], world axes.
  void turn(int object, const Vec3d& moment, double dt) noexcept;
  /// The force falls with the velocity of the point, by `damping` [N s/m]; world frame.
  void damp(int object, const Vec3d& point, const SymMat3d& damping) noexcept;

  Entity* entity;
  int number;  ///< of the entity in the world (World::index_of)
  Compound compound;
  std::vector<int> feet;  ///< shapes of the links that have a sole
  NearStatics is_near_statics;
  std::span<const Vec3d> r, v, w;
  std::span<const Mat3d> R;
  std::span<const double> dynamic;
  std::span<const double> step_ratio;    ///< empty: its steps are the scene's
  std::span<Wrenchd> interaction_force;  ///< [N m, N] of the pushes alone, for reports
  std::span<Wrenchd> external_force;
  std::span<Sym6d> external_damping;
  std::span<Wrenchd> ledger;
  std::span<Vec3d> separation;
  ContactSet& contacts;
  ContactInterface& interface;

 private:
  void take_sizes();
  void add(int object, const Wrenchd& at_origin) noexcept;

  std::vector<int> pushed_;  // objects with an interaction force
  bool refitted_ = false;    // in this step
  std::uint64_t fits_ = 0;
  std::uint64_t step_ = 0;
  struct KnownPose {
    std::uint64_t step = 0;  // of which
    Transformd pose;
  };
  std::vector<KnownPose> poses_;             // of each shape
  std::vector<double> radii_, thicknesses_;  // [m] of each shape
};

}  // namespace murosimf::collision
