#include "murosimf/session/session.h"

#include <atomic>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::session {
namespace {

using namespace std::chrono_literals;

constexpr const char* scene_name = "walk";
const std::vector<std::string> simplified{"walker.level=simplified_dynamics"};

scene::SceneOptions options_with(std::vector<std::string> events = {}) {
  return {.overrides = simplified, .events = std::move(events), .pushable = true};
}

std::uint64_t hash_at(Duration time, std::vector<std::string> events = {}) {
  scene::Scene scene(scene_name, options_with(std::move(events)));
  scene.simulation().run(time);
  return scene.simulation().state_hash();
}

/// A session that runs in a thread of its own as long as this lives.
class Running {
 public:
  explicit Running(Duration end, const SessionOptions& options = {.paused = true},
                   scene::SceneOptions scene_options = options_with())
      : scene(scene_name, scene_options), session(scene, options), thread_([this, end] {
          session.run(end);
          ended = true;
        }) {}
  ~Running() { finish(); }

  void finish() {
    session.finish();
    if (thread_.joinable()) thread_.join();
  }
  /// Waits until it stands still at that time.
  void comes_to(Duration time) {
    for (int i = 0; i < 20000; ++i) {
      const SessionStatus status = session.status();
      if (status.paused && status.time == time) return;
      std::this_thread::sleep_for(1ms);
    }
    FAIL() << "it did not come to " << seconds(time) << " s, but to " << seconds(session.status().time);
  }
  [[nodiscard]] std::uint64_t hash() {
    std::uint64_t hash = 0;
    session.visit([&](scene::Scene& seen) { hash = seen.simulation().state_hash(); }).get();
    return hash;
  }

  scene::Scene scene;
  Session session;
  std::atomic<bool> ended = false;

