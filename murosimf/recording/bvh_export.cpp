#include "murosimf/recording/bvh_export.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/transform.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/topics.h"

namespace murosimf::recording {
namespace {

constexpr double centimetres = 100, degrees = 180 / std::numbers::pi;
constexpr double digits = 1e-6;               // of written numbers; rounding removes -0
constexpr double slides = 0.001;              // [m] from the mean: far more than the resolution of recordings
constexpr double stub = 0.05;                 // [m] of an end without a direction
constexpr std::size_t most_frames = 1000000;  // nearly three hours at 100 Hz
constexpr std::size_t most_joints = 1000;

/// Converts to the axes of BVH: y, z and x.
Vec3d in_bvh(const Vec3d& v) { return {v.y, v.z, v.x}; }
Mat3d in_bvh(const Mat3d& R) { return {in_bvh(R.y), in_bvh(R.z), in_bvh(R.x)}; }

struct Joint {
  std::string name;
  std::size_t parent = 0;
  std::vector<std::size_t> children;
  Vec3d low, high, sum;  // [m] places in the parent's frame
  Vec3d angles;          // [rad] of the last frame
};

struct MotionFrame {
  Duration time{};
  Vec3d place;  // [m] of the root
  std::vector<Vec3d> angles;
};

/// One foxglove.FrameTransform.
struct ReadLink {
  std::string_view parent, child;
  Transformd pose;
};

/// A transform of two named frames.
ReadLink read_link(ProtobufReader in) {
  ReadLink link;
  while (in.next()) {
    if (in.field() == 2) link.parent = in.bytes();
    if (in.field() == 3) link.child = in.bytes();
    if (in.field() == 4) link.pose.position = read_vector(in.message());
    if (in.field() == 5) link.pose.orientation = read_rotation(in.message());
  }
  return link;
}

std::string owner_of(std::string_view frame) { return std::string(frame.substr(0, frame.find('/'))); }

/// Robots are entities with joints; all others have only a root.
std::string robot_of(const std::map<std::string, std::size_t>& links, const std::string& wanted) {
  std::vector<std::string_view> names, robots;
  for (const auto& [name, count] : links) {
    names.emplace_back(name);
    if (count > 1) robots.emplace_back(name);
  }
  if (wanted.empty() && robots.size() == 1) return std::string(robots.front());
  if (wanted.empty() && !robots.empty())
    throw SetupError(fmt::format("say of which robot: --robot NAME; there are {}", fmt::join(robots, ", ")));
  if (!links.contains(wanted)) throw SetupError(unknown_name("robot", wanted, names));
  return wanted;
}

/// The frames of all messages: a link may be absent at the start.
std::map<std::string, std::size_t> links_by_owner(const McapReader& file) {
  std::map<std::string, std::set<std::string, std::less<>>> links;
  visit_topics(file, {"/tf"}, [&](const std::string&, const Message& message, std::size_t) {
    for (ProtobufReader in(message.data); in.next();) {
      if (in.field() != 1) continue;
      const ReadLink link = read_link(in.message());
      links[owner_of(link.child)].emplace(link.child);
    }
  });
  if (links.empty()) throw SetupError("it has no poses (--record-what)");
  std::map<std::string, std::size_t> counts;
  for (const auto& [name, all] : links) counts[name] = all.size();
  return counts;
}

/// The rate of the recording, if it has one: BVH has equal steps of time.
Duration period_of(const McapReader& file) {
  for (const MetadataIndex& index : file.contents().metadata) {
    const Metadata all = file.metadata(index);
    const auto rate = all.values.find("record_rate_hz");
    const double value = rate == all.values.end() ? 0 : std::strtod(rate->second.c_str(), nullptr);
    if (value >= 1e-3 && value <= 1e6) return from_seconds(1 / value);
  }
  throw SetupError("it does not say at which rate poses were recorded");
}

class Motion {
 public:
  Motion(const McapReader& file, const std::string& robot) : prefix_(robot + "/") {
    visit_topics(file, {"/tf"}, [&](const std::string&, const Message& message, std::size_t) {
      take(time_of(message), message.data);
    });
    std::ranges::stable_sort(frames_, {}, &MotionFrame::time);
    check_sliding(file, robot);
  }

