#include "murosimf/locomotion/mirrored_motion.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/locomotion/keyframe_channel.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::locomotion {
namespace {

constexpr double same_place = 0.005;     // [m]
constexpr double same_direction = 0.99;  // [1] cosine of the angle between axes

struct JointPlace {
  Vec3d position;  ///< [m] base frame
  Vec3d axis;      ///< unit vector, base frame
};

/// Of all objects; objects that are not joints have no axis.
std::vector<JointPlace> places_at_zero(const Model& model) {
  const std::size_t count = model.objects().size();
  const std::vector<double> q(count);
  std::vector<Vec3d> r(count);
  std::vector<Mat3d> R(count);
  multibody::poses<double>(model.tree(), q, r, R);
  std::vector<JointPlace> places(count);
  for (const Link& link : model.tree().links) places[link.object] = {r[link.object], R[link.object] * link.axis};
  return places;
}

/// A rotation axis is a pseudovector: its mirror image has the opposite signs of a slide's.
Vec3d mirror_of_axis(const Object& joint, const Vec3d& axis) {
  MUROSIMF_ASSERT(joint.is_joint());
  return joint.kind == Kind::revolute ? Vec3d{-axis.x, axis.y, -axis.z} : Vec3d{axis.x, -axis.y, axis.z};
}

std::optional<MirroredJoint> find_partner(const Model& model, const std::vector<JointPlace>& places, int joint) {
  MUROSIMF_ASSERT(static_cast<std::size_t>(joint) < places.size());
  const auto& [position, axis] = places[joint];
  const Vec3d there{position.x, -position.y, position.z};
  const Vec3d along = mirror_of_axis(model.objects()[joint], axis);
  std::optional<MirroredJoint> best;
  double least = same_place;
  for (const int other : model.joints()) {
    if (model.objects()[other].kind != model.objects()[joint].kind) continue;
    const double same = dot(along, places[other].axis);
    const double distance = norm(places[other].position - there);
    if (std::abs(same) < same_direction || distance > least) continue;
    // Of several in one place, a joint is its own partner.
    if (best && distance == least && best->joint == joint) continue;
    best = MirroredJoint{other, same > 0 ? 1.0 : -1.0};
    least = distance;
  }
  return best;
}

MirroredJoint partner(const Model& model, const std::vector<JointPlace>& places, int joint) {
  if (const auto found = find_partner(model, places, joint)) return *found;
  throw SetupError(
      fmt::format("model '{}': joint '{}' has no partner on the other side, so its motion has no mirror image",
                  model.name(), model.objects()[joint].name));
}

Channel mirror_of_foot(const FootAxis& foot, double sign) {
  MUROSIMF_ASSERT(foot.side < 2 && foot.axis < foot_axes.size());
  return {channel_name({1 - foot.side, foot.axis}), foot_axes[foot.axis] == "y" ? -sign : sign};
}

}  // namespace

MirroredJoint mirrored_joint(const Model& model, int joint) { return partner(model, places_at_zero(model), joint); }

KeyframeMotion mirrored(const KeyframeMotion& motion, const Model& model) {
  const std::vector<JointPlace> places = places_at_zero(model);
  KeyframeMotion image = motion;
  for (std::vector<Channel>& column : image.columns) {
    for (Channel& channel : column) {
      if (const auto foot = foot_axis(channel.name)) {
        channel = mirror_of_foot(*foot, channel.sign);
      } else {
        const MirroredJoint other = partner(model, places, joint_of_channel(model, channel.name));
        MUROSIMF_ASSERT(std::abs(other.sign) == 1);
        channel = {model.objects()[other.joint].name, other.sign * channel.sign};
      }
    }
  }
  if (image.kick) image.kick = Kick{{image.kick->ball.x, -image.kick->ball.y, 0}, -image.kick->direction};
  return image;
}

KeyframeMotion played_by(const Model& model, const KeyframeMotion& motion) {
  if (!motion.other_side) return motion;
  KeyframeMotion image = mirrored(motion, model);
  image.other_side = false;
  return image;
}

}  // namespace murosimf::locomotion
