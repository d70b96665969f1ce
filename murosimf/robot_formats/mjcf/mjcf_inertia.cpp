#include "murosimf/robot_formats/mjcf/mjcf_inertia.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr double rounding = 1e-9;  // [1] of a principal moment that is zero, relative to all three

SymMat3d read_tensor(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  const auto diagonal = attributes.numbers("diaginertia", 3, 3);
  const auto full = attributes.numbers("fullinertia", 6, 6);
  const files::XmlElement& element = attributes.element();
  if (diagonal.empty() == full.empty()) element.fail("inertial needs either diaginertia or fullinertia; write one");
  const Mat3d turn = read_orientation(attributes, compiler);
  // Principal axes are given by an orientation; the full tensor is in body axes already.
  if (!diagonal.empty()) return rotated(turn, SymMat3d{diagonal[0], diagonal[1], diagonal[2]});
  if (!is_identity(turn)) element.fail("fullinertia is in body axes already; remove the orientation of inertial");
  return {full[0], full[1], full[2], full[3], full[4], full[5]};
}

void warn_about(const SymMat3d& tensor, const files::XmlElement& element, std::vector<std::string>& warnings) {
  const Vec3d moments = robot_formats::principal_moments(tensor);
  if (!robot_formats::breaks_triangle_inequality(moments)) return;
  warnings.push_back(
      fmt::format("{}: no solid body has the principal moments {:.4g} {:.4g} {:.4g} kg m^2: two of "
                  "them must not be less than the third",
                  element.where(), moments.x, moments.y, moments.z));
}

robot_formats::MassProperties bounded(robot_formats::MassProperties body, const MjcfCompiler& compiler) {
  body.mass = std::max(body.mass, compiler.least_mass);
  const Vec3d moments = robot_formats::principal_moments(body.inertia);
  if (moments.x < compiler.least_inertia)
    body.inertia = robot_formats::with_least_moment(body.inertia, compiler.least_inertia);
  // A ball of the same mean moment, as MuJoCo does it.
  if (compiler.balance_inertia && robot_formats::breaks_triangle_inequality(moments)) {
    const double mean = (moments.x + moments.y + moments.z) / 3;
    body.inertia = {mean, mean, mean};
  }
  MUROSIMF_ASSERT(body.mass >= compiler.least_mass);
  return body;
}

/// Reads an inertial. `moves`: the body has joints of its own; one that is fixed to its parent may be massless.
robot_formats::MassProperties read_inertial(const files::XmlElement& element, bool moves,
                                            const MjcfCompiler& compiler) {
  MjcfAttributes attributes(element);
  attributes.overlay(element);
  if (!attributes.has("mass")) element.fail("inertial without mass; add mass=\"...\" in kg");
  robot_formats::MassProperties body;
  body.mass = attributes.number("mass", 0);
  if (body.mass == 0 && !moves) return {};
  if (!(body.mass > 0)) element.fail(fmt::format("mass {} kg is not positive; correct it", body.mass));
  body.center = attributes.vector("pos", {});
  body.inertia = read_tensor(attributes, compiler);
  const Vec3d moments = robot_formats::principal_moments(body.inertia);
  const double least = moments.x;
  const bool point =
      !moves && least >= -rounding * norm(moments);  // the body that it is fixed to has the other moments
  if (!(least > 0) && !point && !(compiler.least_inertia > 0)) {
    element.fail(fmt::format("inertia is not positive definite (smallest principal moment {:.3g} kg m^2)", least));
  }
  return body;
}

}  // namespace

bool mass_from_geoms(const files::XmlElement& body, const MjcfCompiler& compiler) {
  if (compiler.inertia_from_geom != InertiaFromGeom::if_missing) {
    return compiler.inertia_from_geom == InertiaFromGeom::always;
  }
  return body.children("inertial").empty();
}

robot_formats::MassProperties read_mass(const files::XmlElement& body,
                                        const std::vector<robot_formats::MassProperties>& solids,
                                        const MjcfCompiler& compiler, std::vector<std::string>& warnings) {
  const auto inertials = body.children("inertial");
  if (inertials.size() > 1) inertials[1].fail("second inertial of the same body; keep one");
  if (mass_from_geoms(body, compiler)) return bounded(robot_formats::combined(solids), compiler);
  if (inertials.empty()) return bounded({}, compiler);
  const bool moves = !elements_in(body, "joint").empty() || !elements_in(body, "freejoint").empty();
  const robot_formats::MassProperties solid = read_inertial(inertials[0], moves, compiler);
  const robot_formats::MassProperties result = bounded(solid, compiler);
  if (!compiler.balance_inertia) warn_about(result.inertia, inertials[0], warnings);
  return result;
}

}  // namespace murosimf::robot_formats::mjcf
