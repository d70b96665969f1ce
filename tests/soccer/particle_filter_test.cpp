// Monte Carlo localization without a camera: statistics of its parts, and a robot that is found again.
#include "murosimf/soccer/particle_filter.h"

#include <map>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/scene_file/field.h"
#include "murosimf/soccer/dead_reckoning.h"
#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::soccer {
namespace {

const Markings field = scene_file::field_markings(scene_file::kid_size_2008);

TEST(LineDistanceField, IsAsFarAsTheNearestLine) {
  const LineDistanceField table(field);
  fixtures::Dice dice("table");
  law::Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const double x = dice.uniform(-3.6, 3.6), y = dice.uniform(-2.6, 2.6);
    worst.see(std::abs(table.distance(x, y) - distance_to_lines(field, x, y)), x, y);
  }
  law::expect_below({.law = "distance to the nearest line: table against the lines themselves",
                     .level = "line table of 20 mm",
                     .source = "a distance changes by at most half a cell's diagonal"},
                    worst, 0.0142, "m");
}

TEST(LineDistanceField, KnowsPlacesByHeart) {
  EXPECT_NEAR(distance_to_lines(field, 0.3, 1), 0.3, 1e-12);      // half line
  EXPECT_NEAR(distance_to_lines(field, 2.5, 1.575), 0.4, 1e-12);  // touch line, to the middle of the line
  EXPECT_NEAR(distance_to_lines(field, 0.6 * std::cos(pi / 4), 0.6 * std::sin(pi / 4)), 0, 1e-3);  // center circle
}

TEST(LineDistanceField, NeedsLines) {
  Markings bare = field;
  bare.strokes.clear();
  EXPECT_THROW(LineDistanceField{bare}, SetupError);
  EXPECT_THROW(LineDistanceField(field, 1e-4), SetupError);
}

TEST(Planar, FramesGoThereAndBack) {
  const Vec3d pose{1, -2, 2.5}, point{0.3, 0.7, 0}, back = to_frame(pose, from_frame(pose, point));
  EXPECT_NEAR(back.x, point.x, 1e-15);
  EXPECT_NEAR(back.y, point.y, 1e-15);
  EXPECT_NEAR(from_frame({1, 2, pi / 2}, {0.5, 0, 0}).y, 2.5, 1e-15);
}

TEST(DeadReckoning, WalksACircle) {
  Vec3d pose;
  for (int i = 0; i < 1000; ++i) pose = moved(pose, step_along({0.2, 0, 0}, 2 * pi / 1000, 0.05));
  EXPECT_NEAR(pose.x, 0, 1e-9);  // chords of a closed polygon
  EXPECT_NEAR(pose.y, 0, 1e-9);
  for (int i = 0; i < 500; ++i) pose = moved(pose, step_along({0.2, 0, 0}, 2 * pi / 1000, 0.05));
  EXPECT_NEAR(pose.y, 10 / pi, 1e-4);  // the diameter of a circumference of 10 m
}

TEST(ParticleFilter, ScattersAsThePriorSays) {
  const ParticleFilter filter({.particles = 4000, .prior = {0.4, 0.2, 0.1}}, 1, "test");
  const auto particles = filter.scatter({1, -0.5, pi / 2});
  Vec3d sum, squares;
  for (const Particle& p : particles) {
    const Vec3d d = to_frame({1, -0.5, pi / 2}, {p.pose.x, p.pose.y, wrapped(p.pose.z - pi / 2)});
    sum += d;
    squares += Vec3d{d.x * d.x, d.y * d.y, d.z * d.z};
  }
  EXPECT_NEAR(sum.x / 4000, 0, 0.02);
  EXPECT_NEAR(std::sqrt(squares.x / 4000), 0.4, 0.015);
  EXPECT_NEAR(std::sqrt(squares.y / 4000), 0.2, 0.01);
  EXPECT_NEAR(std::sqrt(squares.z / 4000), 0.1, 0.005);
}

TEST(ParticleFilter, SpreadsWithTheRootOfTheWay) {
  ParticleFilter filter({.particles = 4000, .prior = {}, .way_noise = 0.06, .time_noise = {}}, 1, "test");
  auto particles = filter.scatter({});
  for (std::uint64_t i = 0; i < 100; ++i) filter.move(particles, {0.01, 0, 0}, 0.05, i);
  const PoseEstimate result = estimate(particles);
  EXPECT_NEAR(result.pose.x, 1, 0.005);
  EXPECT_NEAR(result.spread.x, 0.06, 0.003);  // after 1 m
  EXPECT_NEAR(result.spread.y, 0.06, 0.003);
}

