/// mjcf_geom.h - geoms of an MJCF file: shape, place and surface, and the mass that a solid of this shape has.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/io/mjcf_frame.h"
#include "murosimf/model/shape.h"

namespace murosimf::io {

/// Mass, center and inertia of a body or of a part of it.
struct MassProperties {
  double mass = 0;   ///< [kg]
  Vec3d center;      ///< [m] body frame
  SymMat3d inertia;  ///< [kg m^2] at the center, body axes
};

struct MjcfGeom {
  PlacedShape placed;
  MassProperties solid;  ///< from `mass`, or from `density` [kg/m^3] (1000 if the file is silent)
};

/// Nothing for a mesh, which is not supported: refused unless `lenient`, then a line in `warnings`.
[[nodiscard]] std::optional<MjcfGeom> read_geom(const MjcfAttributes& attributes, const MjcfCompiler& compiler,
                                                bool lenient, std::vector<std::string>& warnings);

/// [m^3]; zero for a plane.
[[nodiscard]] double volume(const Shape& shape);
/// [kg m^2] of a homogeneous solid of unit mass, at its center, shape axes; zero for a plane.
[[nodiscard]] SymMat3d unit_inertia(const Shape& shape);
/// Several parts as one: center by weights, inertia by the parallel-axis theorem.
[[nodiscard]] MassProperties combined(const std::vector<MassProperties>& parts);

}  // namespace murosimf::io