  [[nodiscard]] std::string write(Duration period) const {
    std::string text = "HIERARCHY\n";
    put_joint(text, 0, 0);
    put_motion(text, period);
    return text;
  }

 private:
  void take(Duration time, std::string_view data) {
    MotionFrame frame{.time = time, .place = {}, .angles = {}};
    bool is_there = false;
    for (ProtobufReader in(data); in.next();) {
      if (in.field() != 1) continue;
      const ReadLink link = read_link(in.message());
      if (!link.child.starts_with(prefix_)) continue;
      const std::size_t index = index_of(link);
      Joint& joint = joints_[index];
      joint.angles = bvh_angles(in_bvh(link.pose.orientation));
      const Vec3d& p = link.pose.position;
      if (index == 0) frame.place = p;
      joint.sum = joint.sum + p;
      joint.low = {std::min(joint.low.x, p.x), std::min(joint.low.y, p.y), std::min(joint.low.z, p.z)};
      joint.high = {std::max(joint.high.x, p.x), std::max(joint.high.y, p.y), std::max(joint.high.z, p.z)};
      is_there = true;
    }
    if (!is_there) return;
    for (const Joint& joint : joints_) frame.angles.push_back(joint.angles);
    frames_.push_back(std::move(frame));
  }

  /// Index of the joint of a link; the first frame has all of them, parents first.
  std::size_t index_of(const ReadLink& link) {
    const auto known = by_frame_.find(link.child);
    if (known != by_frame_.end()) return known->second;
    const auto parent = by_frame_.find(link.parent);
    if (!frames_.empty() || (parent == by_frame_.end()) != joints_.empty())
      throw SetupError(fmt::format("'{}' does not hang on its robot from the start; BVH has one skeleton", link.child));
    const std::size_t index = joints_.size();
    if (index == most_joints) throw SetupError(fmt::format("it has more than {} joints", most_joints));
    Joint joint{.name = std::string(link.child.substr(prefix_.size())),
                .parent = 0,
                .children = {},
                .low = link.pose.position,
                .high = link.pose.position,
                .sum = {},
                .angles = {}};
    std::ranges::replace(joint.name, ' ', '_');
    if (index > 0) {
      joint.parent = parent->second;
      joints_[joint.parent].children.push_back(index);
    }
    joints_.push_back(std::move(joint));
    by_frame_.emplace(link.child, index);
    return index;
  }

  /// BVH has joints that turn only.
  void check_sliding(const McapReader& file, const std::string& robot) const {
    for (const Channel& channel : file.contents().channels) {
      if (channel.topic != "/joints") continue;
      for (const auto& [name, unit] : channel.metadata) {
        if (name.starts_with(prefix_)) refuse_sliding(robot, name.substr(prefix_.size()));
      }
    }
    for (std::size_t i = 1; i < joints_.size(); ++i) {
      if (moved(joints_[i]) > slides) refuse_sliding(robot, joints_[i].name);
    }
  }
  [[noreturn]] static void refuse_sliding(const std::string& robot, const std::string& joint) {
    throw SetupError(fmt::format("joint '{}' of '{}' slides; BVH has only joints that turn", joint, robot));
  }

  /// [m] Largest distance of its place from the mean.
  [[nodiscard]] double moved(const Joint& joint) const {
    const Vec3d mean = offset(joint);
    return std::max(norm(joint.high - mean), norm(joint.low - mean));
  }
  [[nodiscard]] Vec3d offset(const Joint& joint) const {
    if (&joint == joints_.data()) return {};
    MUROSIMF_ASSERT(!frames_.empty());
    return (1.0 / static_cast<double>(frames_.size())) * joint.sum;
  }

