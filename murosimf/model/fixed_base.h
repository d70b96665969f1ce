/// fixed_base.h - a robot whose base is bolted to the world: an arm on its stand, a planar walker on its rails.
///
/// A constant of the base that every level heeds: the base keeps its place and only the joints move. The base's frame stands where the
/// scene puts the robot, and not on its lowest point: heights of its file count from there.
#pragma once

#include "murosimf/model/model.h"
#include "murosimf/model/property.h"

namespace murosimf {

namespace properties {

inline constexpr Property<double> fixed_base{
    {"fixed_base", "1", "-", "above 0: the base is bolted to the world", Scope::base}};

}  // namespace properties

[[nodiscard]] inline bool has_fixed_base(const Model& model) {
  const double* fixed = model.find(properties::fixed_base, 0);
  return fixed && *fixed > 0;
}

}  // namespace murosimf
