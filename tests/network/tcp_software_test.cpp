// Control software over TCP: in lock-step the run equals that of the same software as a shared library; otherwise the latest commands apply.
#include <gtest/gtest.h>

#include "tests/network/tcp_fixture.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

std::uint64_t hash_over_tcp(int threads) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] { walk_to_ball("right", listener.port()); });
  std::uint64_t hash = 0;
  {
    scene::Scene scene(to_the_ball_tcp, two_robots(listener, {}, threads));
    scene.simulation().run(10s);
    hash = scene.simulation().state_hash();
    EXPECT_EQ(software(scene, "left").calls, 200);
    EXPECT_EQ(software(scene, "left").rate_hz, 20) << "as the software wants";
    EXPECT_EQ(software(scene, "right").said.size(), 1U);
    EXPECT_EQ(software(scene, "right").refused, 0U);
  }
  EXPECT_EQ(left.error(), "");
  EXPECT_EQ(right.error(), "");
  EXPECT_TRUE(listener.lines().empty());
  return hash;
}

// The same behavior (walk_to_ball.h) in a library and in other programs, here threads.
TEST(TcpSoftware, GivesTheStateOfTheSameLibraryWithAnyNumberOfThreads) {
  scene::SceneOptions options{.overrides = {"left.options.speed=0.15",
                                            "left.library=" MUROSIMF_EXAMPLE_CONTROLLERS "/walk_to_ball.so",
                                            "right.library=" MUROSIMF_EXAMPLE_CONTROLLERS "/walk_to_ball.so"},
                              .cameras = false};
  scene::Scene library(MUROSIMF_SOURCE_DIR "/examples/controllers/to_the_ball.toml", options);
  library.simulation().run(10s);
  const std::uint64_t hash = library.simulation().state_hash();
  for (const int threads : {1, 2, 3}) EXPECT_EQ(hash_over_tcp(threads), hash) << threads << " threads";
}

TEST(TcpSoftware, HasTheRateOfTheScene) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] { walk_to_ball("right", listener.port()); });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"left.control_rate=50"}));
  scene.simulation().run(1s);
  EXPECT_EQ(software(scene, "left").calls, 50);
  EXPECT_EQ(software(scene, "right").calls, 20);
}

TEST(TcpSoftware, BeginsAgainAfterAReset) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] { walk_to_ball("right", listener.port()); });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener));
  scene.simulation().run(10s);
  const std::uint64_t first = scene.simulation().state_hash();
  scene.reset();
  scene.simulation().run(10s);
  EXPECT_EQ(scene.simulation().state_hash(), first);
}

TEST(TcpSoftware, HasWrongNumbersRefusedAndCounted) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  Software right([&] {
    RawClient client(listener.port());
    client.come("right");
    client.play(5);
    client.answer(client.receive().cycle().cycle(), {0.1, 1e6, std::nan("")});
    client.play(15);
    (void)client.end();
  });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"right.control_rate=20"}));
  scene.simulation().run(1s);
  EXPECT_EQ(software(scene, "right").refused, 2U);
  EXPECT_EQ(software(scene, "right").first_refusal, "at 0.200 s: walk.velocity of y is 1e+06, not in -100 to 100");
  EXPECT_EQ(software(scene, "right").ended, "");
}

TEST(FreeTcpSoftware, HasTheLatestCommandsHold) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  RawClient right(listener.port());
  Software coming([&] { right.come("right"); });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"right.options.mode=free"}));
  EXPECT_EQ(coming.error(), "");
  scene.simulation().run(100ms);
  EXPECT_EQ(forward(scene, "right"), 0) << "no message has been sent";
  const std::uint64_t cycle = right.receive().cycle().cycle();
  for (const double velocity : {0.05, 0.07}) right.answer(cycle, {velocity, 0, 0});
  EXPECT_TRUE(run_until(scene, [&] { return forward(scene, "right") == 0.07; }));
  scene.simulation().run(500ms);
  EXPECT_EQ(forward(scene, "right"), 0.07);
}

TEST(FreeTcpSoftware, MayGoAndComeAgain) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  std::optional<Software> second;
  auto first = std::make_unique<RawClient>(listener.port());
  Software coming([&] { first->come("right"); });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"right.options.mode=free"}));
  EXPECT_EQ(coming.error(), "");
  scene.simulation().run(100ms);
  first->answer(first->receive().cycle().cycle(), {0.05, 0, 0});
  EXPECT_TRUE(run_until(scene, [&] { return forward(scene, "right") == 0.05; }));
  first.reset();
  EXPECT_TRUE(run_until(scene, [&] { return !software(scene, "right").said.empty(); }));
  EXPECT_TRUE(says(software(scene, "right").said[0].text,
                   {"raw at 127.0.0.1:", "closed the connection; its last commands hold until other software comes"}));
  EXPECT_EQ(forward(scene, "right"), 0.05);
  EXPECT_EQ(software(scene, "right").ended, "");

  second.emplace([&] {
    RawClient client(listener.port());
    client.come("right");
    EXPECT_TRUE(client.receive().cycle().start());
    for (;;) {
      const wire::ToClient message = client.receive();
      if (message.has_goodbye()) return;
      client.answer(message.cycle().cycle(), {0.08, 0, 0});
    }
  });
  EXPECT_TRUE(run_until(scene, [&] { return forward(scene, "right") == 0.08; }));
  EXPECT_TRUE(says(software(scene, "right").said[1].text, {"raw at 127.0.0.1:", "has come"}));
}

// Software that is slower than its cycles receives the values measured when it asks, not those queued in sockets.
TEST(FreeTcpSoftware, SlowSoftwareDoesNotFallBehind) {
  const Listener listener;
  Software left([&] { walk_to_ball("left", listener.port()); });
  RawClient slow(listener.port());
  Software coming([&] { slow.come("right"); });
  scene::Scene scene(to_the_ball_tcp, two_robots(listener, {"right.options.mode=free"}));
  EXPECT_EQ(coming.error(), "");
  std::int64_t oldest = 0;
  for (int i = 0; i < 5; ++i) {
    scene.simulation().run(500ms);
    for (int cycles = 0; cycles < 2; ++cycles) {
      const wire::Cycle cycle = slow.receive().cycle();
      slow.answer(cycle.cycle(), {0.05, 0, 0});
      if (i > 0) oldest = std::max(oldest, scene.simulation().now().count() - cycle.now());
    }
  }
  EXPECT_LE(oldest, 1'000'000'000) << "two cycles of its own";
}

TEST(TcpSoftware, IsAskedForByNobodyWithoutAServer) {
  EXPECT_TRUE(says(error_of([] { scene::Scene("walk", {.overrides = {"walker.controller=tcp"}}); }),
                   {"controller 'tcp': no software can come", "--listen PORT"}));
  const Listener listener;
  EXPECT_EQ(error_of([&] { scene::Scene("walk", {.software = listener.server}); }),
            "software can connect, but no robot has the controller 'tcp'");
}

}  // namespace
}  // namespace murosimf::control_software
