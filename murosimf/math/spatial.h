/// spatial.h - six-dimensional vectors and matrices of rigid-body mechanics.
///
/// Angular part first, as in Featherstone, Rigid Body Dynamics Algorithms (2008): a motion is [w; v], a force [n; f].
/// Every use says in which axes they are written and at which point v and n are taken.
#pragma once

#include <array>

#include "murosimf/math/mat3.h"

namespace murosimf {

template <class S>
struct Twist {
  Vec3<S> w, v;  ///< angular [rad/s], linear [m/s] (or their rates)
};

template <class S>
struct Wrench {
  Vec3<S> n, f;  ///< moment [N m], force [N]
};

using Twistd = Twist<double>;
using Wrenchd = Wrench<double>;

template <class S>
MUROSIMF_INLINE Wrench<S> operator+(const Wrench<S>& a, const Wrench<S>& b) {
  return {a.n + b.n, a.f + b.f};
}
template <class S>
MUROSIMF_INLINE Wrench<S> operator-(const Wrench<S>& a, const Wrench<S>& b) {
  return {a.n - b.n, a.f - b.f};
}
template <class S>
MUROSIMF_INLINE Wrench<S>& operator+=(Wrench<S>& a, const Wrench<S>& b) {
  a.n += b.n;
  a.f += b.f;
  return a;
}

template <class S>
MUROSIMF_INLINE Wrench<S>& operator-=(Wrench<S>& a, const Wrench<S>& b) {
  a.n -= b.n;
  a.f -= b.f;
  return a;
}
template <class A, class S>
MUROSIMF_INLINE Wrench<S> operator*(const A& s, const Wrench<S>& a) {
  return {s * a.n, s * a.f};
}

template <class S>
MUROSIMF_INLINE Twist<S> operator+(const Twist<S>& a, const Twist<S>& b) {
  return {a.w + b.w, a.v + b.v};
}
template <class S>
MUROSIMF_INLINE Twist<S>& operator+=(Twist<S>& a, const Twist<S>& b) {
  a.w += b.w;
  a.v += b.v;
  return a;
}
template <class A, class S>
MUROSIMF_INLINE Twist<S> operator*(const A& s, const Twist<S>& a) {
  return {s * a.w, s * a.v};
}

/// Power [W] of a force on a motion, both at the same point.
template <class S>
MUROSIMF_INLINE S dot(const Twist<S>& m, const Wrench<S>& f) {
  return dot(m.w, f.n) + dot(m.v, f.f);
}

/// The same force, its moment taken about a point that lies `offset` away from the old one.
template <class S>
MUROSIMF_INLINE Wrench<S> moved(const Wrench<S>& force, const Vec3<S>& offset) {
  return {force.n - cross(offset, force.f), force.f};
}

/// Symmetric 6x6 matrix that maps a motion to a force: [n; f] = [J H; H^T M] [w; v].
template <class S>
struct Sym6 {
  SymMat3<S> J;                                ///< angular to moment
  Mat3<S> H{Vec3<S>{}, Vec3<S>{}, Vec3<S>{}};  ///< linear to moment
  SymMat3<S> M;                                ///< linear to force
};

using Sym6d = Sym6<double>;

template <class S>
MUROSIMF_INLINE Wrench<S> operator*(const Sym6<S>& a, const Twist<S>& m) {
  return {a.J * m.w + a.H * m.v, transposed_times(a.H, m.w) + a.M * m.v};
}
template <class S>
MUROSIMF_INLINE Sym6<S>& operator+=(Sym6<S>& a, const Sym6<S>& b) {
  a.J += b.J;
  a.H.x += b.H.x;
  a.H.y += b.H.y;
  a.H.z += b.H.z;
  a.M += b.M;
  return a;
}
template <class S>
MUROSIMF_INLINE Sym6<S> operator*(double s, const Sym6<S>& a) {
  return {s * a.J, {s * a.H.x, s * a.H.y, s * a.H.z}, s * a.M};
}

/// Matrix that a map `D` from point velocity to point force [N s/m] makes of itself when the point lies at `x`
/// from the reference point: J^T D J with J = [-x^, 1].
template <class S>
MUROSIMF_INLINE Sym6<S> at_point(const SymMat3<S>& D, const Vec3<S>& x);

/// The same map for a reference point that lies `offset` away from the old one.
template <class S>
Sym6<S> moved(const Sym6<S>& a, const Vec3<S>& offset);

/// A = L L^T of a symmetric positive definite A.
template <class S>
class Cholesky6 {
 public:
  explicit Cholesky6(const Sym6<S>& A);

  /// L^-1 force; of several forces, if T has one in each lane.
  template <class T>
  [[nodiscard]] std::array<T, 6> forward(const Wrench<T>& force) const;
  /// L^-T y.
  [[nodiscard]] Twist<S> backward(std::array<S, 6> y) const;

 private:
  S L_[6][6];
  S inverse_[6];  // of the diagonal
};

/// A symmetric positive definite A by blocks: X = H M^-1 and the Schur complement C = J - X H^T.
template <class S>
struct Blocks {
  explicit Blocks(const Sym6<S>& A)
      : inverse_M(inverse(A.M)),
        H_T(transpose(A.H)),
        X_T{inverse_M * H_T.x, inverse_M * H_T.y, inverse_M * H_T.z},
        C(A.J - SymMat3<S>{dot(X_T.x, H_T.x), dot(X_T.y, H_T.y), dot(X_T.z, H_T.z), dot(X_T.x, H_T.y),
                           dot(X_T.x, H_T.z), dot(X_T.y, H_T.z)}) {}

