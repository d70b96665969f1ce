#include "murosimf/dynamics/free_state.h"

#include <cmath>

#include "murosimf/dynamics/sanity.h"
#include "murosimf/math/assert.h"

namespace murosimf::dynamics {

void write_state(const multibody::FreeBody<double>& body, const PoseColumns& columns, std::vector<double>& y) {
  y.clear();
  for (const Vec3d& v : {body.position, body.velocity, body.rate}) y.insert(y.end(), {v.x, v.y, v.z});
  const Quaterniond& Q = body.turn;
  y.insert(y.end(), {Q.w, Q.x, Q.y, Q.z});
  for (const int i : columns.model.joints()) y.insert(y.end(), {columns.q[i], columns.qd[i]});
  MUROSIMF_ASSERT(y.size() == base_numbers + 2 * columns.model.joints().size());
}

bool is_sane_state(const std::vector<double>& y) {
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!(std::abs(y[i]) < (i < 3 ? farthest : fastest_turn))) return false;  // NaN is not less
  }
  return true;
}

multibody::FreeBody<double> read_state(const std::vector<double>& y, PoseColumns& columns) {
  MUROSIMF_ASSERT(y.size() == base_numbers + 2 * columns.model.joints().size());
  std::size_t k = base_numbers;
  for (const int i : columns.model.joints()) {
    columns.q[i] = y[k++];
    columns.qd[i] = y[k++];
  }
  return {{y[0], y[1], y[2]},
          {y[3], y[4], y[5]},
          normalized(Quaterniond{y[9], y[10], y[11], y[12]}),
          {y[6], y[7], y[8]}};
}

}  // namespace murosimf::dynamics
