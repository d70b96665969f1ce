#include "murosimf/ros2/simulation_messages.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::ros2 {
namespace {

constexpr std::uint32_t most_texts = 1000, most_points = 1000;

void skip_time(dds::CdrReader& in) {
  (void)in.number<std::int32_t>();
  (void)in.number<std::uint32_t>();
}

Vec3d read_vector(dds::CdrReader& in) {
  const auto x = in.number<double>(), y = in.number<double>(), z = in.number<double>();
  return {x, y, z};
}

void read_pose_into(dds::CdrReader& in, EntityState& state) {
  skip_time(in);
  state.frame = in.text();
  state.position = read_vector(in);
  const Vec3d v = read_vector(in);
  state.orientation = {in.number<double>(), v.x, v.y, v.z};
}

}  // namespace

void put(dds::ros2::RosWriter& out, const Result& result) {
  out.u8(static_cast<std::uint8_t>(result.code));
  out.text(result.message);
}

std::vector<std::string> read_texts(dds::CdrReader& in) {
  std::vector<std::string> all;
  const std::uint32_t count = in.count(most_texts);
  for (std::uint32_t i = 0; i < count && in.good(); ++i) all.push_back(in.text());
  return all;
}

void read_tags_into(dds::CdrReader& in, EntityFilters& filters) {
  filters.tags = read_texts(in);
  filters.all_tags = in.number<std::uint8_t>() == 1;
}

bool has_tags(const EntityFilters& filters, const std::vector<std::string>& tags) {
  const auto has = [&](const std::string& tag) { return std::ranges::find(tags, tag) != tags.end(); };
  if (filters.tags.empty()) return true;
  return filters.all_tags ? std::ranges::all_of(filters.tags, has) : std::ranges::any_of(filters.tags, has);
}

EntityInfo read_info(dds::CdrReader& in) {
  EntityInfo info;
  info.category = static_cast<Category>(in.number<std::uint8_t>());
  info.description = in.text();
  info.tags = read_texts(in);
  return info;
}

void put(dds::ros2::RosWriter& out, const EntityInfo& info) {
  out.u8(static_cast<std::uint8_t>(info.category));
  out.text(info.description);
  out.texts(info.tags);
}

void put(dds::ros2::RosWriter& out, const Bounds& bounds) {
  MUROSIMF_ASSERT(bounds.points.empty() || bounds.points.size() == 2);
  out.u8(static_cast<std::uint8_t>(bounds.points.empty() ? BoundsType::empty : BoundsType::box));
  out.u32(static_cast<std::uint32_t>(bounds.points.size()));
  for (const Vec3d& point : bounds.points) out.vector(point);
}

EntityFilters read_filters(dds::CdrReader& in) {
  EntityFilters filters;
  filters.names = in.text();
  const std::uint32_t categories = in.count(most_texts);
  for (std::uint32_t i = 0; i < categories; ++i)
    filters.categories.push_back(static_cast<Category>(in.number<std::uint8_t>()));
  read_tags_into(in, filters);
  filters.bounds.type = static_cast<BoundsType>(in.number<std::uint8_t>());
  const std::uint32_t points = in.count(most_points);
  for (std::uint32_t i = 0; i < points && in.good(); ++i) filters.bounds.points.push_back(read_vector(in));
  return filters;
}

void put(dds::ros2::RosWriter& out, const EntityState& state) {
  out.header(state.time, state.frame);
  out.vector(state.position);
  out.quaternion(state.orientation);
  out.vector(state.linear);
  out.vector(state.angular);
  for (int i = 0; i < 6; ++i) out.f64(0);  // accelerations are not told
}

EntityState read_state(dds::CdrReader& in) {
  EntityState state;
  read_pose_into(in, state);
  state.linear = read_vector(in);
  state.angular = read_vector(in);
  for (int i = 0; i < 2; ++i) (void)read_vector(in);
  return state;
}

EntityStateRequest read_state_request(dds::CdrReader& in) {
  EntityStateRequest request{in.text(), read_state(in)};
  constexpr std::size_t flags = 3;  // of pose, twist, acceleration
  if (in.left() < flags) return request;
  request.sets_pose = in.number<std::uint8_t>() != 0;
  request.sets_twist = in.number<std::uint8_t>() != 0;
  return request;
}

EntityState read_pose(dds::CdrReader& in) {
  EntityState state;
  read_pose_into(in, state);
  return state;
}

void put(dds::ros2::RosWriter& out, const NamedPose& pose) {
  out.text(pose.name);
  out.text(pose.description);
  out.texts(pose.tags);
  out.vector(pose.state.position);
  out.quaternion(pose.state.orientation);
}

void put_world(dds::ros2::RosWriter& out, const std::string& name, const std::string& description) {
  out.text(name);
  out.text(name);  // uri
  out.text("");    // resource_string
  out.text(description);
  out.u32(0);  // no tags
}

}  // namespace murosimf::ros2
