/// loop_rows.h - the constraints that hold a loop closed, one direction at a time: the gap of the loop's frames, its rate, and
/// the pair of forces on the two links that holds them together.
///
/// With x the middle between the frames' origins, d = x - O, and a world axis e:
///
///     shift e:   gap = e . (x_2 - x_1)              force on the second link F = [d x e; e], on the first -F
///     turn e:    gap = e . log(R_2 R_1^T)           F = [e; 0]
///     rate = F . (v_2 - v_1)                        bias = derivative of the rate while no joint and no base accelerates
///
/// (notation of link_motion.h). Both forces act at one point, so their moments cancel, however large the gap.
/// Source: Featherstone 2008, sec. 8.2 to 8.4 (loop constraints).
#pragma once

#include <span>
#include <vector>

#include "murosimf/math/transform.h"
#include "murosimf/multibody/link_motion.h"
#include "murosimf/multibody/loops.h"

namespace murosimf::multibody {

struct LoopRow {
  int object = 0;         ///< object that closes the loop
  int axis = 0;           ///< 0 to 2: shift along x, y, z; 3 to 5: turn about them
  int links[2] = {0, 0};  ///< first, second
  Wrenchd force;          ///< F about O
  double gap = 0;         ///< [m | rad]
  double rate = 0;        ///< [m/s | rad/s]
  double bias = 0;        ///< [m/s^2 | rad/s^2]

  [[nodiscard]] bool is_turn() const { return axis >= 3; }
};

class LoopRows {
 public:
  explicit LoopRows(const Model& model);

  /// For the poses r [m], R and motions of this instant.
  void find(std::span<const Vec3d> r, std::span<const Mat3d> R, std::span<const LinkMotion<double>> links) noexcept;
  [[nodiscard]] std::span<const LoopRow> rows() const { return rows_; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }

 private:
  std::vector<Loop> loops_;
  std::vector<int> object_of_;  // by link
  std::vector<LoopRow> rows_;
};

}  // namespace murosimf::multibody
