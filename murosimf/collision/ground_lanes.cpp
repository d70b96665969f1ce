#include "murosimf/collision/ground_lanes.h"

#include <bit>
#include <variant>

#include "murosimf/geometry/low_points.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

constexpr int fewest_in_lanes = Pack8::registers + 1;  // with fewer robots, one after the other is faster

}  // namespace

GroundLanes::GroundLanes(std::vector<GroundContact*> members) : members_(std::move(members)) {
  MUROSIMF_ASSERT(members_.size() <= Pack8::lanes);
  for (const GroundShape& shape : *members_.front()->finder_.shapes_) {
    objects_.push_back(static_cast<std::size_t>(shape.object));
  }
  origins_.resize(objects_.size());
  padding_.resize(numbers_of<Mat3> * static_cast<std::size_t>(members_.front()->model().size()));
}

void GroundLanes::step(LaneMask due, const Instant& instant) noexcept {
  MUROSIMF_ASSERT(due >> members_.size() == 0);
  LaneMask lanes = 0;
  for_lanes(due, [&](int lane) {
    if (member(lane).dynamic_ != 0) lanes |= lane_bit(lane);
  });
  if (std::popcount(lanes) < fewest_in_lanes) lanes = 0;
  for_lanes(due & ~lanes, [&](int lane) { member(lane).step(of_lane(lane, instant)); });
  if (lanes == 0) return;
  for_lanes(lanes, [&](int lane) { static_cast<void>(member(lane).begin_step(instant)); });
  find_on_planes(lanes);
  for_lanes(lanes, [&](int lane) {
    GroundContact& robot = member(lane);
    robot.find_rest(robot.set_.points.size());
    robot.end_step(of_lane(lane, instant));
  });
}

/// Rows of a column, by their objects. column(robot): its first row.
template <class T, class Column>
void GroundLanes::take(std::span<const std::size_t> objects, LaneMask lanes, T* packs, const Column& column) noexcept {
  LaneRows<const double> from;
  from.fill(padding_.data());
  for_lanes(lanes, [&](int lane) {
    from[static_cast<std::size_t>(lane)] = reinterpret_cast<const double*>(column(member(lane)));
  });
  gather(from, objects, [&](std::size_t k) -> T& { return packs[k]; });
}

/// GroundFinder::find_on_planes of all lanes: planes, shapes and features in the same order, so contacts have the same order.
void GroundLanes::find_on_planes(LaneMask lanes) noexcept {
  const GroundFinder& finder = members_.front()->finder_;
  const std::span<const GroundShape> shapes(*finder.shapes_);
  take(objects_, lanes, origins_.data(), [](const GroundContact& robot) { return robot.r_.data(); });
  std::uint64_t feature = 0;
  for (std::size_t k = 0; k < finder.planes_.size(); ++k) {
    const GroundPlane& plane = finder.planes_[k];
    for_lanes(lanes, [&](int lane) { member(lane).set_.tests.volumes += static_cast<std::int64_t>(shapes.size()); });
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      const GroundShape& shape = shapes[s];
      const Pack8 height = dot(plane.normal, origins_[s]) - plane.height;
      // written as "not above": NaN counts as near, as for one robot
      const LaneMask near = lanes & ~lanes_of(height > Pack8(shape.object_reach));
      if (near == 0 || !(finder.all_touch_planes_ || may_touch(shape.placed, plane))) continue;
      const Meeting meeting{shape, plane, feature + shape.first_feature, finder.surface(k, s)};
      const auto* const box = std::get_if<Box>(&shape.placed.shape);
      if (box && std::popcount(near) >= fewest_in_lanes) {
        find_corners(meeting, *box, origins_[s], near);
      } else {
        find_one_by_one(meeting, near);
      }
    }
    feature += features_of_all(shapes);
  }
}

void GroundLanes::find_one_by_one(const Meeting& meeting, LaneMask lanes) noexcept {
  const GroundShape& shape = meeting.shape;
  MUROSIMF_ASSERT(lanes >> members_.size() == 0);
  for_lanes(lanes, [&](int lane) {
    GroundContact& robot = member(lane);
    std::vector<ContactPoint>& found = robot.set_.points;
    const std::size_t first = found.size();
    if (find_ground_contacts(shape, robot.r_[shape.object], robot.R_[shape.object], meeting.plane, found))
      ++robot.set_.tests.objects;
    for (std::size_t i = first; i < found.size(); ++i) {
      found[i].surface = meeting.surface;
      found[i].feature += meeting.first_feature - shape.first_feature;
    }
    robot.set_velocities(first);
  });
}

GroundLanes::Place GroundLanes::place_of(std::size_t object, LaneMask lanes) noexcept {
  MUROSIMF_ASSERT(lanes != 0);
  Place place;
  const std::span<const std::size_t> one(&object, 1);
  take(one, lanes, &place.R, [](const GroundContact& robot) { return robot.R_.data(); });
  take(one, lanes, &place.v, [](const GroundContact& robot) { return robot.v_.data(); });
  take(one, lanes, &place.w, [](const GroundContact& robot) { return robot.w_.data(); });
  return place;
}

/// find_ground_contacts of a box, in all lanes.
void GroundLanes::find_corners(const Meeting& meeting, const Box& box, const Vec3<Pack8>& origin,
                               LaneMask lanes) noexcept {
  const GroundShape& shape = meeting.shape;
  const GroundPlane& plane = meeting.plane;
  const Place place = place_of(static_cast<std::size_t>(shape.object), lanes);
  const Vec3<Pack8> center = origin + place.R * shape.placed.position;
  lanes &= ~lanes_of(dot(plane.normal, center) - plane.height > Pack8(shape.reach));
  for_lanes(lanes, [&](int lane) { ++member(lane).set_.tests.objects; });
  geometry::for_corners(box, center, place.R * shape.placed.orientation,
                        [&](std::uint32_t corner, const Vec3<Pack8>& point) {
                          const Pack8 depth = plane.height - dot(plane.normal, point);
                          const LaneMask touching = lanes & ~lanes_of((depth < Pack8(0.0)) | (depth == Pack8(0.0)));
                          if (touching == 0) return;
                          const Vec3<Pack8> velocity = place.v + cross(place.w, point - origin);
                          for_lanes(touching, [&](int lane) {
                            ContactPoint& c = member(lane).set_.points.emplace_back();
                            c.object = shape.object;
                            c.feature = meeting.first_feature + corner;
                            c.surface = meeting.surface;
                            c.point = lane_of(point, lane);
                            c.normal = plane.normal;
                            c.depth = depth.lane(lane);
                            c.velocity = lane_of(velocity, lane);
                            c.angular_velocity = lane_of(place.w, lane);
                          });
                        });
}

}  // namespace murosimf::collision