TEST(ParticleFilter, DrawsAsOftenAsWeightsSay) {
  ParticleFilter filter({.particles = 100}, 1, "test");
  auto particles = filter.scatter({});
  for (std::size_t i = 0; i < 100; ++i) {
    particles[i].pose.x = static_cast<double>(i);
    particles[i].weight = i < 2 ? 0.305 : i < 4 ? 0.195 : 0;
  }
  ASSERT_TRUE(filter.resample(particles, 7));
  std::map<double, int> drawn;
  for (const Particle& p : particles) {
    ++drawn[p.pose.x];
    EXPECT_DOUBLE_EQ(p.weight, 0.01);
  }
  ASSERT_EQ(drawn.size(), 4u);  // low variance: within one of what the weights say
  for (const double x : {0.0, 1.0}) EXPECT_NEAR(drawn[x], 30.5, 1) << x;
  for (const double x : {2.0, 3.0}) EXPECT_NEAR(drawn[x], 19.5, 1) << x;
}

TEST(ParticleFilter, DrawsNothingFromEvenWeights) {
  ParticleFilter filter({.particles = 50}, 1, "test");
  auto particles = filter.scatter({});
  EXPECT_FALSE(filter.resample(particles, 0));
}

/// Points on the lines within 2 m, as a robot at `pose` would see them.
std::vector<LinePoint> seen_from(const Vec3d& pose, const LineDistanceField& table, fixtures::Dice& dice) {
  std::vector<LinePoint> points;
  while (points.size() < 40) {
    const Vec3d place{dice.uniform(0.3, 2), dice.uniform(-1.5, 1.5), 0}, there = from_frame(pose, place);
    if (table.distance(there.x, there.y) < 0.02) points.push_back({place, {}});
  }
  return points;
}

TEST(ParticleFilter, FindsARobotAndKeepsIt) {
  const LineDistanceField table(field);
  fixtures::Dice dice("walk");
  ParticleFilter filter({}, 1, "test");
  Vec3d pose{-1.2, 0.3, 0.2};                                      // where it is
  std::vector<Particle> particles = filter.scatter({-1.5, 0, 0});  // where it is told to be
  law::Worst place, direction;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const double turn = i < 200 ? 0.02 : -0.02;
    pose = moved(pose, {0.01, 0, turn});
    filter.move(particles, {0.011, 0, 1.05 * turn}, 0.05, i);  // odometry is 10 % and 5 % off
    filter.weigh(particles, seen_from(pose, table, dice), table);
    filter.resample(particles, i);
    if (i < 60) continue;
    const PoseEstimate result = estimate(particles);
    place.see(std::hypot(result.pose.x - pose.x, result.pose.y - pose.y), i);
    direction.see(std::abs(wrapped(result.pose.z - pose.z)), i);
  }
  const law::Statement statement{.law = "largest error of a place found from points on lines, odometry 10 % off",
                                 .level = "particle filter",
                                 .source = "the pose from which the points were made"};
  law::expect_below(statement, place, 0.15, "m");
  EXPECT_LT(law::Measured(direction).value, 0.12);
}

TEST(ParticleFilter, IsTheSameEveryTime) {
  const LineDistanceField table(field);
  const auto run = [&](std::uint64_t seed) {
    fixtures::Dice dice("walk");
    ParticleFilter filter({.particles = 100}, seed, "test");
    auto particles = filter.scatter({-1.5, 0, 0});
    for (std::uint64_t i = 0; i < 20; ++i) {
      filter.move(particles, {0.01, 0, 0.01}, 0.05, i);
      filter.weigh(particles, seen_from({-1.4, 0, 0}, table, dice), table);
      filter.resample(particles, i);
    }
    return estimate(particles).pose;
  };
  EXPECT_EQ(run(1).x, run(1).x);
  EXPECT_NE(run(1).x, run(2).x);
}

TEST(ParticleFilter, EstimatesTheHeavierOfTwoClusters) {
  std::vector<Particle> particles;
  for (int i = 0; i < 10; ++i) {
    particles.push_back({{1 + 0.01 * i, 0, pi - 0.01}, 0.03});
    particles.push_back({{1 + 0.01 * i, 0, -pi + 0.03}, 0.04});  // the same direction, over the seam
    particles.push_back({{-1, 0.01 * i, 0}, 0.03});
  }
  const PoseEstimate result = estimate(particles);
  EXPECT_NEAR(result.pose.x, 1.045, 1e-9);
  EXPECT_NEAR(wrapped(result.pose.z - pi), (0.03 * -0.01 + 0.04 * 0.03) / 0.07, 1e-9);
}

}  // namespace
}  // namespace murosimf::soccer
