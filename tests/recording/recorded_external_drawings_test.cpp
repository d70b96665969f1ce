// What other programs draw stands in recordings on topics of its own, once for each change, and changes no state.
#include "murosimf/recording/recorded_external_drawings.h"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorder.h"
#include "murosimf/scene/scene_report.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace recording;
using namespace std::chrono_literals;

/// As an agent of the league sends it: a circle for all, a text at the third robot of the team on the right.
drawing::ExternalDrawings plan() {
  drawing::ExternalDrawings drawn;
  drawn.groups.push_back({.name = "blue.1.way"});
  drawn.groups.back().shapes.push_back({.kind = DrawnShape::circle, .points = {{1.0 / 3, 2, 0.005}}, .size = 0.5});
  drawn.notes.push_back({.team = 1, .number = 2, .color = {1, 0.5, 0}, .text = "mark him"});
  return drawn;
}

struct Recorded {
  std::filesystem::path file;
  std::uint64_t hash = 0;
};
/// The plan is there from 100 ms on, is drawn again at 200 ms, and goes at 300 ms. Its length is `time`; `board` false: no program draws.
Recorded record(const std::string& name, Duration time, bool board = true, RecorderOptions options = {}) {
  scene::Scene scene("three_on_three", {.cameras = false});
  drawing::DebugDrawBuffer drawings;
  options.file = fixtures::temp_folder() / name;
  if (board) options.others = &drawings;
  const bool asked = !options.record_on.empty();
  Recorder recorder(scene, options);
  for (const Duration at : {100ms, 200ms}) scene.simulation().at(at, [&] { drawings.pin(plan()); });
  if (!asked) scene.simulation().at(300ms, [&] { drawings.pin({}); });
  scene.simulation().at(time - 100ms, [&] {
    if (asked) recorder.ask(true);
  });
  scene.simulation().run(time);
  recorder.finish(make_report(scene));
  EXPECT_EQ(recorder.trouble(), "");
  return {options.file, scene.simulation().state_hash()};
}

std::map<std::string, int> messages_of(const McapReader& file) {
  std::map<std::string, int> counts;
  for (const ChunkIndex& chunk : file.contents().chunks) {
    file.visit_messages(chunk, [&](const Message& message) {
      for (const Channel& channel : file.contents().channels) {
        if (channel.id == message.channel_id && channel.topic.starts_with("/drawings/")) ++counts[channel.topic];
      }
    });
  }
  return counts;
}

TEST(RecordedOthers, AreReadBackAsTheyWereAtATime) {
  const McapReader file(record("others.mcap", 500ms).file);
  EXPECT_EQ(messages_of(file), (std::map<std::string, int>{{"/drawings/roboviz", 2}, {"/drawings/roboviz/red3", 2}}))
      << "what is the same is not written again";
  const scene::Scene scene("three_on_three", {.cameras = false});
  DrawingReader drawings(file);
  EXPECT_EQ(drawings.robots(), std::set<std::string>{}) << "no robot draws";
  RecordedExternalDrawings then(scene.simulation().world());
  EXPECT_FALSE(then.take(drawings.news(90ms)));
  EXPECT_TRUE(then.take(drawings.news(150ms)));
  const drawing::ExternalDrawings drawn = then.shown();
  EXPECT_EQ(drawn.groups, plan().groups);
  ASSERT_EQ(drawn.notes.size(), 1U);
  EXPECT_EQ(drawn.notes[0].team, 1);
  EXPECT_EQ(drawn.notes[0].number, 2);
  EXPECT_EQ(drawn.notes[0].color, (Color{1, 0.5, 0}));
  EXPECT_EQ(drawn.notes[0].text, "mark him");
  EXPECT_FALSE(then.take(drawings.news(290ms)));
  EXPECT_TRUE(then.take(drawings.news(400ms)));
  EXPECT_TRUE(then.shown().groups.empty());
  EXPECT_TRUE(then.shown().notes.empty());
  EXPECT_TRUE(then.take(drawings.news(150ms))) << "time goes back, too";
  EXPECT_EQ(then.shown().groups, plan().groups);
}

TEST(RecordedOthers, ChangeNoState) {
  EXPECT_EQ(record("drawn_for.mcap", 500ms).hash, record("not_drawn_for.mcap", 500ms, false).hash);
}

TEST(RecordedOthers, AreLeftOutWithTheOtherDrawings) {
  EXPECT_TRUE(messages_of(McapReader(record("poses.mcap", 500ms, true, {.file = {}, .what = {"poses"}}).file)).empty());
}

// Drawn long before the first second that is kept.
TEST(RecordedOthers, AreKeptUntilSomethingHappens) {
  RecorderOptions options{.file = {}, .what = {"poses", "drawings"}, .record_on = {"asked"}};
  options.keep = 400ms;
  const McapReader file(record("asked.mcap", 3s, true, options).file);
  EXPECT_GT(file.contents().statistics.start_time, 1'000'000'000U);
  const scene::Scene scene("three_on_three", {.cameras = false});
  RecordedExternalDrawings then(scene.simulation().world());
  DrawingReader drawings(file);
  EXPECT_TRUE(then.take(drawings.news(3s)));
  EXPECT_EQ(then.shown().groups, plan().groups);
  EXPECT_EQ(then.shown().notes.size(), 1U);
}

TEST(OthersWatch, SaysAllAgainAlsoOfWhatIsThereNoMore) {
  scene::Scene scene("three_on_three", {.cameras = false});
  scene.simulation().initialize();
  const World& world = scene.simulation().world();
  OthersWatch watch;
  watch.meet(world, recorded_entities(world));
  RecordedFrame none, first, again;
  watch.take({}, none);
  EXPECT_TRUE(none.drawings.empty());
  drawing::ExternalDrawings drawn = plan();
  drawn.changes = 1;
  watch.take(drawn, first);
  ASSERT_EQ(first.drawings.size(), 2U);
  EXPECT_EQ(first.drawings[1].topic, (DrawingTopic{true, "red3"}));
  EXPECT_TRUE(first.drawings[1].base.starts_with("red3/"));
  drawn.notes.clear();
  watch.say_again();
  watch.take(drawn, again);
  ASSERT_EQ(again.drawings.size(), 2U);
  EXPECT_EQ(again.drawings[0].groups, drawn.groups);
  EXPECT_TRUE(again.drawings[1].groups.empty());
}

}  // namespace
}  // namespace murosimf
