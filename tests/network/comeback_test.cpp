// Software in lock-step may disconnect and reconnect at any cycle, and one that disconnects before the start ends no run.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/session/live_source.h"
#include "tests/network/tcp_fixture.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

/// Connects for the right robot, receives the start, and answers until the end, or for so many cycles.
void play(const Listener& listener, double velocity, int cycles = 1'000'000) {
  RawClient client(listener.port());
  client.come("right");
  for (int i = 0; i < cycles; ++i) {
    const wire::ToClient message = client.receive();
    if (message.has_goodbye()) return;
    EXPECT_EQ(message.cycle().start(), i == 0);
    client.answer(message.cycle().cycle(), {velocity, 0, 0});
  }
}

std::vector<std::string> said(const scene::Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& message : software(scene, "right").said) {
    lines.push_back(fmt::format("{:.3f} {}", seconds(message.time), message.text));
  }
  return lines;
}

/// Of two robots: the right one has software that disconnects and reconnects.
struct Two {
  explicit Two(std::vector<std::string> overrides = {})
      : left([this] { walk_to_ball("left", listener.port()); }), options(std::move(overrides)) {
    options.insert(options.end(), {"right.control_rate=20", "right.options.absence=20"});
  }
  void build() { scene.emplace(to_the_ball_tcp, two_robots(listener, options)); }

  Listener listener;
  Software left;
  std::vector<std::string> options;
  std::optional<scene::Scene> scene;
};

TEST(Comeback, AtAnyCycleTheRunStandsStillForWhoComesNext) {
  for (const int cycles : {0, 1, 2, 7}) {  // before the answer to the start, after it, ...
    Two two;
    Software right([&] {
      play(two.listener, 0.05, cycles);
      play(two.listener, 0.08);
    });
    two.build();
    two.scene->simulation().run(1s);
    EXPECT_EQ(software(*two.scene, "right").ended, "") << cycles;
    EXPECT_EQ(forward(*two.scene, "right"), 0.08) << cycles;
    EXPECT_EQ(software(*two.scene, "left").calls, 20) << cycles;
    const auto lines = said(*two.scene);
    ASSERT_EQ(lines.size(), 1U) << cycles;
    const std::string when = fmt::format("{:.3f} ", 0.05 * std::max(0, cycles - 1));
    EXPECT_TRUE(says(lines[0], {when, "raw at", "closed the connection", "raw at", "has come"})) << cycles;
    two.scene.reset();
    EXPECT_EQ(right.error(), "");
  }
}

TEST(Comeback, LaterThanTheRunWaitsForIt) {
  Two two({"right.options.absence=0"});
  two.options.pop_back();
  Software first([&] { play(two.listener, 0.05, 5); });
  two.build();
  two.scene->simulation().run(500ms);
  EXPECT_TRUE(says(software(*two.scene, "right").ended, {"at 0.200 s: raw at", "closed the connection"}));
  EXPECT_EQ(forward(*two.scene, "right"), 0.05) << "the last commands hold";
  Software second([&] { play(two.listener, 0.08); });
  EXPECT_TRUE(run_until(*two.scene, [&] { return forward(*two.scene, "right") == 0.08; }));
  EXPECT_EQ(software(*two.scene, "right").ended, "");
  two.scene.reset();
  EXPECT_EQ(second.error(), "");
}

TEST(Comeback, WhileTheRunIsPausedAndNobodyElseMayCome) {
  Two two;
  auto first = std::make_unique<RawClient>(two.listener.port());
  Software coming([&] {
    first->come("right");
    first->play(3);
  });
  two.build();
  two.scene->simulation().run(100ms);
  EXPECT_EQ(coming.error(), "");
  RawClient early(two.listener.port());
  early.hello("right");
  EXPECT_EQ(early.end(), "'right' has its software already");
  first.reset();  // without a connection the run stands still
  Software second([&] { play(two.listener, 0.08); });
  two.scene->simulation().run(100ms);
  EXPECT_EQ(forward(*two.scene, "right"), 0.08);
  two.scene.reset();
  EXPECT_EQ(second.error(), "");
}

TEST(Comeback, WhoGoesBeforeItIsReadyLeavesTheRobotToTheNext) {
  Two two;
  Software right([&] {
    {
      RawClient client(two.listener.port());
      client.hello("right");
      EXPECT_TRUE(client.receive().has_welcome());
      wire::FromClient ask;
      ask.mutable_ask()->set_command("joint.target");  // excludes what the next one asks for
      client.send(ask);
      EXPECT_TRUE(client.receive().has_description());
    }
    {
      RawClient client(two.listener.port());
      client.hello("right");
      client.bytes(std::string("\0\0\0\6garbag", 10));
      (void)client.end();
    }
    play(two.listener, 0.08);
  });
  two.build();
  two.scene->simulation().run(500ms);
  EXPECT_EQ(forward(*two.scene, "right"), 0.08);
  const auto lines = two.listener.lines(2);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(says(lines[0], {"right: raw at", "closed the connection before it was ready", "waiting for other"}));
  EXPECT_TRUE(says(lines[1], {"right: raw at", "no message of this protocol before it was ready"}));
  two.scene.reset();
  EXPECT_EQ(right.error(), "");
}

