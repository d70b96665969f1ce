/// material.h - what happens between two surfaces depends on the pair: a table of pairs, by material name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/model/shape.h"

namespace murosimf {

/// Constants of one pair of surfaces.
struct PairSurface {
  double friction = 0.8;     ///< [1] Coulomb coefficient
  double rolling = 0.0;      ///< [1] rolling resistance: moment = rolling * radius * normal force
  double torsional = 0.0;    ///< [m] resistance of a round body to spinning: moment = torsional * normal force
  double restitution = 0.5;  ///< [1] speed kept by a round body that bounces, 0..1
  double stiffness = 0.0;    ///< [N/m] per contact point; 0: chosen from the weight (contact_parameters.h)
  double static_deflection =
      1e-4;  ///< [m] how far a body presses its points in by its weight on Earth, without a stiffness
  double friction_anisotropy =
      0;  ///< [1] g, 0 <= g < 1: friction (1 - g) along the pile of the ground, (1 + g) against it
  double rolling_anisotropy = 0;  ///< [1] the same of the rolling resistance
  // of the paper's laws (paper_law.h); figures of the project's prototype, the paper gives none
  double rebound = 0.4;         ///< [1] s_b: share of the spring's force while bodies part, 0..1
  double viscous_friction = 5;  ///< [s/m] s_mu: force per normal force and velocity
  double spin_friction = 0.01;  ///< [m s] s_nu: moment per normal force and turning rate
};

class MaterialTable {
 public:
  /// The pairs that come with the program: "rubber", "plastic" and "ball" among each other and with the grounds
  /// "carpet", "grass" and "wood".
  [[nodiscard]] static MaterialTable standard();

  /// Order of the two names does not matter. Throws SetupError if a number is not finite or impossible.
  void set(const std::string& a, const std::string& b, const PairSurface& pair);

  /// One number of all pairs, also of those that are not in the table. Throws SetupError as set() does.
  void set_all(double PairSurface::*number, double value);

  /// True if some pair of the table has this material.
  [[nodiscard]] bool knows(const std::string& material) const;
  [[nodiscard]] std::vector<std::string_view> names() const;
  /// What the table has, by the names of both; the empty name is that of surfaces without one.
  [[nodiscard]] const auto& pairs() const { return pairs_; }

  /// The table's entry; for pairs that are not in it, the larger friction of the two surfaces (as in MuJoCo) and
  /// the defaults above.
  [[nodiscard]] PairSurface find(const Surface& a, const Surface& b) const;

 private:
  PairSurface others_;                    // pairs that are not in the table; without its friction:
  std::optional<double> other_friction_;  // [1] of those; empty: the larger one of the two surfaces
  std::map<std::pair<std::string, std::string>, PairSurface> pairs_;
};

}  // namespace murosimf
