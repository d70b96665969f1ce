/// places.h - free places on the field and around it.
#pragma once

#include <optional>
#include <vector>

#include "murosimf/dataset/dice.h"
#include "murosimf/dataset/ground_reach.h"
#include "murosimf/imaging/lens.h"
#include "murosimf/math/mat3.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::dataset {

/// A camera that looks for places.
struct Looker {
  const imaging::Lens* lens = nullptr;
  Vec3d eye;   ///< [m] world
  Mat3d axes;  ///< optical axes to world axes
  [[nodiscard]] bool sees(const Vec3d& point) const;
};

class Places {
 public:
  explicit Places(const scene_file::FieldSize& field) : field_(&field) {}

  /// A place on the field for a disc of that radius [m]; nothing if there is none after some tries. It is taken from then on.
  [[nodiscard]] std::optional<Vec3d> on_field(Dice& dice, double radius);
  /// The same where `looker` sees the point at `height` [m] above it, in that distance [m].
  [[nodiscard]] std::optional<Vec3d> in_view(Dice& dice, double radius, const Looker& looker, const Range& distance,
                                             double height);
  /// Around the field, up to `reach` [m] beyond its lines; `looker`, if given, must see it.
  [[nodiscard]] std::optional<Vec3d> around(Dice& dice, double radius, double reach, const Looker* looker);
  void take(const Vec3d& place, double radius) { taken_.push_back({place, radius}); }
  void take(const Footprint& footprint) { blocked_.push_back(footprint); }

 private:
  struct Disc {
    Vec3d place;
    double radius;
  };
  [[nodiscard]] bool is_free(const Vec3d& place, double radius) const;

  const scene_file::FieldSize* field_;
  std::vector<Disc> taken_;
  std::vector<Footprint> blocked_;
};

}  // namespace murosimf::dataset
