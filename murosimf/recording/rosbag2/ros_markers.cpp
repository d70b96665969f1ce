#include "murosimf/recording/rosbag2/ros_markers.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "murosimf/dds/ros2/ros_writer.h"
#include "murosimf/math/transform.h"
#include "murosimf/model/shape.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/protobuf.h"

namespace murosimf::recording {
namespace {

using dds::ros2::RosWriter;

// visualization_msgs/Marker
enum MarkerType : std::int32_t {
  arrow = 0,
  cube = 1,
  sphere = 2,
  cylinder = 3,
  line_strip = 4,
  line_list = 5,
  text_view_facing = 9,
  triangle_list = 11
};
enum MarkerAction : std::int32_t { add = 0, remove = 2 };

struct Rgba {
  double r = 0, g = 0, b = 0, a = 0;
};

struct Marker {
  MarkerType type = cube;
  Transformd pose;
  Vec3d scale{1, 1, 1};
  Rgba color;
  std::vector<Vec3d> points{};
  std::vector<Rgba> colors{};  // as many as points, or none
  std::string_view text{};
};

struct SceneEntity {
  Duration time{};
  std::string_view frame, id;
  bool frame_locked = false;
  std::vector<Marker> markers;
};

Rgba read_color(ProtobufReader in) {
  Rgba color;
  while (in.next()) {
    if (in.field() == 1) color.r = in.number();
    if (in.field() == 2) color.g = in.number();
    if (in.field() == 3) color.b = in.number();
    if (in.field() == 4) color.a = in.number();
  }
  return color;
}

Transformd read_pose(ProtobufReader in) {
  Transformd pose;
  while (in.next()) {
    if (in.field() == 1) pose.position = read_vector(in.message());
    if (in.field() == 2) pose.orientation = read_rotation(in.message());
  }
  return pose;
}

std::vector<std::uint32_t> read_indices(std::string_view packed) {
  std::vector<std::uint32_t> numbers(packed.size() / sizeof(std::uint32_t));
  if (!numbers.empty()) std::memcpy(numbers.data(), packed.data(), numbers.size() * sizeof(std::uint32_t));
  return numbers;
}

/// The numbers at these places; all of them if there are no indices.
template <class T>
std::vector<T> in_order(const std::vector<T>& all, const std::vector<std::uint32_t>& indices) {
  if (indices.empty()) return all;
  std::vector<T> chosen;
  for (const std::uint32_t index : indices) {
    if (index < all.size()) chosen.push_back(all[index]);
  }
  return chosen;
}

/// An arrow along x of its pose.
Marker read_arrow(ProtobufReader in) {
  Marker marker{.type = arrow, .pose = {}, .color = {}};
  double length = 0, thickness = 0;
  while (in.next()) {
    if (in.field() == 1) marker.pose = read_pose(in.message());
    if (in.field() == 2 || in.field() == 4) length += in.number();
    if (in.field() == 5) thickness = in.number();
    if (in.field() == 6) marker.color = read_color(in.message());
  }
  marker.scale = {length, thickness, thickness};
  return marker;
}

Marker read_solid(MarkerType type, int color_field, ProtobufReader in) {
  Marker marker{.type = type, .pose = {}, .color = {}};
  while (in.next()) {
    if (in.field() == 1) marker.pose = read_pose(in.message());
    if (in.field() == 2) marker.scale = read_vector(in.message());
    if (in.field() == color_field) marker.color = read_color(in.message());
  }
  return marker;
}

Marker read_line(ProtobufReader in) {
  constexpr std::uint64_t loop = 1, list = 2;  // foxglove.LinePrimitive.Type
  Marker marker{.type = line_strip, .pose = {}, .color = {}};
  std::uint64_t type = 0;
  double thickness = 0;
  std::vector<std::uint32_t> indices;
  while (in.next()) {
    if (in.field() == 1) type = in.varint();
    if (in.field() == 2) marker.pose = read_pose(in.message());
    if (in.field() == 3) thickness = in.number();
    if (in.field() == 5) marker.points.push_back(read_vector(in.message()));
    if (in.field() == 6) marker.color = read_color(in.message());
    if (in.field() == 7) marker.colors.push_back(read_color(in.message()));
    if (in.field() == 8) indices = read_indices(in.bytes());
  }
  marker.points = in_order(marker.points, indices);
  marker.colors = in_order(marker.colors, indices);
  if (type == list) marker.type = line_list;
  if (type == loop && !marker.points.empty()) {
    marker.points.push_back(marker.points.front());
    if (!marker.colors.empty()) marker.colors.push_back(marker.colors.front());
  }
  marker.scale = {thickness, 0, 0};
  return marker;
}

Marker read_triangles(ProtobufReader in) {
  Marker marker{.type = triangle_list, .pose = {}, .color = {}};
  std::vector<std::uint32_t> indices;
  while (in.next()) {
    if (in.field() == 1) marker.pose = read_pose(in.message());
    if (in.field() == 2) marker.points.push_back(read_vector(in.message()));
    if (in.field() == 3) marker.color = read_color(in.message());
    if (in.field() == 4) marker.colors.push_back(read_color(in.message()));
    if (in.field() == 5) indices = read_indices(in.bytes());
  }
  marker.points = in_order(marker.points, indices);
  marker.colors = in_order(marker.colors, indices);
  return marker;
}

Marker read_text(ProtobufReader in) {
  Marker marker{.type = text_view_facing, .pose = {}, .color = {}};
  while (in.next()) {
    if (in.field() == 1) marker.pose = read_pose(in.message());
    if (in.field() == 3) marker.scale = {0, 0, in.number()};
    if (in.field() == 5) marker.color = read_color(in.message());
    if (in.field() == 6) marker.text = in.bytes();
  }
  return marker;
}

/// Primitives of a foxglove.SceneEntity.
std::optional<Marker> read_primitive(const ProtobufReader& in) {
  switch (in.field()) {
    case 7: return read_arrow(in.message());
    case 8: return read_solid(cube, 3, in.message());
    case 9: return read_solid(sphere, 3, in.message());
    case 10: return read_solid(cylinder, 5, in.message());
    case 11: return read_line(in.message());
    case 12: return read_triangles(in.message());
    case 13: return read_text(in.message());
    default: return std::nullopt;
  }
}

SceneEntity read_entity(ProtobufReader in) {
  SceneEntity entity;
  while (in.next()) {
    if (in.field() == 1) entity.time = read_time(in.message());
    if (in.field() == 2) entity.frame = in.bytes();
    if (in.field() == 3) entity.id = in.bytes();
    if (in.field() == 5) entity.frame_locked = in.varint() != 0;
    if (std::optional<Marker> marker = read_primitive(in)) entity.markers.push_back(std::move(*marker));
  }
  return entity;
}

void put_color(RosWriter& out, const Rgba& color) {
  out.f32(color.r);
  out.f32(color.g);
  out.f32(color.b);
  out.f32(color.a);
}

void put_marker(RosWriter& out, const SceneEntity& entity, int id, const Marker& marker, MarkerAction action) {
  out.header(entity.time, entity.frame);
  out.text(entity.id);
  out.i32(id);
  out.i32(marker.type);
  out.i32(action);
  out.vector(marker.pose.position);
  out.quaternion(from_matrix(marker.pose.orientation));
  out.vector(marker.scale);
  put_color(out, marker.color);
  out.i32(0);  // shown until it is replaced
  out.u32(0);
  out.boolean(entity.frame_locked);
  out.u32(static_cast<std::uint32_t>(marker.points.size()));
  for (const Vec3d& point : marker.points) out.vector(point);
  out.u32(static_cast<std::uint32_t>(marker.colors.size()));
  for (const Rgba& color : marker.colors) put_color(out, color);
  out.text("");  // no texture
  out.header({}, "");
  out.text("");
  out.bytes("");
  out.u32(0);  // no coordinates in it
  out.text(marker.text);
  out.text("");  // no mesh in a file
  out.text("");
  out.bytes("");
  out.boolean(false);
}

}  // namespace

std::string ros_markers(std::string_view scene_update, std::map<std::string, int>& shown, const FrameNames& names) {
  RosWriter markers;
  std::uint32_t count = 0;
  const auto replace = [&](const SceneEntity& entity) {
    int& known = shown[std::string(entity.id)];
    const int now = static_cast<int>(entity.markers.size());
    for (int i = 0; i < now; ++i) put_marker(markers, entity, i, entity.markers[static_cast<std::size_t>(i)], add);
    for (int i = now; i < known; ++i) put_marker(markers, entity, i, {}, remove);
    count += static_cast<std::uint32_t>(std::max(now, known));
    known = now;
  };
  markers.u32(0);
  for (ProtobufReader in(scene_update); in.next();) {
    if (in.field() == 2) {
      SceneEntity entity = read_entity(in.message());
      const auto name = names.find(entity.frame);
      if (name != names.end()) entity.frame = name->second;
      replace(entity);
    }
    if (in.field() != 1) continue;
    SceneEntity gone;
    bool everything = false;
    for (ProtobufReader deletion = in.message(); deletion.next();) {
      if (deletion.field() == 1) gone.time = read_time(deletion.message());
      if (deletion.field() == 2) everything = deletion.varint() == 1;
      if (deletion.field() == 3) gone.id = deletion.bytes();
    }
    if (!everything) {
      replace(gone);
      continue;
    }
    const std::map<std::string, int> all = shown;
    for (const auto& [id, number] : all) replace({.time = gone.time, .frame = {}, .id = id, .markers = {}});
  }
  return markers.with_count(count);
}

}  // namespace murosimf::recording
