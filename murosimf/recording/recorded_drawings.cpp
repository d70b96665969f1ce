#include "murosimf/recording/recorded_drawings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/drawing/drawn.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/topics.h"
#include "murosimf/render/polygon_triangles.h"

namespace murosimf::recording {
namespace {

using nlohmann::json;

constexpr Duration repeat_period = std::chrono::seconds(5);  // limits the search after a seek
constexpr std::size_t most_kept_chunks = 32;                 // chunks: longer than a repetition
constexpr std::string_view topics = "/drawings/", shape_key = "shape";
constexpr std::string_view drawn_by = "drawn_by", others = "others";  // metadata of channels
constexpr double thin = 2;                                            // [px] of lines without a width
constexpr double speck = 0.01;                                        // [m] of dots without a width
constexpr double small_text = 14;                                     // [px] of texts without a height
constexpr int corners = 48;                                           // of a circle
constexpr std::uint64_t delete_all = 1, line_loop = 1;
// Fields of foxglove.SceneEntity.
constexpr int drawn_spheres = 9, drawn_lines = 11, drawn_triangles = 12, drawn_texts = 13;

void put_ink(ProtobufWriter& out, int field, const DrawnShape& shape) {
  out.message(field, [&](ProtobufWriter& in) {
    in.number(1, shape.color.red);
    in.number(2, shape.color.green);
    in.number(3, shape.color.blue);
    in.number(4, shape.opacity);
  });
}

void put_line(ProtobufWriter& out, const DrawnShape& shape, const std::vector<Vec3d>& points, bool closed,
              double width) {
  out.message(drawn_lines, [&](ProtobufWriter& in) {
    if (closed) in.varint(1, line_loop);
    in.number(3, width > 0 ? width : thin);
    in.varint(4, width > 0 ? 0 : 1);
    for (const Vec3d& point : points) put_vector(in, 5, point);
    put_ink(in, 6, shape);
  });
}

/// A ball of any kind is a sphere of the viewer.
void put_ball(ProtobufWriter& out, const DrawnShape& shape, const Vec3d& center, double width) {
  out.message(drawn_spheres, [&](ProtobufWriter& in) {
    put_pose(in, 1, {center, {}}, pose_step);
    put_vector(in, 2, {width, width, width});
    put_ink(in, 3, shape);
  });
}

/// Viewers draw triangles only.
void put_area(ProtobufWriter& out, const DrawnShape& shape) {
  std::vector<std::uint32_t> corners_of_triangles;
  for (const auto& triangle : render::polygon_triangles(shape.points)) {
    corners_of_triangles.insert(corners_of_triangles.end(), triangle.begin(), triangle.end());
  }
  out.message(drawn_triangles, [&](ProtobufWriter& in) {
    for (const Vec3d& point : shape.points) put_vector(in, 2, point);
    put_ink(in, 3, shape);
    in.packed_fixed32(5, corners_of_triangles);
  });
}

void put_words(ProtobufWriter& out, const DrawnShape& shape) {
  out.message(drawn_texts, [&](ProtobufWriter& in) {
    put_pose(in, 1, {shape.points.front(), {}}, pose_step);
    in.varint(2, 1);
    in.number(3, shape.size > 0 ? shape.size : small_text);
    in.varint(4, shape.size > 0 ? 0 : 1);
    put_ink(in, 5, shape);
    in.text(6, shape.words);
  });
}

std::vector<Vec3d> around(const Vec3d& center, double radius) {
  std::vector<Vec3d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back(center + Vec3d{radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return points;
}

void put_shape(ProtobufWriter& out, const DrawnShape& shape) {
  if (shape.points.empty()) return;
  const Vec3d& first = shape.points.front();
  switch (shape.kind) {
    case DrawnShape::circle: return put_line(out, shape, around(first, shape.size), true, 0);
    case DrawnShape::line: return put_line(out, shape, shape.points, false, shape.size);
    case DrawnShape::dots:
      for (const Vec3d& point : shape.points) put_ball(out, shape, point, shape.size > 0 ? shape.size : speck);
      return;
    case DrawnShape::sphere: return put_ball(out, shape, first, shape.size > 0 ? 2 * shape.size : speck);
    case DrawnShape::polygon: return put_area(out, shape);
    case DrawnShape::text: return put_words(out, shape);
  }
}

/// The exact shape, beside the viewer's primitives, from which it could not be read again.
std::string to_json(const DrawnShape& shape) {
  json points = json::array();
  for (const Vec3d& point : shape.points) points.push_back({point.x, point.y, point.z});
  const json all = {{"kind", drawn_kind_names[shape.kind]},
                    {"points", points},
                    {"size", shape.size},
                    {"color", {shape.color.red, shape.color.green, shape.color.blue}},
                    {"opacity", shape.opacity},
                    {"words", shape.words}};
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

DrawnShape read_shape(std::string_view text) {
  try {
    const json all = json::parse(text);
    const auto kind = std::ranges::find(drawn_kind_names, all.at("kind").get<std::string>());
    if (kind == drawn_kind_names.end()) throw SetupError("a drawing has a shape of no known kind");
    DrawnShape shape;
    shape.kind = static_cast<DrawnShape::Kind>(kind - drawn_kind_names.begin());
    for (const json& point : all.at("points")) {
      shape.points.push_back({point.at(0).get<double>(), point.at(1).get<double>(), point.at(2).get<double>()});
    }
    all.at("size").get_to(shape.size);
    const json& color = all.at("color");
    shape.color = {color.at(0).get<double>(), color.at(1).get<double>(), color.at(2).get<double>()};
    all.at("opacity").get_to(shape.opacity);
    all.at("words").get_to(shape.words);
    return shape;
  } catch (const json::exception&) {
    throw SetupError("a drawing is damaged");
  }
}

/// Name of the author.
std::string name_of(const DrawingTopic& topic) {
  return topic.by_others ? std::string(drawing::others_name) : topic.robot;
}

/// "/drawings/blue1", "/drawings/roboviz", "/drawings/roboviz/blue1"
std::string text_of(const DrawingTopic& topic) {
  const std::string text = std::string(topics) + name_of(topic);
  return topic.by_others && !topic.robot.empty() ? text + "/" + topic.robot : text;
}

DrawingTopic topic_of(const Channel& channel) {
  const auto by = channel.metadata.find(std::string(drawn_by));
  if (by == channel.metadata.end() || by->second != others) return {false, channel.topic.substr(topics.size())};
  const std::string world = text_of({true, {}});
  return {true, channel.topic.size() > world.size() ? channel.topic.substr(world.size() + 1) : ""};
}

void put_group(ProtobufWriter& out, const FrameDrawings& drawn, const DrawnGroup& group) {
  out.message(2, [&](ProtobufWriter& entity) {
    put_time(entity, 1, group.time);
    entity.text(2, group.of_robot && !drawn.base.empty() ? std::string_view(drawn.base) : "world");
    entity.text(3, name_of(drawn.topic) + "/" + group.name);
    entity.varint(5, 1);  // frame_locked: moves with its frame, else viewers need poses of the time when it was drawn
    for (const DrawnShape& shape : group.shapes) {
      entity.message(6, [&](ProtobufWriter& pair) {
        pair.text(1, shape_key);
        pair.text(2, to_json(shape));
      });
    }
    for (const DrawnShape& shape : group.shapes) put_shape(entity, shape);
  });
}

void read_metadata(ProtobufReader in, DrawnGroup& group) {
  bool is_shape = false;
  while (in.next()) {
    if (in.field() == 1) is_shape = in.bytes() == shape_key;
    if (in.field() == 2 && is_shape) group.shapes.push_back(read_shape(in.bytes()));
  }
}

DrawnGroup read_group(ProtobufReader in, const std::string& owner) {
  DrawnGroup group;
  while (in.next()) {
    if (in.field() == 1) group.time = read_time(in.message());
    if (in.field() == 2) group.of_robot = in.bytes() != "world";
    if (in.field() == 3) group.name = in.bytes();
    if (in.field() == 6) read_metadata(in.message(), group);
  }
  if (!group.name.starts_with(owner + "/")) throw SetupError("a drawing is of another robot than its topic says");
  group.name.erase(0, owner.size() + 1);
  return group;
}

}  // namespace

void SketchWatch::take(const std::vector<RecordedEntity>& entities, RecordedFrame& frame) {
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const Column<Drawings>* drawn = entities[i].columns.drawings;
    if (!drawn) continue;
    const bool present = entities[i].entity->present();
    const std::uint64_t now = present ? drawn->values[0].changes + 1 : 0;  // an absent robot shows nothing
    const auto [seen, is_new] = seen_.try_emplace(i, present ? 1 : 0);
    if (seen->second == now && !(is_new && clears_)) continue;
    seen->second = now;
    FrameDrawings& sheet = frame.drawings.emplace_back();
    sheet.topic.robot = entities[i].name;
    if (!entities[i].links.empty()) sheet.base = entities[i].links.front().frame;
    if (present) sheet.groups = drawn->values[0].groups;
  }
}

void DrawingWriter::write(const RecordedFrame& frame) {
  const auto put = [&](Sheet& sheet) {
    file_.write(sheet.channel, frame.time, drawing_message(frame.time, sheet.drawn));
    sheet.written = frame.time;
  };
  for (const FrameDrawings& drawn : frame.drawings) {
    auto [sheet, is_new] = sheets_.try_emplace(drawn.topic);
    if (is_new) {
      TextMap metadata;
      if (drawn.topic.by_others) metadata.emplace(drawn_by, others);
      sheet->second.channel = frames_.add_channel(text_of(drawn.topic), "foxglove.SceneUpdate", metadata);
    }
    sheet->second.drawn = drawn;
    put(sheet->second);
  }
  for (auto& [topic, sheet] : sheets_) {
    if (frame.time - sheet.written >= repeat_period) put(sheet);
  }
}

/// All that was drawn before is deleted first: a message has the whole sheet.
std::string drawing_message(Duration time, const FrameDrawings& drawn) {
  std::string bytes;
  ProtobufWriter out(bytes);
  out.message(1, [&](ProtobufWriter& deletion) {
    put_time(deletion, 1, time);
    deletion.varint(2, delete_all);
  });
  for (const DrawnGroup& group : drawn.groups) put_group(out, drawn, group);
  return bytes;
}

std::vector<DrawnGroup> read_drawing_message(std::string_view bytes, const DrawingTopic& topic) {
  std::vector<DrawnGroup> groups;
  for (ProtobufReader in(bytes); in.next();) {
    if (in.field() == 2) groups.push_back(read_group(in.message(), name_of(topic)));
  }
  return groups;
}

DrawingReader::DrawingReader(const McapReader& file) : file_(file) {
  for (const Channel& channel : file.contents().channels) {
    if (channel.topic.starts_with(topics)) topics_[channel.id] = topic_of(channel);
  }
  const auto& chunks = file.contents().chunks;
  for (std::size_t i = 0; i < chunks.size() && !topics_.empty(); ++i) {
    if (has_any(chunks[i], topics_)) chunks_.push_back(i);
  }
  std::ranges::stable_sort(chunks_, {}, [&](std::size_t i) { return chunks[i].start_time; });
}

std::set<std::string> DrawingReader::robots() const {
  std::set<std::string> names;
  for (const auto& [channel, topic] : topics_) {
    if (!topic.by_others) names.insert(topic.robot);
  }
  return names;
}

const DrawingReader::Chunk& DrawingReader::read(std::size_t index) {
  MUROSIMF_ASSERT(index < chunks_.size());
  const auto known = std::ranges::find(kept_, index, &Chunk::index);
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
    return kept_.front();
  }
  Chunk chunk{.index = index, .sketches = {}};
  file_.visit_messages(file_.contents().chunks[chunks_[index]], [&](const Message& message) {
    const auto topic = topics_.find(message.channel_id);
    if (topic != topics_.end()) chunk.sketches.push_back({time_of(message), topic->second, std::string(message.data)});
  });
  kept_.push_front(std::move(chunk));
  if (kept_.size() > most_kept_chunks) kept_.pop_back();
  return kept_.front();
}

/// The last messages until then; none is older than a repetition.
std::map<DrawingTopic, std::string> DrawingReader::messages_at(Duration time) {
  const auto begins = [&](std::size_t chunk) {
    return Duration(static_cast<Duration::rep>(file_.contents().chunks[chunk].start_time));
  };
  std::map<DrawingTopic, std::string> last;
  auto index = static_cast<std::size_t>(std::ranges::upper_bound(chunks_, time, {}, begins) - chunks_.begin());
  while (index-- > 0 && last.size() < topics_.size() && begins(chunks_[index]) >= time - 2 * repeat_period) {
    const Chunk& chunk = read(index);
    for (auto sketch = chunk.sketches.rbegin(); sketch != chunk.sketches.rend(); ++sketch) {
      if (sketch->time <= time) last.try_emplace(sketch->topic, sketch->bytes);
    }
  }
  return last;
}

std::map<DrawingTopic, std::vector<DrawnGroup>> DrawingReader::news(Duration time) {
  std::map<DrawingTopic, std::string> last = messages_at(time);
  std::map<DrawingTopic, std::vector<DrawnGroup>> drawn;
  with_context(file_.file().string(), [&] {
    for (const auto& [topic, bytes] : last) {
      const auto before = shown_.find(topic);
      if (before == shown_.end() || before->second != bytes) drawn[topic] = read_drawing_message(bytes, topic);
    }
  });
  for (const auto& [topic, bytes] : shown_) {
    if (!last.contains(topic)) drawn[topic] = {};
  }
  shown_ = std::move(last);
  return drawn;
}

}  // namespace murosimf::recording
