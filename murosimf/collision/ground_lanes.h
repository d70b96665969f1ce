/// ground_lanes.h - contact of up to eight copies of one robot with the ground: contacts with planes are found in lanes.
///
/// A step of ground_contact.h. Heights of shapes above each plane, and the corners of boxes near it, are computed for all robots at
/// once; other shapes near it, static shapes, memory and forces one robot after the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/collision/ground_contact.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/lane_group.h"

namespace murosimf::collision {

class GroundLanes final : public LaneGroup {
 public:
  /// One to eight, of which each goes with each (GroundContact::goes_with); they outlive this object.
  explicit GroundLanes(std::vector<GroundContact*> members);
  void step(LaneMask due, const Instant& instant) noexcept override;

 private:
  /// Attitude and motion of a body: [m/s] of its origin, [rad/s]; world frame.
  struct Place {
    Vec3<Pack8> v, w;
    Mat3<Pack8> R;
  };
  /// What points of one shape on one plane have in common.
  struct Meeting {
    const GroundShape& shape;
    const GroundPlane& plane;
    std::uint64_t first_feature;
    std::uint32_t surface;
  };
  [[nodiscard]] GroundContact& member(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < members_.size());
    return *members_[static_cast<std::size_t>(lane)];
  }
  void find_on_planes(LaneMask lanes) noexcept;
  void find_one_by_one(const Meeting& meeting, LaneMask lanes) noexcept;
  void find_corners(const Meeting& meeting, const Box& box, const Vec3<Pack8>& origin, LaneMask lanes) noexcept;
  [[nodiscard]] Place place_of(std::size_t object, LaneMask lanes) noexcept;
  template <class T, class Column>
  void take(std::span<const std::size_t> objects, LaneMask lanes, T* packs, const Column& column) noexcept;

  std::vector<GroundContact*> members_;
  std::vector<std::size_t> objects_;  // by shape: its object
  std::vector<Vec3<Pack8>> origins_;  // [m] by shape, of its object
  std::vector<double> padding_;       // takes the place of the columns of lanes that take no part
};

}  // namespace murosimf::collision
