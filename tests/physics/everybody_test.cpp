// Robots of every level, a ball and a goal in one heap: results are the same however they are computed.
#include <gtest/gtest.h>

#include "tests/physics/encounters.h"

namespace murosimf::test {
namespace {

/// Four robots, one of each level, and a ball fall onto each other in front of a goal, beside a walker.
struct Heap {
  explicit Heap(const std::string& volume, int threads) : pitch(1000, threads) {
    const scene_file::GoalBox post = pitch.goal_box("post_left");
    std::vector<Rig::Together> all;
    const auto levels = all_levels();
    for (int i = 0; i < 4; ++i) {
      EntityOptions options{.position = {post.center.x - 0.12 - 0.05 * i, post.center.y + 0.06 * i, 0.25 * i},
                            .heading = 0.5 * i};
      if (i > 0) options.attitude = rotation_y(1.2);
      options.collision = {.volume = volume, .self_collision = true};
      Entity& robot = pitch.add("robot" + std::to_string(i), kid21(), options);
      pitch.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                      Vec3d{0.2, 0, 0});
      all.push_back({&robot, {.level = levels[static_cast<std::size_t>(i)]}});
    }
    EntityOptions options{.position = {post.center.x - 0.2, post.center.y, 1.1}};
    options.collision.volume = volume;
    all.push_back({&pitch.add("ball", scene_file::ball_model(), options), {}});
    pitch.attach_together(all);
  }
  /// Also counts how many contacts of bodies there are.
  std::uint64_t hash_after(int steps) {
    for (int i = 0; i < steps; ++i) {
      pitch.simulation.step();
      contacts += pitch.simulation.world().common().find(collision::pair_contacts)->values[0].points.size();
    }
    return pitch.simulation.state_hash();
  }
  Pitch pitch;
  std::size_t contacts = 0;
};

constexpr int steps = 1500;

TEST(Everybody, DoesNotDependOnThreads) {
  Heap first("sphere", 1);
  const std::uint64_t expected = first.hash_after(steps);
  EXPECT_GT(first.contacts, 1000u);
  for (const int threads : {2, 3}) EXPECT_EQ(Heap("sphere", threads).hash_after(steps), expected) << threads;
}

// Volumes only sort out what cannot touch.
TEST(Everybody, DoesNotDependOnTheKindOfVolume) {
  const std::uint64_t expected = Heap("sphere", 1).hash_after(steps);
  for (const auto volume : geometry::volume_names()) {
    EXPECT_EQ(Heap(std::string(volume), 1).hash_after(steps), expected) << volume;
  }
}

}  // namespace
}  // namespace murosimf::test
