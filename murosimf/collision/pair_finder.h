/// pair_finder.h - which bodies of moving entities touch, with the memory that their contacts had in the step before.
///
/// Whose spheres of reach meet is found by sorting (geometry/sweep_and_prune.h). These have their trees refitted and
/// descended (compound.h), unless both have moved by less than the trees' margin since the last time; shapes whose volumes
/// overlap get the exact test (geometry/collide.h).
/// Kinds of shapes (model/shape.h) are compared within one entity only: a robot's file does not refer to other robots.
/// Contacts take the constants of the lighter entity.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/collision/moving_entity.h"
#include "murosimf/geometry/collide.h"
#include "murosimf/geometry/sweep_and_prune.h"
#include "murosimf/model/material.h"

namespace murosimf::collision {

class PairFinder {
 public:
  /// gravity [m/s^2], world frame.
  PairFinder(const MaterialTable& materials, const ContactConditions& conditions, const Vec3d& gravity);

  /// Of those that find() will be called with, in their order.
  void add(const MovingEntity& moving_entity);
  /// The last of them.
  void take_back() noexcept;
  /// The model of one of them is another one; of the points in `set`, those of the others go on.
  void exchange_materials(const MaterialTable& materials) { materials_ = materials; }
  void model_exchanged(const std::vector<MovingEntity>& moving_entities, const Entity& entity, PairSet& set);
  /// Says anew of which constants the points are: kinds have come or gone.
  void number_surfaces(PairSet& set) const noexcept;

  /// Constants of all pairs of surfaces that can meet; of kinds i and j at i * kinds + j.
  [[nodiscard]] std::vector<ContactParameters> parameters() const;
  /// Renews set.points and set.blocked; points of the step before go to set.previous. set.parameters must be those of parameters().
  void find(std::vector<MovingEntity>& moving_entities, PairSet& set) noexcept;
  /// The next find() looks for shapes that are near each other as if everything had moved; what it finds is the same.
  void forget_neighbors() noexcept;
  /// Entities whose spheres of reach met in the last find(), sorted; a < b.
  [[nodiscard]] const std::vector<std::pair<int, int>>& within_reach() const { return pairs_; }

 private:
  /// One surface of one model: contacts between the same two kinds have the same constants.
  struct Kind {
    const Model* model;
    Surface surface;
  };
  /// Pairs of shapes of two entities whose volumes overlap; right as long as neither tree has changed since.
  struct Neighbors {
    std::uint64_t fits_a = 0, fits_b = 0;
    std::vector<std::pair<int, int>> shapes;
  };
  void add_kinds(const MovingEntity& moving_entity);
  [[nodiscard]] std::uint32_t surface_of(int a, int b, int shape_a, int shape_b) const noexcept;
  [[nodiscard]] std::size_t kind_of(const Model& model, const Surface& surface);
  void renew_neighbors();
  void find_between(std::vector<MovingEntity>& moving_entities, int a, int b, Neighbors& near, PairSet& set) noexcept;
  void test(std::vector<MovingEntity>& moving_entities, int a, int b, const std::vector<std::pair<int, int>>& shapes,
            PairSet& set) noexcept;
  void add_contacts(const std::vector<MovingEntity>& moving_entities, const PairContact& pair,
                    geometry::Manifold& manifold, PairSet& set) const noexcept;

  MaterialTable materials_;
  ContactConditions conditions_;
  Vec3d gravity_;  // [m/s^2] world
  std::vector<Kind> kinds_;
  std::vector<std::vector<std::size_t>> kinds_of_shapes_;  // by moving entity and shape
  std::vector<std::pair<int, int>> pairs_;                 // of the last find(): within_reach()
  std::vector<Neighbors> neighbors_;                       // of these
  std::vector<Neighbors> limbs_;                           // of each entity with itself
  std::vector<Neighbors> old_;                             // working memory
  std::vector<geometry::BoundingSphere> reach_;            // of each entity; working memory
  geometry::SweepAndPrune sweep_;
};

}  // namespace murosimf::collision