  SymMat3<S> inverse_M;
  Mat3<S> H_T, X_T;  // transposed
  SymMat3<S> C;      // X H^T is symmetric
};

/// Solves A m = force for a symmetric positive definite A: w = C^-1 (n - X f), v = M^-1 (f - H^T w).
/// Two divisions, where Cholesky waits for six square roots.
template <class S>
Twist<S> solve(const Sym6<S>& A, const Wrench<S>& force) {
  const Blocks<S> b(A);
  const Vec3<S> w = inverse(b.C) * (force.n - transposed_times(b.X_T, force.f));
  return {w, b.inverse_M * (force.f - b.H_T * w)};
}

/// Positive definite, and not only by rounding: no direction has less than 1e-12 of the mean inertia.
inline bool is_firmly_positive(const Sym6d& A) {
  const auto firm = [](const SymMat3d& m) {
    const double mean = (m.xx + m.yy + m.zz) / 3;
    return is_positive_definite(m) && is_positive_definite(m - diagonal(1e-12 * mean));
  };
  return firm(A.M) && firm(Blocks<double>(A).C);
}

/// True if all components are exactly zero.
inline bool is_zero(const Wrenchd& force) {
  return are_zero(force.n.x, force.n.y, force.n.z, force.f.x, force.f.y, force.f.z);
}
/// True for a positive semidefinite matrix that is exactly zero: it has no diagonal.
inline bool is_zero(const Sym6d& m) { return are_zero(m.J.xx, m.J.yy, m.J.zz, m.M.xx, m.M.yy, m.M.zz); }

// ---- definitions ----

/// x^ as a matrix: x^ y = x cross y.
template <class S>
MUROSIMF_INLINE Mat3<S> cross_matrix(const Vec3<S>& x) {
  return {{S{}, x.z, -x.y}, {-x.z, S{}, x.x}, {x.y, -x.x, S{}}};
}

template <class S>
MUROSIMF_INLINE Mat3<S> full(const SymMat3<S>& m) {
  return {{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}};
}

/// x^ M for a matrix M.
template <class S>
MUROSIMF_INLINE Mat3<S> cross_columns(const Vec3<S>& x, const Mat3<S>& M) {
  return {cross(x, M.x), cross(x, M.y), cross(x, M.z)};
}

template <class S>
MUROSIMF_INLINE Sym6<S> at_point(const SymMat3<S>& D, const Vec3<S>& x) {
  const Mat3<S> H = cross_columns(x, full(D));
  // J = -x^ D x^ = -H x^; row by row, since (H x^)^T = -x^ H^T
  const Vec3<S> a = cross(x, Vec3<S>{H.x.x, H.y.x, H.z.x});
  const Vec3<S> b = cross(x, Vec3<S>{H.x.y, H.y.y, H.z.y});
  const Vec3<S> c = cross(x, Vec3<S>{H.x.z, H.y.z, H.z.z});
  return {{a.x, b.y, c.z, a.y, a.z, b.z}, H, D};
}

template <class S>
Sym6<S> moved(const Sym6<S>& a, const Vec3<S>& offset) {
  // twist at the old point: v_old = v_new - w x offset = v_new + offset x w, so with y = -offset
  // J' = J + y^ H^T + (y^ H^T)^T + y^ M y^T, H' = H + y^ M
  const Mat3<S> YH = cross_columns(-offset, transpose(a.H));
  const Sym6<S> point = at_point(a.M, -offset);
  const SymMat3<S> mixed{YH.x.x + YH.x.x, YH.y.y + YH.y.y, YH.z.z + YH.z.z,
                         YH.y.x + YH.x.y, YH.z.x + YH.x.z, YH.z.y + YH.y.z};
  return {a.J + mixed + point.J, {a.H.x + point.H.x, a.H.y + point.H.y, a.H.z + point.H.z}, a.M};
}

template <class S>
Cholesky6<S>::Cholesky6(const Sym6<S>& A)
    : L_{{A.J.xx, S{}, S{}, S{}, S{}, S{}},
         {A.J.xy, A.J.yy, S{}, S{}, S{}, S{}},
         {A.J.xz, A.J.yz, A.J.zz, S{}, S{}, S{}},
         {A.H.x.x, A.H.x.y, A.H.x.z, A.M.xx, S{}, S{}},
         {A.H.y.x, A.H.y.y, A.H.y.z, A.M.xy, A.M.yy, S{}},
         {A.H.z.x, A.H.z.y, A.H.z.z, A.M.xz, A.M.yz, A.M.zz}} {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) {
      S sum = L_[i][j];
      for (int k = 0; k < j; ++k) sum = sum - L_[i][k] * L_[j][k];
      if (i == j) {
        inverse_[i] = 1.0 / sqrt(sum);
      } else {
        L_[i][j] = sum * inverse_[j];
      }
    }
  }
}

template <class S>
template <class T>
std::array<T, 6> Cholesky6<S>::forward(const Wrench<T>& force) const {
  std::array<T, 6> y{force.n.x, force.n.y, force.n.z, force.f.x, force.f.y, force.f.z};
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < i; ++k) y[i] = y[i] - L_[i][k] * y[k];
    y[i] = y[i] * inverse_[i];
  }
  return y;
}

template <class S>
Twist<S> Cholesky6<S>::backward(std::array<S, 6> y) const {
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) y[i] = y[i] - L_[k][i] * y[k];
    y[i] = y[i] * inverse_[i];
  }
  return {{y[0], y[1], y[2]}, {y[3], y[4], y[5]}};
}

}  // namespace murosimf