 private:
  std::thread thread_;
};

TEST(Session, ChangesNothingOfTheRunHoweverItIsPausedAndSteppedAndLookedAt) {
  Running running(2s);
  running.session.step(7);
  running.comes_to(7ms);
  running.session.set_speed(50.0);
  running.session.go_on_until(1s);
  running.comes_to(1s);
  running.session.set_speed({});
  running.session.go_on_until(2s);
  const auto reader = running.scene.simulation().poses().subscribe({.period = 10ms, .contacts = true});
  running.comes_to(2s);
  EXPECT_EQ(running.hash(), hash_at(2s));
}

// A run that is not paused may have come to its new end before it is told to go on: it stays there all the same.
TEST(Session, GoesOnUntilAnEndAlsoIfItIsThereAlready) {
  Running running(2s);
  running.session.step();  // run() has set its own end, then
  running.comes_to(1ms);
  for (const Duration end : {300ms, 300ms, 600ms, 600ms}) {
    running.session.go_on_until(end);
    running.comes_to(end);
    running.session.visit([](scene::Scene&) {}).get();
    EXPECT_EQ(running.session.status().time, end);
  }
}

TEST(Session, GoesBackToWhatWasThereBit) {
  Running running(3s);
  running.session.go_on();
  running.comes_to(3s);
  for (const Duration time : {1234ms, 0ms, 2999ms, 500ms, 501ms}) {
    running.session.seek(time).get();
    EXPECT_EQ(running.session.status().time, time);
    EXPECT_EQ(running.hash(), hash_at(time)) << seconds(time);
  }
  EXPECT_EQ(running.session.status().jumps, 5U);
  EXPECT_EQ(running.session.branches().size(), 1U);
}

TEST(Session, RepeatsChangesOnTheWayAndKeepsTheRestAsABranch) {
  Running running(700ms);
  running.session.go_on();
  running.comes_to(700ms);
  running.session.change("walker.command = [0.0, 0.1, 0.0]").get();
  running.session.change("walker.torso.push = [40, 0, 0, 0.1]").get();
  running.session.run_until(2s);
  running.session.go_on();
  running.comes_to(2s);
  const std::uint64_t changed = running.hash();
  const std::vector<std::string> events{"0.7:walker.command=[0.0, 0.1, 0.0]", "0.7:walker.torso.push=[40, 0, 0, 0.1]"};
  EXPECT_EQ(changed, hash_at(2s, events));
  EXPECT_NE(changed, hash_at(2s));

  running.session.seek(600ms).get();
  EXPECT_EQ(running.hash(), hash_at(600ms));
  running.session.go_on();  // without them
  running.comes_to(2s);
  EXPECT_EQ(running.hash(), hash_at(2s));
  EXPECT_EQ(running.session.status().branch, 1);

  running.session.seek(2s, 0).get();  // the other one is still there
  EXPECT_EQ(running.hash(), changed);
  std::vector<Command> commands;
  running.session.visit([&](scene::Scene& scene) { commands = scene.simulation().commands(); }).get();
  EXPECT_EQ(hash_at(2s, scene::events_of_commands(commands)), changed);
}

TEST(Session, ShowsChangesWhileItIsPaused) {
  Running running(1s);
  running.session.step(100);
  running.comes_to(100ms);
  const auto reader = running.scene.simulation().poses().subscribe({});
  const Entity& walker = running.scene.simulation().world().entity("walker");
  const auto head = static_cast<std::size_t>(*walker.model().find_object("head"));
  const std::string place = walker.model().objects()[0].name + ".position";
  std::size_t number = 0;
  running.session
      .visit([&](scene::Scene& scene) {
        number = static_cast<std::size_t>(scene.simulation().world().index_of(&walker));
        scene.simulation().publish_poses();
      })
      .get();
  const PoseFrame* before = reader->latest();
  ASSERT_NE(before, nullptr);
  const Vec3d head_before = before->position[before->first[number] + head];
  const Vec3d base = before->position[before->first[number]];
  running.session.change(fmt::format("walker.{} = [{}, {}, {}]", place, base.x + 1, base.y - 2, base.z)).get();
  const PoseFrame* after = reader->latest();
  ASSERT_NE(after, nullptr);
  const Vec3d moved = after->position[after->first[number] + head] - head_before;
  EXPECT_NEAR(norm(moved - Vec3d{1, -2, 0}), 0, 1e-9);
  // and what comes of it is what an event of that time gives
  running.session.run_until(300ms);
  running.session.go_on();
  running.comes_to(300ms);
  const std::string event = fmt::format("0.1:walker.{}=[{}, {}, {}]", place, base.x + 1, base.y - 2, base.z);
  EXPECT_EQ(running.hash(), hash_at(300ms, {event}));
}

TEST(Session, BeginsAgainWithAnotherSeed) {
  Running running(1s);
  running.session.step(500);
  running.comes_to(500ms);
  running.session.reset().get();
  EXPECT_EQ(running.session.status().time, 0ms);
  running.session.step(300);
  running.comes_to(300ms);
  EXPECT_EQ(running.hash(), hash_at(300ms));
  running.session.reset(99).get();
  std::uint64_t seed = 0;
  running.session.visit([&](scene::Scene& scene) { seed = scene.spec().seed; }).get();
  EXPECT_EQ(seed, 99U);
}

TEST(Session, SaysWhatIsWrongAndGoesOn) {
  Running running(1s);
  EXPECT_THROW(running.session.change("walkr.level = full_dynamics").get(), SetupError);
  EXPECT_THROW(running.session.change("walker.torso.push = [1, 2]").get(), SetupError);
  EXPECT_THROW(running.session.change("walker.torso.push = [nan, 0, 0, 1]").get(), SetupError);
  EXPECT_THROW(running.session.change("walker.torso.push = [1, 0, 0, 0]").get(), SetupError);
  EXPECT_THROW(running.session.seek(5s).get(), SetupError);
  EXPECT_THROW(running.session.seek(0s, 7).get(), SetupError);
  EXPECT_THROW(running.session.set_speed(-1.0), SetupError);
  running.session.go_on();
  running.comes_to(1s);
  EXPECT_EQ(running.hash(), hash_at(1s));
}

TEST(Session, HasNoWayBackWhereItIsToldSo) {
  Running running(1s, {.paused = true, .no_way_back = "it is logged"});
  running.session.step(10);
  running.comes_to(10ms);
  EXPECT_THROW(running.session.seek(0s).get(), SetupError);
  EXPECT_THROW(running.session.reset().get(), SetupError);
}

// As a recorded run, which keeps what comes.
TEST(Session, IsExtendedWhereThereIsNoWayBack) {
  Running running(1s, {.paused = true, .no_way_back = "it is recorded"});
  running.session
      .extend([](scene::Scene& scene) {
        (void)scene.add(scene_file::RobotSpec{.name = "guest", .model = "kid21", .where = "test"});
      })
      .get();
  running.session.step(10);
  running.comes_to(10ms);
  EXPECT_THROW(running.session.seek(0s).get(), SetupError);
}

TEST(Session, IsExtendedByWhatItsCommandsLetIn) {
  const auto add = [](scene::Scene& scene) {
    (void)scene.add(scene_file::RobotSpec{
        .name = "guest", .model = "kid21", .where = "test", .level = "simplified_dynamics", .present = false});
  };
  Running running(2s);
  running.session.step(100);
  running.comes_to(100ms);
  running.session.extend(add).get();
  running.session.change(std::vector<std::string>{"guest.present = true", "guest.place = [1, 1, 0, 0]"}).get();
  running.session.step(200);
  running.comes_to(300ms);
  const std::uint64_t hash = running.hash();
  EXPECT_EQ(running.session.status().first, 100ms) << "there is no way to before";
  running.session.seek(200ms).get();
  running.session.go_on_until(300ms);
  running.comes_to(300ms);
  EXPECT_EQ(running.hash(), hash) << "from there on it is repeated";
  EXPECT_THROW(running.session.extend([](scene::Scene&) { throw SetupError("no"); }).get(), SetupError);
  running.session.reset().get();
  bool present = true;
  running.session.visit([&](scene::Scene& scene) { present = scene.simulation().world().entity("guest").present(); })
      .get();
  EXPECT_FALSE(present);
}

TEST(Session, IsRecordedAsAskedFor) {
  std::string asked;
  Running running(1s, {.paused = true, .record = [&](bool on) { asked += on ? "on " : "off "; }});
  EXPECT_EQ(running.session.status().recorded, false);
  running.session.record(true).get();
  EXPECT_EQ(running.session.status().recorded, true);
  running.session.record(false).get();
  EXPECT_EQ(running.session.status().recorded, false);
  EXPECT_EQ(asked, "on off ");
  Running other(1s);
  EXPECT_EQ(other.session.status().recorded, std::nullopt);
  EXPECT_THROW(other.session.record(true).get(), SetupError);
}

TEST(Session, EndsByItselfUnlessItStays) {
  Running running(100ms, {.stays = false});
  for (int i = 0; i < 20000 && !running.ended; ++i) std::this_thread::sleep_for(1ms);
  EXPECT_TRUE(running.ended);
  EXPECT_EQ(running.session.status().time, 100ms);
  EXPECT_THROW(running.session.change("walker.level = full_dynamics").get(), SetupError);
}

TEST(Session, IsSteeredByManyThreadsAtOnce) {
  Running running(400ms, {.paused = false});
  std::vector<std::thread> threads;
  for (int number = 0; number < 4; ++number) {
    threads.emplace_back([&running, number] {
      for (int i = 0; i < 25; ++i) {
        if (number == 0) running.session.pause();
        if (number == 1) running.session.go_on();
        if (number == 2) running.session.seek(Duration{running.session.status().time / 2}).wait();
        if (number == 3) running.session.change("walker.command = [0.0, 0.0, 0.1]").wait();
        (void)running.session.branches();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  running.session.pause();
  running.session.visit([](const scene::Scene&) {}).get();
  const Duration end = running.session.status().time + 50ms;
  running.session.step(50);
  running.comes_to(end);
  std::vector<Command> commands;
  running.session.visit([&](const scene::Scene& scene) { commands = scene.simulation().commands(); }).get();
  EXPECT_EQ(hash_at(end, scene::events_of_commands(commands)), running.hash());
}

}  // namespace
}  // namespace murosimf::session
