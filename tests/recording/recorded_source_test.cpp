// A recording that is played shows what the run was like, at every instant and in any order.
#include "murosimf/recording/recorded_source.h"

#include <map>
#include <thread>

#include <gtest/gtest.h>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/session/session.h"
#include "murosimf/world/drawing.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

/// Places of all objects that move, and joints, at instants of a run.
struct Seen {
  std::vector<Vec3d> position;
  std::vector<double> joints;
  std::vector<int> contacts;  // who touches the ground
};
Seen seen_in(scene::Scene& scene) {
  Seen seen;
  PoseFrame frame;
  take_poses(scene.simulation().world(), frame);
  for (std::size_t i = 0; i < scene.simulation().world().entities().size(); ++i) {
    const Entity& entity = *scene.simulation().world().entities()[i];
    if (!entity.find(properties::position)) continue;
    seen.position.insert(seen.position.end(), frame.position.begin() + static_cast<std::ptrdiff_t>(frame.first[i]),
                         frame.position.begin() + static_cast<std::ptrdiff_t>(frame.first[i + 1]));
  }
  seen.joints = frame.joint_position;
  std::vector<ContactMark> marks;
  scene.simulation().poses().add_contacts(scene.simulation().world(), marks);
  for (const ContactMark& mark : marks) seen.contacts.push_back(mark.ground_contact_of);
  return seen;
}

struct Recorded {
  std::map<Duration, Seen> seen;
  std::shared_ptr<const recording::RecordedRun> run;
};
/// Its state every 20 ms until 600 ms; one of its robots changes its level at 200 ms.
Recorded recorded_run(const std::string& scene_name) {
  Recorded result;
  fixtures::RepeatableRun run{.scene = scene_name, .time = 600ms, .how = {.cameras = false}};
  run.options.rate = 50;
  run.when_initialized = [&](scene::Scene& scene) {
    const std::string robot = scene_name == "nudge" ? "robot" : "blue1";
    scene.simulation().at(190ms, [&scene, robot] { (void)scene.post(robot + ".level = full_dynamics"); });
    for (Duration at{}; at < 600ms; at += 20ms) {
      scene.simulation().at(at, [&scene, &result, at] { result.seen[at] = seen_in(scene); });
    }
  };
  result.run = std::make_shared<const recording::RecordedRun>(fixtures::record(scene_name + ".mcap", run));
  return result;
}

void expect_same(const Seen& shown, const Seen& was, Duration time) {
  ASSERT_EQ(shown.position.size(), was.position.size());
  for (std::size_t i = 0; i < was.position.size(); ++i) {
    // a chain of up to eight links whose poses are rounded to 2^-15
    EXPECT_LT(norm(shown.position[i] - was.position[i]), 5e-4) << i << " at " << seconds(time);
  }
  for (std::size_t i = 0; i < was.joints.size(); ++i) EXPECT_NEAR(shown.joints[i], was.joints[i], 1e-4);
  EXPECT_EQ(shown.contacts, was.contacts) << seconds(time);
}

TEST(RecordedSource, ShowsEveryInstantAsItWasInAnyOrder) {
  const Recorded recorded = recorded_run("three_on_three");
  recording::RecordedSource source(recorded.run);
  source.begin();
  EXPECT_EQ(source.last(), 600ms);
  for (const Duration time : {0ms, 580ms, 20ms, 400ms, 380ms}) {
    source.seek(time, {}, [] { return false; });
    EXPECT_EQ(source.scene().simulation().now(), time);
    expect_same(seen_in(source.scene()), recorded.seen.at(time), time);
  }
  source.reset({});
  for (const auto& [time, was] : recorded.seen) {
    expect_same(seen_in(source.scene()), was, time);
    EXPECT_FALSE(source.at_end());
    source.step();
  }
  source.step();
  EXPECT_EQ(source.scene().simulation().now(), 600ms) << "nothing comes after the end";
}

TEST(RecordedSource, BetweenTwoFramesIsTheFirstOfThem) {
  const Recorded recorded = recorded_run("nudge");
  recording::RecordedSource source(recorded.run);
  source.begin();
  source.seek(119ms, {}, [] { return false; });
  EXPECT_EQ(source.scene().simulation().now(), 100ms);
  source.seek(10s, {}, [] { return false; });
  EXPECT_EQ(source.scene().simulation().now(), 600ms);
}

TEST(RecordedSource, EventsAndLevelsAreThoseOfThatTime) {
  const Recorded recorded = recorded_run("nudge");
  recording::RecordedSource source(recorded.run);
  source.begin();
  const Entity& robot = source.scene().simulation().world().entity("robot");
  const std::string before = robot.level;
  EXPECT_NE(before, "full_dynamics");
  EXPECT_TRUE(source.scene().simulation().events().empty());
  source.seek(600ms, {}, [] { return false; });
  ASSERT_FALSE(source.scene().simulation().events().empty());
  EXPECT_EQ(robot.level, "full_dynamics");
  source.seek(100ms, {}, [] { return false; });
  EXPECT_EQ(robot.level, before);
}