TEST(Comeback, WhoGoesWhileOthersAreWaitedForEndsNobodysRun) {
  const Listener listener;
  {
    RawClient gone(listener.port());
    gone.hello("left");
  }
  RawClient ready(listener.port());
  Software right([&] { play(listener, 0.08); });
  Software left([&] {
    ready.come("left");
    const RawClient goes = std::move(ready);  // before the start
  });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"right.control_rate=20", "left.options.absence=0"}));
  EXPECT_EQ(left.error(), "");
  scene.simulation().run(500ms);
  EXPECT_EQ(forward(scene, "right"), 0.08);
  EXPECT_TRUE(says(software(scene, "left").ended, {"raw at", "closed the connection"}));
}

TEST(Comeback, AResetBeginsWithWhoeverIsThere) {
  Two two({"right.options.absence=0"});
  two.options.pop_back();
  Software first([&] { play(two.listener, 0.05, 5); });
  two.build();
  two.scene->simulation().run(500ms);
  EXPECT_EQ(first.error(), "");
  two.scene->reset();
  two.scene->simulation().run(200ms);
  EXPECT_EQ(forward(*two.scene, "right"), 0);
  EXPECT_NE(software(*two.scene, "right").ended, "");
}

/// A course of a scene with this software for the right robot.
struct Way {
  explicit Way(const std::function<void(const Listener&)>& software, const std::vector<std::string>& more = {})
      : two(more), right([this, software] { software(two.listener); }) {
    two.build();
    course.emplace(*two.scene);
    course->begin();
  }
  void go_to(Duration time) {
    while (two.scene->simulation().now() < time) course->step();
  }
  void seek(Duration time, std::optional<int> branch = {}) {
    course->seek(time, branch, [] { return false; });
  }
  [[nodiscard]] std::uint64_t hash() const { return two.scene->simulation().state_hash(); }

  Two two;
  Software right;
  std::optional<session::LiveSource> course;
};

/// Walks by the count of its cycles.
void count(RawClient& client, std::atomic<int>& cycles) {
  for (;;) {
    const wire::ToClient message = client.receive();
    if (message.has_goodbye()) return;
    client.answer(message.cycle().cycle(), {0.1 + 0.1 * std::sin(0.05 * ++cycles), 0, 0});
  }
}

TEST(SeekWithSoftware, LockStepIsAnsweredFromWhatItHadSaid) {
  std::atomic<int> cycles{0};
  Way way([&](const Listener& listener) {
    RawClient client(listener.port());
    client.come("right");
    count(client, cycles);
  });
  way.go_to(1300ms);
  const auto then = way.two.scene->save();
  way.go_to(3300ms);
  const auto last = way.two.scene->save();
  const int asked = cycles;
  way.seek(1300ms);
  EXPECT_TRUE(way.two.scene->save() == then);
  EXPECT_TRUE(says(way.course->diagnostic(), {"software of left, right keep their own state: from 1.3 s on"}));
  way.seek(3300ms);
  EXPECT_TRUE(way.two.scene->save() == last);
  EXPECT_EQ(cycles, asked) << "no software was asked";
  way.seek(1300ms);
  way.go_to(1400ms);
  EXPECT_EQ(cycles, asked + 2);
  way.course.reset();
  way.two.scene.reset();
  EXPECT_EQ(way.right.error(), "");
}

TEST(SeekWithSoftware, FreeIsAnsweredFromWhatItHadSaid) {
  std::atomic<int> cycles{0};
  Way way(
      [&](const Listener& listener) {
        RawClient client(listener.port());
        client.come("right");
        count(client, cycles);
      },
      {"right.options.mode=free"});
  const auto slowly_to = [&](Duration time) {
    for (Duration next = 0s; next <= time; next += 50ms) {
      way.go_to(next);
      std::this_thread::sleep_for(1ms);
    }
  };
  slowly_to(1300ms);
  const auto then = way.two.scene->save();
  slowly_to(3300ms);
  EXPECT_GT(cycles, 10);
  const auto last = way.two.scene->save();
  for (const bool early : {true, false, true}) {
    way.seek(early ? 1300ms : 3300ms);
    EXPECT_TRUE(way.two.scene->save() == (early ? then : last));
  }
  way.course.reset();
  way.two.scene.reset();
  EXPECT_EQ(way.right.error(), "");
}

TEST(SeekWithSoftware, OtherSoftwareMayComeBetweenGoingBackAndGoingOn) {
  std::atomic<bool> goes{false};
  Way way([&](const Listener& listener) {
    {
      RawClient client(listener.port());
      client.come("right");
      client.play(41);  // the start, and two seconds
      while (!goes) std::this_thread::sleep_for(1ms);
    }
    play(listener, 0.08);
  });
  way.go_to(2s);
  const std::uint64_t last = way.hash();
  way.seek(1s);
  goes = true;
  way.go_to(1500ms);
  EXPECT_EQ(forward(*way.two.scene, "right"), 0.08);
  way.seek(2s, 0);
  EXPECT_EQ(way.hash(), last);
  way.course.reset();
  way.two.scene.reset();
  EXPECT_EQ(way.right.error(), "");
}

}  // namespace
}  // namespace murosimf::control_software
