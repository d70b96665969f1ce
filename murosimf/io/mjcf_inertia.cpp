#include "murosimf/io/mjcf_inertia.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

namespace murosimf::io {
namespace {

SymMat3d read_tensor(const MjcfAttributes& attributes, const MjcfCompiler& compiler) {
  const auto diagonal = attributes.numbers("diaginertia", 3, 3);
  const auto full = attributes.numbers("fullinertia", 6, 6);
  const XmlElement& element = attributes.element();
  if (diagonal.empty() == full.empty()) element.fail("inertial needs either diaginertia or fullinertia; write one");
  const Mat3d turn = read_orientation(attributes, compiler);
  if (!diagonal.empty()) return rotated(turn, SymMat3d{diagonal[0], diagonal[1], diagonal[2]});
  if (!is_identity(turn)) element.fail("fullinertia is in body axes already; remove the orientation of inertial");
  return {full[0], full[1], full[2], full[3], full[4], full[5]};
}

/// Principal moments in rising order.
Eigen::Vector3d principal_moments(const SymMat3d& I) {
  Eigen::Matrix3d matrix;
  matrix << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

void check_tensor(const XmlElement& element, const SymMat3d& tensor, std::vector<std::string>& warnings) {
  const Eigen::Vector3d moments = principal_moments(tensor);
  if (!(moments[0] > 0)) {
    element.fail(fmt::format("inertia is not positive definite (smallest principal moment {:.3g} kg m^2)", moments[0]));
  }
  // files carry about six digits
  if (moments[0] + moments[1] < moments[2] * (1.0 - 1e-5)) {
    warnings.push_back(
        fmt::format("{}: no solid body has the principal moments {:.4g} {:.4g} {:.4g} kg m^2: two of "
                    "them must not be less than the third",
                    element.where(), moments[0], moments[1], moments[2]));
  }
}

}  // namespace

MassProperties read_inertial(const XmlElement& element, const MjcfCompiler& compiler,
                             std::vector<std::string>& warnings) {
  MjcfAttributes attributes(element);
  attributes.overlay(element);
  if (!attributes.has("mass")) element.fail("inertial without mass; add mass=\"...\" in kg");
  MassProperties body;
  body.mass = attributes.number("mass", 0);
  if (!(body.mass > 0)) element.fail(fmt::format("mass {} kg is not positive; correct it", body.mass));
  body.center = attributes.vector("pos", {});
  body.inertia = read_tensor(attributes, compiler);
  check_tensor(element, body.inertia, warnings);
  return body;
}

bool mass_from_geoms(const XmlElement& body, const MjcfCompiler& compiler) {
  if (compiler.inertia_from_geom != InertiaFromGeom::if_missing) {
    return compiler.inertia_from_geom == InertiaFromGeom::always;
  }
  return body.children("inertial").empty();
}

MassProperties read_mass(const XmlElement& body, const std::vector<MassProperties>& solids,
                         const MjcfCompiler& compiler, std::vector<std::string>& warnings) {
  const auto inertials = body.children("inertial");
  if (inertials.size() > 1) inertials[1].fail("second inertial of the same body; keep one");
  if (mass_from_geoms(body, compiler)) return combined(solids);
  return inertials.empty() ? MassProperties{} : read_inertial(inertials[0], compiler, warnings);
}

}  // namespace murosimf::io
