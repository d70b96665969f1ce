/// pose_lanes.h - poses and velocities of up to eight copies of one robot, each in its own lane: the counterpart of pose_columns.h.
#pragma once

#include <span>
#include <vector>

#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/lanes.h"

namespace murosimf::dynamics {

/// With fewer robots, stepping one after the other is faster.
inline constexpr int fewest_in_lanes = Pack8::registers + 1;

/// Calls part(member) for each member of a group: pointers to a part of each.
template <class Member, class Part>
[[nodiscard]] auto parts_of(const std::vector<Member*>& members, const Part& part) {
  MUROSIMF_ASSERT(!members.empty());
  std::vector<decltype(part(*members.front()))> parts;
  for (Member* member : members) parts.push_back(part(*member));
  return parts;
}

class PoseLanes {
 public:
  /// One to eight robots of one model; their columns outlive this object.
  explicit PoseLanes(std::vector<PoseColumns*> robots);

  /// Reads joint positions and rates from the columns of these lanes; the other lanes get unspecified numbers.
  void take_joints(LaneMask lanes) noexcept;
  void put_back_joints(LaneMask lanes) noexcept;

  /// Poses from row 0 and the joint positions; velocities from row 0, the poses and the joint rates.
  void update_poses() noexcept;
  void update_velocities() noexcept;
  void put_back_poses(LaneMask lanes) noexcept;
  void put_back_velocities(LaneMask lanes) noexcept;

  /// Rows of a column, by their objects: packs(k) is for objects[k]. column(lane): its first row.
  template <class Packs, class Column>
  MUROSIMF_INLINE void take(std::span<const std::size_t> objects, LaneMask lanes, const Packs& packs,
                            const Column& column) noexcept {
    LaneRows<const double> from;
    from.fill(padding_.data());  // lanes that take no part read and write here: no branches in the kernels
    for_lanes(lanes,
              [&](int lane) { from[static_cast<std::size_t>(lane)] = reinterpret_cast<const double*>(column(lane)); });
    gather(from, objects, packs);
  }
  template <class Packs, class Column>
  MUROSIMF_INLINE void put_back(std::span<const std::size_t> objects, LaneMask lanes, const Packs& packs,
                                const Column& column) noexcept {
    LaneRows<double> to;
    to.fill(padding_.data());
    for_lanes(lanes, [&](int lane) { to[static_cast<std::size_t>(lane)] = reinterpret_cast<double*>(column(lane)); });
    scatter(packs, objects, to);
  }

  [[nodiscard]] std::span<const std::size_t> moving() const { return moving_; }  ///< objects with a pose
  [[nodiscard]] std::span<const std::size_t> links() const { return links_; }    ///< by link: their objects
  [[nodiscard]] std::span<const std::size_t> joints() const { return links().subspan(1); }
  [[nodiscard]] PoseColumns& columns(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < robots_.size());
    return *robots_[static_cast<std::size_t>(lane)];
  }
  [[nodiscard]] std::size_t objects() const { return q.size(); }

  const Tree& structure;
  std::vector<Pack8> q, qd;          ///< [rad | m], [rad/s | m/s] by object
  std::vector<Vec3<Pack8>> r, v, w;  ///< [m], [m/s], [rad/s] by object, world
  std::vector<Mat3<Pack8>> R;        ///< by object

 private:
  /// Rows of packs by object.
  template <class T>
  [[nodiscard]] static auto of_objects(std::span<const std::size_t> objects, std::vector<T>& rows) {
    return [objects, &rows](std::size_t k) -> T& { return rows[objects[k]]; };
  }

  std::vector<PoseColumns*> robots_;
  std::vector<std::size_t> moving_, links_;
  std::vector<double> padding_;  // takes the place of the columns of lanes that take no part
};

}  // namespace murosimf::dynamics