  void put_joint(std::string& text, std::size_t index, std::size_t depth) const {
    const Joint& joint = joints_[index];
    const std::string tab(2 * depth, ' '), inner(2 * depth + 2, ' ');
    text += fmt::format("{}{} {}\n{}{{\n", tab, index == 0 ? "ROOT" : "JOINT", joint.name, tab);
    put_offset(text, inner, offset(joint));
    text += fmt::format("{}CHANNELS {}Zrotation Xrotation Yrotation\n", inner,
                        index == 0 ? "6 Xposition Yposition Zposition " : "3 ");
    for (const std::size_t child : joint.children) put_joint(text, child, depth + 1);
    if (joint.children.empty()) {  // extends its parent's bone by half
      const Vec3d way = 0.5 * offset(joint);
      text += fmt::format("{}End Site\n{}{{\n", inner, inner);
      put_offset(text, inner + "  ", norm(way) > 0 ? way : Vec3d{stub, 0, 0});
      text += fmt::format("{}}}\n", inner);
    }
    text += fmt::format("{}}}\n", tab);
  }

  static void put_offset(std::string& text, const std::string& tab, const Vec3d& offset) {
    const Vec3d v = rounded(centimetres * in_bvh(offset), digits);
    text += fmt::format("{}OFFSET {:.6f} {:.6f} {:.6f}\n", tab, v.x, v.y, v.z);
  }

  void put_motion(std::string& text, Duration period) const {
    MUROSIMF_ASSERT(period > Duration{} && !frames_.empty());
    const Duration begin = frames_.front().time;
    if (seconds(frames_.back().time) - seconds(begin) > static_cast<double>(most_frames) * seconds(period))
      throw SetupError(fmt::format("it lasts longer than {} frames, as many as become BVH", most_frames));
    const auto number_of = [&](const MotionFrame& frame) {
      return static_cast<std::size_t>((frame.time - begin + period / 2) / period);
    };
    const std::size_t count = number_of(frames_.back()) + 1;
    text += fmt::format("MOTION\nFrames: {}\nFrame Time: {:.9f}\n", count, seconds(period));
    std::vector<std::size_t> order;
    put_order(order, 0);
    std::string line;
    std::size_t written = 0;
    for (const MotionFrame& frame : frames_) {
      for (const std::size_t number = number_of(frame); written < number; ++written) text += line;
      line = line_of(frame, order);
    }
    text += line;
  }

  /// Joints in the order of the hierarchy, which is that of the channels.
  void put_order(std::vector<std::size_t>& order, std::size_t index) const {
    order.push_back(index);
    for (const std::size_t child : joints_[index].children) put_order(order, child);
  }

  static std::string line_of(const MotionFrame& frame, const std::vector<std::size_t>& order) {
    MUROSIMF_ASSERT(frame.angles.size() == order.size());
    const Vec3d place = rounded(centimetres * in_bvh(frame.place), digits);
    std::string line = fmt::format("{:.5f} {:.5f} {:.5f}", place.x, place.y, place.z);
    for (const std::size_t joint : order) {
      const Vec3d angles = rounded(degrees * frame.angles[joint], digits);
      line += fmt::format(" {:.6f} {:.6f} {:.6f}", angles.x, angles.y, angles.z);
    }
    return line + "\n";
  }

  std::string prefix_;  // of frames
  std::vector<Joint> joints_;
  std::map<std::string, std::size_t, std::less<>> by_frame_;
  std::vector<MotionFrame> frames_;
};

}  // namespace

Vec3d bvh_angles(const Mat3d& R) noexcept {
  constexpr double upright = 1e-9;  // cosine of b
  const double sine = std::clamp(R.y.z, -1.0, 1.0), cosine = std::hypot(R.y.x, R.y.y);
  if (cosine < upright) return {0, std::copysign(std::numbers::pi / 2, sine), std::atan2(R.z.x, R.x.x)};
  return {std::atan2(-R.y.x, R.y.y), std::atan2(sine, cosine), std::atan2(-R.x.z, R.z.z)};
}

std::string bvh_of(const McapReader& recording, const std::string& robot) {
  return with_context(recording.file().string(), [&] {
    const std::string name = robot_of(links_by_owner(recording), robot);
    return Motion(recording, name).write(period_of(recording));
  });
}

}  // namespace murosimf::recording
