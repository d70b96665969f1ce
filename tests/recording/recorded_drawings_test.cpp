// What control software draws stands in recordings as Foxglove shows it, goes when its group goes, and is read back with all digits.
#include "murosimf/recording/recorded_drawings.h"

#include <cstring>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/recorder.h"
#include "murosimf/scene/scene_report.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace recording;
using namespace std::chrono_literals;

DrawnGroup of_all_kinds() {
  DrawnGroup group{.name = "all/kinds", .of_robot = false, .time = 100ms, .shapes = {}};
  for (const auto kind : {DrawnShape::circle, DrawnShape::line, DrawnShape::dots, DrawnShape::sphere,
                          DrawnShape::polygon, DrawnShape::text}) {
    group.shapes.push_back({.kind = kind,
                            .points = {{0.1, 2, 3}, {1.0 / 3, 0, 0}, {0, 1e-7, 0}, {-1, -1, 0}},
                            .size = 0.05 * static_cast<int>(kind),
                            .color = {0.25, 0.5, 1.0 / 3},
                            .opacity = 0.7,
                            .words = kind == DrawnShape::text ? "\"Tor\" für blau\n" : ""});
  }
  return group;
}

DrawnGroup of_robot() {
  return {.name = "path",
          .of_robot = true,
          .time = 100ms,
          .shapes = {{.kind = DrawnShape::line, .points = {{0, 0, 0}, {1, 0, 0}}}}};
}

void draw(Drawings& all, const std::vector<DrawnGroup>& groups) {
  all.groups = groups;
  ++all.changes;
}

/// 7 s; both groups from 100 ms on, one from 300 ms on.
const std::filesystem::path& recorded() {
  static const std::filesystem::path file = [] {
    scene::Scene scene("nudge", {.cameras = false});
    Drawings& all = scene.simulation().world().entity("robot").column(properties::drawings).values[0];
    RecorderOptions options{.file = fixtures::temp_folder() / "drawn.mcap", .what = {"poses", "drawings"}};
    Recorder recorder(scene, options);
    scene.simulation().at(100ms, [&] { draw(all, {of_all_kinds(), of_robot()}); });
    scene.simulation().at(300ms, [&] { draw(all, {of_all_kinds()}); });
    scene.simulation().run(7s);
    recorder.finish(make_report(scene));
    EXPECT_EQ(recorder.trouble(), "");
    return options.file;
  }();
  return file;
}

void expect_same(const DrawnGroup& group, const DrawnGroup& wanted) {
  EXPECT_EQ(group.name, wanted.name);
  EXPECT_EQ(group.of_robot, wanted.of_robot);
  EXPECT_EQ(group.time, wanted.time);
  ASSERT_EQ(group.shapes.size(), wanted.shapes.size());
  for (std::size_t i = 0; i < wanted.shapes.size(); ++i) {
    const DrawnShape &shape = group.shapes[i], &other = wanted.shapes[i];
    EXPECT_EQ(shape.kind, other.kind);
    ASSERT_EQ(shape.points.size(), other.points.size());
    for (std::size_t k = 0; k < other.points.size(); ++k) EXPECT_EQ(norm(shape.points[k] - other.points[k]), 0);
    EXPECT_EQ(shape.size, other.size);
    EXPECT_EQ(shape.color.blue, other.color.blue);
    EXPECT_EQ(shape.opacity, other.opacity);
    EXPECT_EQ(shape.words, other.words);
  }
}

/// How often each field comes.
std::map<int, int> counts_of(ProtobufReader in) {
  std::map<int, int> counts;
  while (in.next()) ++counts[in.field()];
  return counts;
}

TEST(RecordedDrawings, AreReadBackAsTheyWereAtATime) {
  const DrawingTopic robot{false, "robot"};
  const McapReader file(recorded());
  DrawingReader drawings(file);
  EXPECT_EQ(drawings.robots(), std::set<std::string>{"robot"});
  EXPECT_TRUE(drawings.news(90ms).empty());
  const auto both = drawings.news(200ms);
  ASSERT_EQ(both.size(), 1U);
  ASSERT_EQ(both.at(robot).size(), 2U);
  expect_same(both.at(robot)[0], of_all_kinds());
  expect_same(both.at(robot)[1], of_robot());
  EXPECT_TRUE(drawings.news(250ms).empty()) << "nothing is new";
  EXPECT_EQ(drawings.news(0ms).at(robot).size(), 0U) << "nothing was drawn yet";
  for (const Duration later : {300ms, 4000ms, 7000ms}) {
    const auto one = DrawingReader(file).news(later);
    ASSERT_EQ(one.at(robot).size(), 1U) << seconds(later);
    expect_same(one.at(robot)[0], of_all_kinds());
  }
}

