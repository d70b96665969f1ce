// How sure verdicts are: what follows from shares of seeds, and scenes with and without chance.
#include "murosimf/studies/compare_seeds.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "murosimf/model/error.h"
#include "tests/written_scene.h"

namespace murosimf::studies {
namespace {

studies::MeanInterval share(int adequate, int seeds) {
  std::vector<double> cases(static_cast<std::size_t>(seeds), 0);
  std::fill(cases.begin(), cases.begin() + adequate, 1);
  return studies::mean_interval(cases);
}

Judgement judged(int adequate, int seeds) { return judgement(share(adequate, seeds), nullptr); }

// Wilson's interval of n of n ends at n / (n + z^2), z^2 = 3.84: four seeds are just enough.
TEST(CompareSeeds, MoreThanHalfOfAllSeedsWithConfidence) {
  EXPECT_EQ(judged(4, 4), Judgement::adequate);
  EXPECT_EQ(judged(3, 3), Judgement::undecided);
  EXPECT_EQ(judged(0, 4), Judgement::not_adequate);
  EXPECT_EQ(judged(0, 3), Judgement::undecided);
  EXPECT_EQ(judged(8, 10), Judgement::undecided) << "49 to 94 %";
  EXPECT_EQ(judged(9, 10), Judgement::adequate) << "60 to 98 %";
  EXPECT_EQ(judged(5, 10), Judgement::undecided);
  EXPECT_EQ(judged(1, 10), Judgement::not_adequate) << "2 to 40 %";
  EXPECT_EQ(judged(1, 1), Judgement::adequate) << "one seed says what one run says";
  EXPECT_EQ(judged(0, 1), Judgement::not_adequate);
}

TEST(CompareSeeds, TheReferenceItselfIsTheYardstick) {
  const studies::MeanInterval often = share(18, 20), seldom = share(4, 20), never = share(0, 20);
  EXPECT_EQ(judgement(share(4, 20), &often), Judgement::not_adequate);
  EXPECT_EQ(judgement(share(4, 20), &seldom), Judgement::adequate) << "as often as the reference with its own servos";
  EXPECT_EQ(judgement(share(3, 20), &seldom), Judgement::undecided);
  EXPECT_EQ(judgement(share(0, 200), &seldom), Judgement::not_adequate);
  EXPECT_EQ(judgement(share(0, 20), &never), Judgement::undecided) << "nothing is known of a scene like that";
}

CompareOptions experiment(const std::string& scene, const std::string& entity, double end) {
  CompareOptions options;
  options.scene = scene;
  options.entity = entity;
  options.end = end;
  options.repeat = 0;
  options.levels = {"kinematic_walking", "articulated_dynamics"};
  return options;
}

TEST(CompareSeeds, SeedsWithoutEffectCountAsOne) {
  const SeedsComparison s = compare_seeds(experiment("push", "robot", 1), 3, {});
  EXPECT_FALSE(s.seeds_differ);
  EXPECT_EQ(s.seeds(), 3U);
  EXPECT_EQ(s.levels[0].share.count, 1U);
  EXPECT_EQ(s.levels[0].judgement, Judgement::not_adequate);
  EXPECT_NE(summary(s).find("seeds had no effect: all runs of a level are the same, and count as one\n"),
            std::string::npos);
}

// A robot starts at another place for each seed, and stands there at every level.
TEST(CompareSeeds, SeedsThatDifferCountEach) {
  const std::string scene = fixtures::write_scene(
      "[start]\njitter_position = 0.3\n[[robots]]\nname = \"robot\"\nmodel = \"kid21\"\n"
      "level = \"articulated_dynamics\"\ncommand = [0, 0, 0]\n");
  const SeedsComparison s = compare_seeds(experiment(scene, "robot", 0.3), 5, {});
  EXPECT_TRUE(s.seeds_differ);
  EXPECT_EQ(s.levels[0].share.count, 5U);
  EXPECT_EQ(s.levels[0].judgement, Judgement::adequate) << "it stands somewhere, at every level";
  EXPECT_EQ(s.verdict, "kinematic_walking is adequate");
  EXPECT_NE(summary(s).find("adequate: in 5 of 5 seeds (100 %, 57 to 100 % of all with a confidence of 95 %)"),
            std::string::npos)
      << summary(s);
}

TEST(CompareSeeds, ServosVaryBySeedAndAsMuchAsAllowed) {
  CompareOptions options = experiment("walk", "walker", 1.5);
  options.servo_tolerance = 0.2;
  const SeedsComparison s = compare_seeds(options, 2, {}), again = compare_seeds(options, 2, {});
  ASSERT_EQ(s.yardstick.size(), 1U);
  EXPECT_EQ(s.yardstick[0].adequate.size(), 2U);
  EXPECT_EQ(s.yardstick[0].name, "articulated_dynamics with the model's servos");
  EXPECT_FALSE(s.seeds_differ) << "apart from servos";
  const auto end = [](const CompareEntry& e) { return e.measures.end.x; };
  const auto& reference = s.first.entries[s.first.reference];
  EXPECT_EQ(end(reference), end(again.first.entries[s.first.reference]));
  EXPECT_NE(end(reference), end(*s.first.as_modeled));
  EXPECT_GT(s.first.as_modeled->deviations.center_max, 0);
  EXPECT_LT(s.first.as_modeled->deviations.center_max, 0.05) << "not by very much in 1.5 s";
  options.servo_tolerance = 0;
  const SeedsComparison plain = compare_seeds(options, 1, {});
  EXPECT_TRUE(plain.yardstick.empty());
  EXPECT_EQ(end(plain.first.entries[plain.first.reference]), end(*s.first.as_modeled)) << "as the model has them";
  options.servo_tolerance = 1e-9;
  const SeedsComparison tiny = compare_seeds(options, 4, {});
  EXPECT_EQ(tiny.yardstick[0].share.mean, 1) << "servos that are known: the reference is itself";
}

TEST(CompareSeeds, ServosNeedALevelThatHasThem) {
  CompareOptions options = experiment("walk", "walker", 0.1);
  options.levels = {"kinematic_walking", "full_dynamics"};
  options.servo_tolerance = 0.1;
  EXPECT_THROW(static_cast<void>(compare_seeds(options, 1, {})), SetupError);
}

TEST(CompareSeeds, EndWithTheLargest) {
  CompareOptions options = experiment("push", "robot", 0.01);
  options.seed = std::numeric_limits<std::int64_t>::max() - 1;
  EXPECT_EQ(compare_seeds(options, 2, {}).seeds(), 2U);
  EXPECT_THROW(static_cast<void>(compare_seeds(options, 3, {})), SetupError);
}

TEST(CompareSeeds, EndWhenTheyAreStopped) {
  CompareOptions options = experiment("push", "robot", 0.2);
  int asked = 0;
  options.stop = [&] { return ++asked > 40; };
  const SeedsComparison s = compare_seeds(options, 1000, {});
  EXPECT_TRUE(s.stopped);
  EXPECT_LT(s.seeds(), 1000U);
}

}  // namespace
}  // namespace murosimf::studies
