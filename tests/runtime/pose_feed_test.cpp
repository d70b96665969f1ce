// Readers in other threads get whole frames, and only new ones.
#include "murosimf/runtime/pose_feed.h"

#include <thread>

#include <gtest/gtest.h>

#include "murosimf/model/chain.h"
#include "murosimf/model/properties.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

/// Moves all objects of an entity together: every frame must show one place only.
class Shift final : public Algorithm {
 public:
  explicit Shift(Setup& setup)
      : r_(setup.write(properties::position)),
        R_(setup.write(properties::orientation)),
        q_(setup.write(properties::joint_position)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
  void initialize() override { put(0); }
  void step(const Instant& instant) noexcept override { put(seconds(instant.now + instant.period)); }

 private:
  void put(double x) noexcept {
    for (std::size_t i = 0; i < r_.size(); ++i) {
      r_[i] = {x, 2 * x, static_cast<double>(i)};
      R_[i] = rotation_z(x);
      q_[i] = -x;
    }
  }
  std::span<Vec3d> r_;
  std::span<Mat3d> R_;
  std::span<double> q_;
};

struct Moving {
  Moving() {
    field = &simulation.world().add("field", std::make_shared<const Model>("field", Chain{}.base("base")));
    const ModelPtr arm = std::make_shared<const Model>(
        "arm",
        Chain{}.base("base").with(properties::mass, 1.0).revolute("joint", {1, 0, 0}).with(properties::mass, 1.0));
    robot = &simulation.world().add("robot", arm);
    simulation.attach<Shift>("shift", *robot, 1000);
  }
  Simulation simulation;
  Entity *field = nullptr, *robot = nullptr;
};

TEST(PoseFeed, ShowsWhatTheColumnsHaveAfterTheStep) {
  Moving moving;
  const auto reader = moving.simulation.poses().subscribe();
  EXPECT_EQ(reader->latest(), nullptr) << "nothing has happened";
  moving.simulation.run(3ms);
  const PoseFrame* frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->time, Duration(3ms));
  EXPECT_EQ(frame->tick, 3);
  ASSERT_EQ(frame->first, (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(norm(frame->position[0]), 0) << "the field";
  EXPECT_DOUBLE_EQ(frame->position[2].x, 0.003);
  EXPECT_EQ(frame->position[2].z, 1);
  EXPECT_DOUBLE_EQ(frame->orientation[1].x.y, std::sin(0.003));
  EXPECT_DOUBLE_EQ(frame->joint_position[2], -0.003);
  EXPECT_EQ(frame->frozen, (std::vector<bool>{false, false}));
  EXPECT_EQ(reader->latest(), nullptr) << "no newer one";
}

TEST(PoseFeed, WhoVisitsGetsTheSameCompletedAndNobodyElseDoes) {
  Moving moving;
  PoseFeed& poses = moving.simulation.poses();
  const auto reader = poses.subscribe();
  moving.simulation.run(3ms);
  const PoseFrame published = *reader->latest();
  poses.contacts_from([](const World&, std::vector<ContactMark>& contacts) { contacts.emplace_back(); });
  poses.complete_by([](const World&, PoseFrame& frame) { frame.position[2].y = 7; });
  PoseFrame taken{.contacts = {{}}};
  poses.take(moving.simulation.world(), moving.simulation.now(), 3, taken);
  EXPECT_EQ(taken.time, Duration(3ms));
  EXPECT_EQ(taken.tick, 3);
  EXPECT_EQ(taken.first, published.first);
  EXPECT_EQ(norm(taken.position[1] - published.position[1]), 0);
  EXPECT_EQ(taken.position[2].y, 7);
  EXPECT_TRUE(taken.contacts.empty());
  EXPECT_EQ(reader->latest(), nullptr);
}

TEST(PoseFeed, TheStartIsAFrame) {
  Moving moving;
  const auto reader = moving.simulation.poses().subscribe();
  moving.simulation.initialize();
  const PoseFrame* frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->time, Duration{});
}

TEST(PoseFeed, AFrameStaysAsItIsUntilTheNextIsAskedFor) {
  Moving moving;
  const auto reader = moving.simulation.poses().subscribe();
  moving.simulation.run(2ms);
  const PoseFrame* frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  moving.simulation.run(10ms);
  EXPECT_DOUBLE_EQ(frame->position[1].x, 0.002);
  frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  EXPECT_DOUBLE_EQ(frame->position[1].x, 0.012) << "the newest one";
}

TEST(PoseFeed, KeepsThePeriodThatWasAskedFor) {
  Moving moving;
  const auto every = moving.simulation.poses().subscribe(), some = moving.simulation.poses().subscribe({.period = 5ms});
  int frames = 0, few = 0;
  for (int i = 0; i < 20; ++i) {
    moving.simulation.step();
    if (every->latest()) ++frames;
    if (some->latest()) ++few;
  }
  EXPECT_EQ(frames, 20);
  EXPECT_EQ(few, 5) << "0 or 1, then every 5 ms until 20";
}

TEST(PoseFeed, GoesOnAfterAReset) {
  Moving moving;
  const auto reader = moving.simulation.poses().subscribe({.period = 5ms});
  moving.simulation.run(100ms);
  (void)reader->latest();
  moving.simulation.reset();
  const PoseFrame* frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->time, Duration{});
}

