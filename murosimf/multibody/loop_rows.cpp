#include "murosimf/multibody/loop_rows.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"

namespace murosimf::multibody {
namespace {

constexpr Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Velocity and bias acceleration of a link's point at d [m] from O.
struct PointMotion {
  Vec3d velocity, bias;
};
PointMotion at_point(const LinkMotion<double>& link, const Vec3d& d) {
  const auto& [w, v] = link.velocity;
  const Vec3d velocity = v + cross(w, d);
  return {velocity, link.bias.v + cross(link.bias.w, d) + cross(w, velocity)};
}

}  // namespace

LoopRows::LoopRows(const Model& model) : loops_(loops_of(model)) {
  for (const Loop& loop : loops_) {
    for (int axis = 0; axis < loop.rows(); ++axis) {
      rows_.push_back(
          {.object = loop.object, .axis = axis, .links = {loop.ends[0].frame.link, loop.ends[1].frame.link}});
    }
  }
  for (const Link& link : model.tree().links) object_of_.push_back(link.object);
}

void LoopRows::find(std::span<const Vec3d> r, std::span<const Mat3d> R,
                    std::span<const LinkMotion<double>> links) noexcept {
  MUROSIMF_ASSERT(r.size() == R.size() && links.size() == object_of_.size());
  auto row = rows_.begin();
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const auto place = [&](const FixedObject& frame) {
      const int object = object_of_[frame.link];
      return Transformd{r[object], R[object]} * Transformd{frame.offset, frame.turn};
    };
    MUROSIMF_ASSERT(row != rows_.end());
    const Transformd first = place(loops_[i].ends[0].frame), second = place(loops_[i].ends[1].frame);
    // the middle between the frames: the two opposite forces then have no moment, however large the gap
    const Vec3d d = 0.5 * (first.position + second.position) - r[0], shift = second.position - first.position;
    const LinkMotion<double>& one = links[row->links[0]];
    const LinkMotion<double>& other = links[row->links[1]];
    const PointMotion a = at_point(one, d), b = at_point(other, d);
    for (int k = 0; k < 3; ++k, ++row) {
      row->force = {cross(d, axes[k]), axes[k]};
      row->gap = dot(axes[k], shift);
      row->rate = dot(axes[k], b.velocity - a.velocity);
      row->bias = dot(axes[k], b.bias - a.bias);
    }
    if (!loops_[i].welded) continue;
    const Vec3d turn = rotation_vector(from_matrix(second.orientation * transpose(first.orientation)));
    for (int k = 0; k < 3; ++k, ++row) {
      row->force = {axes[k], {}};
      row->gap = dot(axes[k], turn);
      row->rate = dot(axes[k], other.velocity.w - one.velocity.w);
      row->bias = dot(axes[k], other.bias.w - one.bias.w);
    }
  }
  MUROSIMF_ASSERT(row == rows_.end());
}

}  // namespace murosimf::multibody