TEST(RecordedDrawings, AreEntitiesOfFoxglove) {
  const McapReader file(recorded());
  std::vector<std::pair<std::uint64_t, std::string>> messages;
  for (const ChunkIndex& chunk : file.contents().chunks) {
    file.visit_messages(chunk, [&](const Message& message) {
      for (const Channel& channel : file.contents().channels) {
        if (channel.id == message.channel_id && channel.topic == "/drawings/robot")
          messages.emplace_back(message.log_time, message.data);
      }
    });
  }
  ASSERT_EQ(messages.size(), 3U) << "two changes, and a repetition after 5 s";
  EXPECT_EQ(messages[0].first, 100'000'000U);
  EXPECT_EQ(messages[2].first, 5'300'000'000U);
  std::vector<std::string> frames;
  for (ProtobufReader in(messages[0].second); in.next();) {
    if (in.field() == 1) {
      EXPECT_TRUE(frames.empty()) << "what was there before goes first";
      for (ProtobufReader deletion = in.message(); deletion.next();) {
        if (deletion.field() != 2) continue;
        EXPECT_EQ(deletion.varint(), 1U) << "all of the topic";
      }
      continue;
    }
    for (ProtobufReader entity = in.message(); entity.next();) {
      if (entity.field() == 2) frames.emplace_back(entity.bytes());
    }
    const std::map<int, int> counts = counts_of(in.message());
    if (frames.size() > 1) continue;
    EXPECT_EQ(counts.at(11), 2) << "circle and line";
    EXPECT_EQ(counts.at(9), 1 + 4) << "sphere and dots";
    EXPECT_EQ(counts.at(12), 1) << "polygon";
    EXPECT_EQ(counts.at(13), 1) << "text";
  }
  const RecordedEntity base = recorded_entities(scene::Scene("nudge", {.cameras = false}).simulation().world()).front();
  EXPECT_EQ(frames, (std::vector<std::string>{"world", base.links.front().frame}));
}

/// The bytes of the fields of these numbers, each in the one before.
std::string_view inside(std::string_view bytes, std::initializer_list<int> fields) {
  for (const int field : fields) {
    ProtobufReader in(bytes);
    while (in.next() && in.field() != field) continue;
    bytes = in.bytes();
  }
  return bytes;
}

TEST(RecordedDrawings, PolygonsAreFilledAsTheyAre) {
  const std::vector<Vec3d> corners{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  FrameDrawings drawn{.topic = {false, "one"}, .base = "", .groups = {{.name = "L"}}};
  drawn.groups[0].shapes.push_back({.kind = DrawnShape::polygon, .points = corners});
  const std::string message = drawing_message(1s, drawn);
  // SceneUpdate.entities, SceneEntity.triangles, TriangleListPrimitive.indices
  const std::string_view bytes = inside(message, {2, 12, 5});
  std::vector<std::uint32_t> indices(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(indices.data(), bytes.data(), bytes.size());
  double area = 0;  // [m^2]; a fan would have more
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Vec3d& a = corners.at(indices[i]);
    area += norm(cross(corners.at(indices[i + 1]) - a, corners.at(indices[i + 2]) - a)) / 2;
  }
  EXPECT_NEAR(area, 3, 1e-12) << "sums of halves of whole numbers";
}

TEST(RecordedDrawings, DamageIsSaid) {
  const DrawingTopic one{false, "one"}, two{false, "two"};
  const std::string message = drawing_message(1s, {.topic = one, .base = "", .groups = {of_all_kinds()}});
  EXPECT_EQ(read_drawing_message(message, one).size(), 1U);
  EXPECT_THROW((void)read_drawing_message(message, two), SetupError);
  for (std::size_t size = 1; size + 1 < message.size(); size += 7) {
    try {
      (void)read_drawing_message(std::string_view(message).substr(0, size), one);
    } catch (const SetupError& error) {
      EXPECT_STRNE(error.what(), "");
    }
  }
}

}  // namespace
}  // namespace murosimf