TEST(PoseFeed, SaysWhoWasFrozen) {
  Moving moving;
  const auto reader = moving.simulation.poses().subscribe();
  moving.simulation.step();
  moving.robot->freeze("a test");
  moving.simulation.step();
  EXPECT_EQ(reader->latest()->frozen, (std::vector<bool>{false, true}));
}

TEST(PoseFeed, ContactsAreForWhoAsks) {
  Moving moving;
  moving.simulation.poses().contacts_from([](const World&, std::vector<ContactMark>& marks) {
    marks.push_back({{1, 2, 3}, {4, 5, 6}});
  });
  const auto with = moving.simulation.poses().subscribe({.contacts = true}),
             without = moving.simulation.poses().subscribe();
  moving.simulation.run(3ms);
  const PoseFrame* frame = with->latest();
  ASSERT_EQ(frame->contacts.size(), 1u) << "those of the present step only";
  EXPECT_EQ(frame->contacts[0].force.z, 6);
  EXPECT_TRUE(without->latest()->contacts.empty());
}

// Thousands of frames against a thread that looks as fast as it can: each is of one moment, and none is older than the last.
TEST(PoseFeed, NeverShowsAMixture) {
  Moving moving;
  const auto reader = moving.simulation.poses().subscribe();
  std::atomic<bool> ended{false};
  std::thread run([&] {
    moving.simulation.run(3s);
    ended = true;
  });
  Duration last{};
  int seen = 0, mixed = 0, older = 0;
  for (bool last_look = false; !last_look;) {
    last_look = ended;
    const PoseFrame* frame = reader->latest();
    if (!frame) continue;
    ++seen;
    if (frame->time < last) ++older;
    last = frame->time;
    const double x = seconds(frame->time);
    for (std::size_t i = 1; i < 3; ++i) {
      if (frame->position[i].x != x || frame->position[i].y != 2 * x || frame->joint_position[i] != -x) ++mixed;
    }
  }
  run.join();
  EXPECT_GT(seen, 0);
  EXPECT_EQ(mixed, 0);
  EXPECT_EQ(older, 0);
  EXPECT_EQ(last, Duration(3s));
}

TEST(PoseFeed, WhoIsGoneCostsNothing) {
  Moving moving;
  auto reader = moving.simulation.poses().subscribe();
  const std::weak_ptr<PoseReader> gone = reader;
  moving.simulation.step();
  reader.reset();
  moving.simulation.step();
  EXPECT_TRUE(gone.expired());
}

}  // namespace
}  // namespace murosimf
