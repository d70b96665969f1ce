// One behavior (examples/controllers/course.h) as shared library, TCP client and serial client crosses the same obstacle course.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "examples/controllers/course_serial.h"
#include "examples/controllers/course_tcp.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/runtime/clock.h"
#include "tests/network/tcp_fixture.h"
#include "tests/temp_folder.h"

namespace murosimf::control_software {
namespace {

using namespace fixtures;

const std::filesystem::path course = MUROSIMF_SOURCE_DIR "/examples/controllers/course.toml";
constexpr auto long_enough = 22s;

/// The robot is at the goal, and has touched no pole.
void expect_won(scene::Scene& scene) {
  const World& world = scene.simulation().world();
  const Vec3d place = world.entity("runner").base().get(properties::position);
  EXPECT_NEAR(place.x, 1.5, 0.15);
  EXPECT_NEAR(place.y, 0, 0.1);
  EXPECT_NEAR(world.entity("pole1").base().get(properties::position).x, -0.6, 1e-3);
  EXPECT_NEAR(world.entity("pole2").base().get(properties::position).x, 0.6, 1e-3);
}

std::uint64_t hash_of_library() {
  scene::Scene scene(course, {.overrides = {"runner.controller=library",
                                            "runner.library=" MUROSIMF_EXAMPLE_CONTROLLERS "/course.so"},
                              .cameras = false});
  scene.simulation().run(long_enough);
  expect_won(scene);
  EXPECT_EQ(software(scene, "runner").said.size(), 1U);
  EXPECT_EQ(software(scene, "runner").refused, 0U);
  EXPECT_EQ(scene.simulation().world().entity("runner").base().get(properties::robot_led).y, 1) << "green at the goal";
  return scene.simulation().state_hash();
}

std::uint64_t hash_over_tcp() {
  const Listener listener;
  Software runner([&] { cross_course_over_tcp("runner", listener.port()); });
  std::uint64_t hash = 0;
  {
    scene::Scene scene(course, two_robots(listener));
    scene.simulation().run(long_enough);
    expect_won(scene);
    EXPECT_EQ(software(scene, "runner").said.size(), 1U);
    hash = scene.simulation().state_hash();
  }
  EXPECT_EQ(runner.error(), "");
  return hash;
}

TEST(Course, IsWonAsLibraryAndOverTcpWithTheSameState) { EXPECT_EQ(hash_of_library(), hash_over_tcp()); }

/// Runs it until a robot has arrived, slower and slower while the software at the serial line has not ended a cycle: a bus does not
/// wait, but here the load of the machine must not decide which software comes too late.
void run_beside(scene::Scene& scene, const std::atomic<int>& cycles, const std::atomic<bool>& arrived) {
  constexpr int usual = 3, gone = 300;  // [ms] an answer takes; at the end there are no more requests
  int last = 0, waited = 0;
  for (int ms = 0; ms < 60000 && !arrived; ++ms) {
    scene.simulation().run(1ms);
    const int now = cycles;
    waited = now == last ? waited + 1 : 0;
    last = now;
    if (waited > gone) return;
    if (waited > usual) std::this_thread::sleep_for(std::chrono::milliseconds(waited - usual));
  }
}

TEST(Course, IsWonOverASerialLine) {
  const std::filesystem::path folder = ::murosimf::fixtures::temp_folder() / "course_ports";
  scene::Scene scene(course,
                     {.overrides = {"runner.controller=serial"}, .terminals = folder.string(), .cameras = false});
  scene.simulation().step();
  std::atomic<bool> goes_on{true}, arrived{false};
  std::atomic<int> cycles{0};
  Software runner([&] {
    cross_course_over_serial(folder / "runner", [&] {
      ++cycles;
      return goes_on.load();
    });
    arrived = goes_on.load();
  });
  run_beside(scene, cycles, arrived);
  goes_on = false;
  Clock clock(1.0);
  scene.simulation().run(500ms, clock);  // an answer that it waits for
  EXPECT_EQ(runner.error(), "");
  EXPECT_TRUE(arrived);
  expect_won(scene);
}

}  // namespace
}  // namespace murosimf::control_software
