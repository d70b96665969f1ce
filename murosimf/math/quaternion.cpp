#include "murosimf/math/quaternion.h"

#include <algorithm>

namespace murosimf {

Quaterniond from_matrix(const Mat3d& m) {
  // the largest component comes from a sum without cancellation, the others are quotients by it
  const double trace = m.x.x + m.y.y + m.z.z;
  Quaterniond q;
  if (trace >= std::max({m.x.x, m.y.y, m.z.z})) {
    q = {1 + trace, m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x};
  } else if (m.x.x >= std::max(m.y.y, m.z.z)) {
    q = {m.y.z - m.z.y, 1 + m.x.x - m.y.y - m.z.z, m.y.x + m.x.y, m.z.x + m.x.z};
  } else if (m.y.y >= m.z.z) {
    q = {m.z.x - m.x.z, m.y.x + m.x.y, 1 + m.y.y - m.x.x - m.z.z, m.z.y + m.y.z};
  } else {
    q = {m.x.y - m.y.x, m.z.x + m.x.z, m.z.y + m.y.z, 1 + m.z.z - m.x.x - m.y.y};
  }
  q = normalized(q);
  return q.w < 0 ? Quaterniond{-q.w, -q.x, -q.y, -q.z} : q;
}

Vec3d rotation_vector(const Quaterniond& q) {
  const Vec3d v = q.w < 0 ? Vec3d{-q.x, -q.y, -q.z} : Vec3d{q.x, q.y, q.z};
  const double s = norm(v);
  // atan2 keeps its precision near pi, where acos of w would lose half of the digits
  const double scale = s < 1e-12 ? 2.0 : 2.0 * std::atan2(s, std::fabs(q.w)) / s;
  return scale * v;
}

}  // namespace murosimf
