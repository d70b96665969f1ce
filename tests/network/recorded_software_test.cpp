// Runs with software over TCP are repeated from their recordings alone: in lock-step, free, with software that disconnects and reconnects.
#include <gtest/gtest.h>

#include <functional>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/recorded_external_input.h"
#include "tests/network/tcp_fixture.h"
#include "tests/recording/repeatable_run.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;
using ::murosimf::fixtures::expect_repeatable;
using ::murosimf::fixtures::record;
using ::murosimf::fixtures::RepeatableRun;

RepeatableRun run_of(const Listener& listener, Duration time, std::vector<std::string> overrides = {}) {
  RepeatableRun run{.scene = to_the_ball_tcp.string(), .time = time, .how = two_robots(listener, std::move(overrides))};
  run.how.outside.notes = std::make_shared<ExternalInputLog>();
  run.options.state_period = 1s;
  return run;
}

/// Of two robots that walk to the ball; `adjust` changes it.
std::filesystem::path record_two(const std::string& name, const std::function<void(RepeatableRun&)>& adjust = {}) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] { walk_to_ball("right", listener.port()); });
  RepeatableRun run = run_of(listener, 6s);
  if (adjust) adjust(run);
  return record(name, run);
}

TEST(RecordedSoftware, LockStepIsRepeated) { expect_repeatable(record_two("lock_step.mcap")); }

// The opposite: with another command it is another run.
TEST(RecordedSoftware, AnotherCommandIsADifference) {
  const recording::McapReader reader(record_two("lock_step.mcap"));
  ExternalInputLog notes = *recording::recorded_external_input(reader);
  const auto hash = [](const ExternalInputLog& all) {
    scene::Scene scene(to_the_ball_tcp,
                       {.cameras = false, .outside = {.repeated = std::make_shared<const ExternalInputLog>(all)}});
    scene.simulation().run(6s);
    return scene.simulation().state_hash();
  };
  const std::uint64_t as_recorded = hash(notes);
  EXPECT_EQ(hash(notes), as_recorded);
  ExternalInput& note = notes.channel("tcp:right").at(40);
  wire::FromClient message;
  ASSERT_TRUE(message.ParseFromString(note.bytes) && message.has_commands());
  message.mutable_commands()->mutable_rows(0)->mutable_values()->Set(0, 0.01);
  note.bytes = message.SerializeAsString();
  EXPECT_NE(hash(notes), as_recorded);
}

TEST(RecordedSoftware, ThatGoesInTheMiddleIsRepeated) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] {
    RawClient client(listener.port());
    client.come("right");
    client.play(30);
  });
  RepeatableRun run = run_of(listener, 4s, {"right.control_rate=20"});
  run.play = [](scene::Scene& scene, recording::Recorder&) {
    scene.simulation().run(4s);
    EXPECT_TRUE(says(software(scene, "right").ended, {"at 1.", "closed the connection"}));
  };
  expect_repeatable(record("gone.mcap", run));
}

TEST(RecordedSoftware, FreeIsRepeatedWithAllWhoCome) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  auto first = std::make_unique<RawClient>(listener.port());
  Software coming([&] { first->come("right"); });
  std::optional<Software> second;
  RepeatableRun run = run_of(listener, 0s, {"right.options.mode=free"});
  run.options.state_period = 200ms;
  run.play = [&](scene::Scene& scene, recording::Recorder&) {
    EXPECT_EQ(coming.error(), "");
    scene.simulation().run(300ms);
    first->answer(first->receive().cycle().cycle(), {0.05, 0, 0});
    EXPECT_TRUE(run_until(scene, [&] { return forward(scene, "right") == 0.05; }));
    first.reset();
    EXPECT_TRUE(run_until(scene, [&] { return !software(scene, "right").said.empty(); }));
    second.emplace([&] {
      RawClient client(listener.port());
      client.come("right");
      client.play(1000);
    });
    EXPECT_TRUE(run_until(scene, [&] { return forward(scene, "right") == 0.1; }));
    scene.simulation().run(1s);
  };
  expect_repeatable(record("free.mcap", run));
}

TEST(RecordedSoftware, WhatIsAskedForIsRepeatedOverTheGap) {
  expect_repeatable(record_two("asked.mcap", [](RepeatableRun& run) {
    run.options.record_on = {"asked"};
    run.options.keep = 200ms;
    run.play = [](scene::Scene& scene, recording::Recorder& recorder) {
      scene.simulation().run(2s);
      for (int i = 0; i < 2; ++i) {
        recorder.ask(true);
        scene.simulation().run(500ms);
        recorder.ask(false);
        scene.simulation().run(1500ms);
      }
    };
  }));
}

// Without its notes it is refused, as older recordings are.
TEST(RecordedSoftware, IsRefusedWhereNobodyHasWrittenItDown) {
  const recording::RecordedRun recorded(record_two("without.mcap", [](RepeatableRun& run) {
    run.time = 100ms;
    run.how.outside = {};
  }));
  EXPECT_TRUE(says(error_of([&] { (void)recorded.build({}); }), {"without.mcap: ", "tcp"}));
}

}  // namespace
}  // namespace murosimf::control_software
