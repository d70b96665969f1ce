#include "murosimf/dds/ros2/command_messages.h"

#include <algorithm>
#include <cmath>

namespace murosimf::dds::ros2 {
namespace {

constexpr std::uint32_t most_joints = 1000, most_points = 10'000, most_dimensions = 100;

double duration(CdrReader& in) {
  const auto whole = in.number<std::int32_t>();
  return whole + 1e-9 * in.number<std::uint32_t>();
}

void skip_header(CdrReader& in) {
  (void)duration(in);
  (void)in.text();
}

std::vector<std::string> texts(CdrReader& in) {
  std::vector<std::string> all;
  const std::uint32_t count = in.count(most_joints);
  for (std::uint32_t i = 0; i < count && in.good(); ++i) all.push_back(in.text());
  return all;
}

std::vector<double> numbers(CdrReader& in) {
  std::vector<double> all;
  const std::uint32_t count = in.count(most_joints);
  for (std::uint32_t i = 0; i < count && in.good(); ++i) all.push_back(in.number<double>());
  return all;
}

Vec3d vector(CdrReader& in) {
  const auto x = in.number<double>(), y = in.number<double>(), z = in.number<double>();
  return {x, y, z};
}

TrajectoryMessage trajectory(CdrReader& in) {
  TrajectoryMessage message;
  skip_header(in);
  message.joints = texts(in);
  const std::uint32_t count = in.count(most_points);
  for (std::uint32_t i = 0; i < count && in.good(); ++i) {
    TrajectoryPoint& point = message.points.emplace_back();
    point.positions = numbers(in);
    point.velocities = numbers(in);
    (void)numbers(in);  // accelerations
    (void)numbers(in);  // effort
    point.time = duration(in);
  }
  return message;
}

Vec3d twist(CdrReader& in) {
  const Vec3d linear = vector(in), angular = vector(in);
  return {linear.x, linear.y, angular.z};
}

bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool is_finite(const std::vector<double>& all) {
  return std::ranges::all_of(all, [](double x) { return std::isfinite(x); });
}

/// All points have as many numbers as there are joints, and times that grow.
bool fits(const TrajectoryMessage& message) {
  double last = -1;
  for (const TrajectoryPoint& point : message.points) {
    const std::size_t size = message.joints.size();
    if (point.positions.size() != size || (!point.velocities.empty() && point.velocities.size() != size)) return false;
    if (!is_finite(point.positions) || !is_finite(point.velocities) || !(point.time > last)) return false;
    last = point.time;
  }
  return true;
}

GoalId goal_id(CdrReader& in) {
  GoalId id{};
  for (std::uint8_t& byte : id) byte = in.number<std::uint8_t>();
  return id;
}

template <class Value>
std::optional<Value> if_good(const CdrReader& in, Value value) {
  return in.good() ? std::optional(std::move(value)) : std::nullopt;
}

}  // namespace

std::optional<TrajectoryMessage> read_trajectory(Encoded message) {
  CdrReader in(message);
  TrajectoryMessage read = trajectory(in);
  if (!fits(read)) return std::nullopt;
  return if_good(in, std::move(read));
}

std::optional<JointStateMessage> read_joint_state(Encoded message) {
  CdrReader in(message);
  skip_header(in);
  JointStateMessage read;
  read.joints = texts(in);
  read.positions = numbers(in);
  read.velocities = numbers(in);
  const auto fits = [&](const std::vector<double>& all) {
    return (all.empty() || all.size() == read.joints.size()) && is_finite(all);
  };
  if (!fits(read.positions) || !fits(read.velocities)) return std::nullopt;
  return if_good(in, std::move(read));
}

std::optional<std::vector<double>> read_numbers(Encoded message) {
  CdrReader in(message);
  const std::uint32_t dimensions = in.count(most_dimensions);
  for (std::uint32_t i = 0; i < dimensions && in.good(); ++i) {
    (void)in.text();
    (void)in.number<std::uint32_t>();
    (void)in.number<std::uint32_t>();
  }
  (void)in.number<std::uint32_t>();
  std::vector<double> read = numbers(in);
  if (!is_finite(read)) return std::nullopt;
  return if_good(in, std::move(read));
}

std::optional<Vec3d> read_twist(Encoded message) {
  CdrReader in(message);
  const Vec3d read = twist(in);
  return is_finite(read) ? if_good(in, read) : std::nullopt;
}

std::optional<Vec3d> read_stamped_twist(Encoded message) {
  CdrReader in(message);
  skip_header(in);
  const Vec3d read = twist(in);
  return is_finite(read) ? if_good(in, read) : std::nullopt;
}

std::optional<GoalMessage> read_goal(Encoded message) {
  CdrReader in(message);
  GoalMessage read;
  read.id = goal_id(in);
  read.trajectory = trajectory(in);
  if (!fits(read.trajectory)) return std::nullopt;
  return if_good(in, std::move(read));
}

std::optional<GoalId> read_goal_id(Encoded message) {
  CdrReader in(message);
  return if_good(in, goal_id(in));
}

}  // namespace murosimf::dds::ros2
