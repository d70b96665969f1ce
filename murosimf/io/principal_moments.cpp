#include "murosimf/io/principal_moments.h"

#include <Eigen/Eigenvalues>

namespace murosimf::io {

std::array<double, 3> principal_moments(const SymMat3d& I) {
  Eigen::Matrix3d matrix;
  matrix << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return {moments[0], moments[1], moments[2]};
}

bool breaks_triangle_inequality(const std::array<double, 3>& moments) {
  return moments[0] + moments[1] < moments[2] * (1.0 - 1e-5);  // files carry about six digits
}

}  // namespace murosimf::io
