/// pair_finder.h - which bodies of moving entities touch, with the memory that their contacts had in the step before.
///
/// Every pair of entities whose bounding spheres meet, every pair of their shapes whose bounding spheres meet, then the
/// exact test (body_pairs.h). Contacts take the constants of the lighter entity.
#pragma once

#include <vector>

#include "murosimf/collision/mover.h"
#include "murosimf/model/material.h"

namespace murosimf::collision {

class PairFinder {
 public:
  /// gravity [m/s^2] magnitude, dt [s] of the step.
  PairFinder(const std::vector<Mover>& movers, const MaterialTable& materials, double gravity, double dt);

  /// Constants of all pairs of surfaces that can meet.
  [[nodiscard]] const std::vector<ContactParameters>& parameters() const { return parameters_; }
  /// Renews set.points; those of the step before go to set.previous.
  void find(const std::vector<Mover>& movers, PairSet& set);

 private:
  /// One surface of one model: contacts between the same two kinds have the same constants.
  struct Kind {
    const Model* model;
    Surface surface;
  };
  [[nodiscard]] std::size_t kind_of(const Model& model, const Surface& surface);
  void find_between(const std::vector<Mover>& movers, int a, int b, PairSet& set);
  void place_shapes(const Mover& mover, std::vector<PlacedInWorld>& placed);

  std::vector<Kind> kinds_;
  std::vector<std::vector<std::size_t>> kinds_of_shapes_;  // by mover and shape
  std::vector<ContactParameters> parameters_;              // of kinds i and j at i * kinds + j
  std::vector<PlacedInWorld> shapes_a_, shapes_b_;         // working memory
};

}  // namespace murosimf::collision
