#include "murosimf/robot_formats/mass_properties.h"

#include <Eigen/Eigenvalues>

#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/math/assert.h"

namespace murosimf::robot_formats {
namespace {

double cube(double x) { return x * x * x; }

/// Diagonal of a box-like or ellipsoid-like inertia: factor * (b^2 + c^2, a^2 + c^2, a^2 + b^2).
SymMat3d from_squares(double factor, const Vec3d& a) {
  const double xx = a.x * a.x, yy = a.y * a.y, zz = a.z * a.z;
  return {factor * (yy + zz), factor * (xx + zz), factor * (xx + yy)};
}

struct Volume {
  double operator()(const Sphere& s) const { return 4.0 / 3.0 * pi * cube(s.radius); }
  double operator()(const Box& s) const { return 8.0 * s.half_size.x * s.half_size.y * s.half_size.z; }
  double operator()(const Capsule& s) const {
    return (*this)(Sphere{s.radius}) + (*this)(Cylinder{s.radius, s.half_length});
  }
  double operator()(const Cylinder& s) const { return 2.0 * pi * s.radius * s.radius * s.half_length; }
  double operator()(const Ellipsoid& s) const { return 4.0 / 3.0 * pi * s.semi_axes.x * s.semi_axes.y * s.semi_axes.z; }
  double operator()(const Plane&) const { return 0; }
  double operator()(const Convex& s) const { return geometry::solid_mass(*s.hull).volume; }
};

// Source: tables of moments of inertia of homogeneous solids, as in Goldstein, Classical Mechanics, or any
// handbook of mechanics; the capsule is a cylinder and two half balls, with centers 3/8 r from their flat side.
struct UnitInertia {
  SymMat3d operator()(const Sphere& s) const { return diagonal(0.4 * s.radius * s.radius); }
  SymMat3d operator()(const Box& s) const { return from_squares(1.0 / 3.0, s.half_size); }
  SymMat3d operator()(const Ellipsoid& s) const { return from_squares(0.2, s.semi_axes); }
  SymMat3d operator()(const Cylinder& s) const {
    const double rr = s.radius * s.radius;
    const double across = 0.25 * rr + s.half_length * s.half_length / 3.0;
    return {across, across, 0.5 * rr};
  }
  SymMat3d operator()(const Capsule& s) const {
    const double r = s.radius, h = s.half_length;
    const double balls = volume(Sphere{r}) / volume(Shape{s});  // share of the mass
    // Half balls: 2/5 r^2 about the middle of their flat side, moved to the middle of the capsule.
    const double across = 0.4 * r * r + h * h + 0.75 * h * r;
    const SymMat3d caps{across, across, 0.4 * r * r};
    return balls * caps + (1.0 - balls) * (*this)(Cylinder{r, h});
  }
  SymMat3d operator()(const Plane&) const { return {}; }
  SymMat3d operator()(const Convex& s) const {
    const auto solid = geometry::solid_mass(*s.hull);
    MUROSIMF_ASSERT(solid.volume != 0);
    return (1.0 / solid.volume) * solid.inertia;
  }
};

Eigen::Matrix3d matrix_of(const SymMat3d& I) {
  Eigen::Matrix3d matrix;
  matrix << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  return matrix;
}

}  // namespace

double volume(const Shape& shape) { return std::visit(Volume{}, shape); }

SymMat3d unit_inertia(const Shape& shape) { return std::visit(UnitInertia{}, shape); }

MassProperties combined(const std::vector<MassProperties>& parts) {
  MassProperties sum;
  for (const MassProperties& part : parts) {
    MUROSIMF_ASSERT(!(part.mass < 0));
    sum.mass += part.mass;
    sum.center += part.mass * part.center;
  }
  if (sum.mass > 0) sum.center = (1.0 / sum.mass) * sum.center;
  // Massless parts alone have no center; it stays at the origin.
  for (const MassProperties& part : parts) {
    sum.inertia += part.inertia + part.mass * inertia_of_point(part.center - sum.center);
  }
  return sum;
}

MassProperties moved(const MassProperties& body, const Vec3d& position, const Mat3d& orientation) {
  return {body.mass, position + orientation * body.center, rotated(orientation, body.inertia)};
}

Vec3d principal_moments(const SymMat3d& inertia) {
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix_of(inertia), Eigen::EigenvaluesOnly).eigenvalues();
  return {moments[0], moments[1], moments[2]};
}

bool breaks_triangle_inequality(const Vec3d& moments) { return moments.x + moments.y < moments.z * (1.0 - 1e-5); }

SymMat3d with_least_moment(const SymMat3d& inertia, double least) {
  MUROSIMF_ASSERT(least >= 0);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix_of(inertia));
  const Eigen::Vector3d moments = solver.eigenvalues().cwiseMax(least);
  const Eigen::Matrix3d m = solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

}  // namespace murosimf::robot_formats