TEST(RecordedSource, DrawingsAreThoseOfThatTime) {
  fixtures::RepeatableRun run{.scene = "walk", .time = 300ms};
  run.when_built = [](scene::Scene& scene) {
    Drawings& drawn = scene.simulation().world().entity("walker").column(properties::drawings).values[0];
    scene.simulation().at(100ms, [&drawn] {
      drawn.groups.push_back(
          {.name = "path", .shapes = {{.kind = DrawnShape::line, .points = {{0, 0, 0}, {1, 0, 0}}}}});
      ++drawn.changes;
    });
    scene.simulation().at(200ms, [&drawn] {
      drawn.groups.clear();
      ++drawn.changes;
    });
  };
  const auto recorded = std::make_shared<const recording::RecordedRun>(fixtures::record("drawn.mcap", run));
  recording::RecordedSource source(recorded);
  source.begin();
  std::uint64_t changes = 0;
  for (const auto& [time, groups] :
       std::vector<std::pair<Duration, std::size_t>>{{150ms, 1}, {160ms, 1}, {50ms, 0}, {100ms, 1}, {250ms, 0}}) {
    source.seek(time, {}, [] { return false; });
    const Drawings& drawn = source.scene().simulation().world().entity("walker").find(properties::drawings)->values[0];
    EXPECT_EQ(drawn.groups.size(), groups) << seconds(time);
    EXPECT_EQ(drawn.changes == changes, time == 160ms) << seconds(time);
    changes = drawn.changes;
  }
}

TEST(RecordedSource, DrawingsOfOtherProgramsAreThoseOfThatTime) {
  drawing::DebugDrawBuffer live;
  fixtures::RepeatableRun run{.scene = "walk", .time = 300ms};
  run.options.others = &live;
  run.when_built = [&](scene::Scene& scene) {
    scene.simulation().at(100ms, [&] {
      drawing::ExternalDrawings drawn;
      drawn.groups.push_back({.name = "way"});
      drawn.groups[0].shapes.push_back({.kind = DrawnShape::circle, .points = {{1, 2, 0}}});
      live.pin(std::move(drawn));
    });
    scene.simulation().at(200ms, [&] { live.pin({}); });
  };
  const auto recorded = std::make_shared<const recording::RecordedRun>(fixtures::record("external_drawings.mcap", run));
  const auto shown = std::make_shared<drawing::DebugDrawBuffer>();
  for (int reload = 0; reload < 2; ++reload) {
    recording::RecordedSource source(recorded, {}, shown);
    source.begin();
    EXPECT_TRUE(shown->shown()->groups.empty()) << "what an earlier source showed is gone";
    std::uint64_t changes = shown->shown()->changes;
    for (const auto& [time, groups] :
         std::vector<std::pair<Duration, std::size_t>>{{250ms, 0}, {150ms, 1}, {160ms, 1}, {50ms, 0}, {140ms, 1}}) {
      source.seek(time, {}, [] { return false; });
      EXPECT_EQ(shown->shown()->groups.size(), groups) << seconds(time);
      EXPECT_EQ(shown->shown()->changes == changes, time == 160ms) << seconds(time);
      changes = shown->shown()->changes;
    }
  }
}

// What another program did cannot be repeated; it is shown all the same, and without waiting for that program.
TEST(RecordedSource, RunsThatOthersSteeredAreShown) {
  fixtures::RepeatableRun run{.scene = "walk", .time = 100ms};
  run.how.overrides = {"walker.controller=serial"};
  run.how.terminals = fixtures::temp_folder().string();
  const auto recorded = std::make_shared<const recording::RecordedRun>(fixtures::record("serial.mcap", run));
  EXPECT_THROW((void)recorded->build({}), SetupError);
  recording::RecordedSource source(recorded);
  source.begin();
  EXPECT_EQ(source.last(), 100ms);
}

TEST(RecordedSource, InASessionItPlaysAndNobodyChangesIt) {
  const Recorded recorded = recorded_run("nudge");
  session::Session session(std::make_unique<recording::RecordedSource>(recorded.run), {.paused = true});
  const auto reader = session.scene().simulation().poses().subscribe({.contacts = true});
  std::thread thread([&] { session.run(recorded.run->end()); });
  EXPECT_THROW(session.change("robot.level = kinematic_walking").get(), SetupError);
  EXPECT_THROW(session.reset(3).get(), SetupError);
  EXPECT_EQ(session.branches().size(), 1U);
  EXPECT_EQ(session.branches()[0].end, 600ms);
  const auto comes_to = [&](Duration time) {
    for (int i = 0; i < 5000 && session.status().time != time; ++i) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(session.status().time, time);
  };
  session.step(2);
  comes_to(40ms);
  session.go_on();
  comes_to(600ms);
  session.seek(200ms).get();
  EXPECT_TRUE(session.status().paused);
  const PoseFrame* frame = reader->latest();
  EXPECT_TRUE(frame && frame->time == 200ms);
  session.go_on();
  comes_to(600ms);
  session.visit([](scene::Scene&) {}).get();
  EXPECT_TRUE(session.status().at_end);
  session.go_on();  // from the start
  session.visit([](scene::Scene&) {}).get();
  EXPECT_GE(session.status().jumps, 2U);
  comes_to(600ms);
  session.finish();
  thread.join();
}

}  // namespace
}  // namespace murosimf
