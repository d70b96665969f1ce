/// mover.h - an entity that moves, as contact between moving bodies sees it.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/compound.h"
#include "murosimf/model/setup.h"

namespace murosimf::collision {

struct Mover {
  /// All columns of `setup`'s entity that contact needs.
  explicit Mover(Setup setup);

  [[nodiscard]] const Model& model() const { return entity->model(); }
  [[nodiscard]] bool can_be_pushed() const { return pushable[0] != 0; }
  /// Self-collision is wanted and can move something: where joints are given, it could not.
  [[nodiscard]] bool limbs_can_touch() const;
  /// In any posture of either.
  [[nodiscard]] bool is_near(const Mover& other) const {
    const Vec3d way = r[0] - other.r[0];
    const double reach = compound.reach() + other.compound.reach();
    return dot(way, way) < reach * reach;
  }
  /// Brings the tree to the present poses, unless it has been in this step.
  void refit() noexcept;
  [[nodiscard]] geometry::Pose pose(int shape) const noexcept { return compound.pose(shape, r, R); }
  /// Velocity [m/s] of the point of a body at `arm` [m] from its origin; world axes.
  [[nodiscard]] Vec3d velocity_at(int object, const Vec3d& arm) const { return v[object] + cross(w[object], arm); }

  /// Takes away what `push` has left of the step before; poses are new.
  void start_step() noexcept;
  /// A force [N] at a point [m] of a body, world frame; what cannot be pushed adds its impulse to the ledger.
  void push(int object, const Vec3d& point, const Vec3d& force, double dt) noexcept;
  /// The force falls with the velocity of the point, by `damping` [N s/m]; world frame.
  void damp(int object, const Vec3d& point, const SymMat3d& damping) noexcept;

  Entity* entity;
  Compound compound;
  std::vector<int> feet;  ///< shapes of the links that have a sole
  std::span<const Vec3d> r, v, w;
  std::span<const Mat3d> R;
  std::span<const double> pushable;
  std::span<Forced> interaction_force;  ///< [N m, N] of the pushes alone, for reports
  std::span<Forced> external_force;
  std::span<Sym6d> external_damping;
  std::span<Forced> ledger;
  std::span<Vec3d> separation;
  ContactSet& contacts;

 private:
  std::vector<int> pushed_;  // objects with an interaction force
  bool refitted_ = false;    // in this step
};

}  // namespace murosimf::collision
