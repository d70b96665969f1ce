// Sweeps: every combination once, the same table whatever has happened meanwhile.
#include "murosimf/studies/sweep.h"

#include <atomic>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/studies/chosen_results.h"
#include "murosimf/studies/statistics.h"
#include "murosimf/studies/text_table.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace studies;

SweepOptions walks(const std::string& file = {}) {
  SweepOptions options{.scene = "walk",
                       .axes = {parse_axis("walker.command=[0.1,0,0],[0.2,0,0]")},
                       .seeds = parse_seeds("1..3"),
                       .duration = 1,
                       .results = {"walker.distance", "walker.falls"}};
  options.common.threads = 2;
  options.common.cameras = false;
  if (!file.empty()) options.file = fixtures::temp_folder() / file;
  return options;
}

std::string text_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Grid, ReadsValuesAndSeeds) {
  const GridAxis axis = parse_axis("a.b=[1,2,3],4");
  EXPECT_EQ(axis.path, "a.b");
  EXPECT_EQ(axis.values, (std::vector<std::string>{"[1,2,3]", "4"}));
  EXPECT_EQ(parse_seeds("3,7..9"), (std::vector<std::uint64_t>{3, 7, 8, 9}));
  for (const char* bad : {"", "a", "=1", "a=", "a=1,,2"}) EXPECT_THROW((void)parse_axis(bad), SetupError) << bad;
  for (const char* bad : {"", "x", "1..", "5..3", "1...3", "-1", "1..99999999999", "18446744073709551615"}) {
    EXPECT_THROW((void)parse_seeds(bad), SetupError) << bad;
  }
}

TEST(Grid, HasEveryCombination) {
  const auto points = points_of({parse_axis("a=1,2"), parse_axis("b=x,y")}, {5, 6});
  ASSERT_EQ(points.size(), 8U);
  EXPECT_EQ(points[0].values, (std::vector<std::string>{"1", "x"}));
  EXPECT_EQ(points[1].seed, 6U);
  EXPECT_EQ(points[2].values, (std::vector<std::string>{"1", "y"}));
  EXPECT_EQ(points[7].values, (std::vector<std::string>{"2", "y"}));
}

// Quantiles as in every table of Student's distribution.
TEST(Statistics, IntervalIsStudents) {
  EXPECT_NEAR(student_975(1), 12.7062, 1e-4);
  EXPECT_NEAR(student_975(14), 2.14479, 1e-5);
  EXPECT_NEAR(student_975(15), 2.13145, 1e-5);
  EXPECT_NEAR(student_975(30), 2.04227, 1e-5);
  EXPECT_NEAR(student_975(1000), 1.96234, 1e-5);
  const MeanInterval interval = mean_interval({1, 2, 3, 4, std::nan("")});
  EXPECT_EQ(interval.count, 4U);
  EXPECT_EQ(interval.mean, 2.5);
  EXPECT_NEAR(interval.half, 3.18245 * std::sqrt(5.0 / 3 / 4), 1e-4);
  EXPECT_EQ(mean_interval({0.1, 0.1, 0.1}).half, 0);
  EXPECT_TRUE(std::isnan(mean_interval({7}).half));
  EXPECT_TRUE(std::isnan(mean_interval({7}).low));
  EXPECT_TRUE(std::isnan(mean_interval({}).mean));
}

// Wilson's interval: 1 of 12 and 0 of 10, worked out by hand from his formula; at both ends of the range by symmetry.
TEST(Statistics, IntervalsOfRatesStayBetween0And1AndCountsAbove0) {
  const MeanInterval one = mean_interval({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_NEAR(one.low, 0.014865, 1e-6);
  EXPECT_NEAR(one.high, 0.353880, 1e-6);
  const std::vector<double> none(10, 0.0), all(10, 1.0);
  EXPECT_EQ(mean_interval(none).low, 0);
  EXPECT_NEAR(mean_interval(none).high, 0.277533, 1e-6);
  EXPECT_NEAR(mean_interval(all).low, 1 - 0.277533, 1e-6);
  EXPECT_EQ(mean_interval(all).high, 1);
  const MeanInterval counts = mean_interval({0, 0, 3});
  EXPECT_EQ(counts.low, 0);
  EXPECT_NEAR(counts.high, 1 + 4.30265, 1e-4);
  EXPECT_LT(mean_interval({0, 0, -3}).low, -1);  // no counts
}

TEST(Sweep, SaysWhereSeedsHaveNoEffect) {
  Sweep sweep{.scene = "walk", .axes = {}, .results = {"a.distance [m]", "a.falls"}, .runs = {}};
  for (const std::uint64_t seed : {1, 2, 3}) sweep.runs.push_back({{{}, seed}, {0.5, 0}});
  const std::string text = to_text(sweep);
  EXPECT_NE(text.find("no seed makes a difference"), std::string::npos) << text;
  EXPECT_EQ(text.find("+-"), std::string::npos) << text;
  sweep.runs[1].values[0] = 0.25;
  const std::string other = to_text(sweep);
  EXPECT_EQ(other.find("no seed makes a difference"), std::string::npos) << other;
  EXPECT_NE(other.find("0.4167 +- "), std::string::npos) << other;
  EXPECT_NE(other.find("0 (0 to 0.56)"), std::string::npos) << other;  // falls: 0 of 3
}

TEST(TextTable, QuotesWhereCommasAre) {
  EXPECT_EQ(csv_line({"a", "[1,2]", "say \"x\""}), "a,\"[1,2]\",\"say \"\"x\"\"\"\n");
}

TEST(Sweep, IsTheSameForAnyNumberOfThreads) {
  SweepOptions one = walks(), many = walks();
  one.common.threads = 1;
  many.common.threads = 4;
  const Sweep result = sweep(one);
  EXPECT_EQ(to_csv(result), to_csv(sweep(many)));
  ASSERT_EQ(result.runs.size(), 6U);
  EXPECT_EQ(result.results, (std::vector<std::string>{"walker.distance [m]", "walker.falls"}));
  EXPECT_GT(result.runs[3].values[0], result.runs[0].values[0]) << "a robot with a faster command comes farther";
  // each is the run that stands alone
  scene::Scene alone("walk", {.seed = 2, .overrides = {"walker.command=[0.2,0,0]"}, .cameras = false});
  alone.simulation().run(from_seconds(1));
  EXPECT_EQ(result.runs[4].point.seed, 2U);
  EXPECT_EQ(result.runs[4].values[0], results_of(alone, one.results)[0].value);
}

// However many lines are left of its file, and wherever the last one ends.
TEST(Sweep, GoesOnWhereItWasEnded) {
  const SweepOptions options = walks("runs.txt");
  const std::string table = to_csv(sweep(options)), summary = summary_csv(sweep(options)),
                    whole = text_of(options.file);
  EXPECT_EQ(sweep(options).taken_over, 6U);
  for (const std::size_t left :
       {std::size_t{0}, std::size_t{5}, whole.find('{') + 7, whole.size() - 60, whole.size() - 3}) {
    std::ofstream(options.file, std::ios::binary) << whole.substr(0, left);
    const Sweep again = sweep(options);
    EXPECT_EQ(to_csv(again), table) << left;
    EXPECT_EQ(summary_csv(again), summary) << left;
    EXPECT_LT(again.taken_over, 6U) << left;
  }
}

TEST(Sweep, RefusesTheFileOfAnotherOne) {
  SweepOptions options = walks("other.txt");
  (void)sweep(options);
  options.duration = 0.9;
  EXPECT_THROW((void)sweep(options), SetupError);
  std::ofstream(options.file) << "something else\n";
  EXPECT_THROW((void)sweep(options), SetupError);
  EXPECT_EQ(text_of(options.file), "something else\n") << "it stays what it was";
}

TEST(Sweep, EndsWhenItIsStopped) {
  SweepOptions options = walks("stopped.txt");
  const std::string table = to_csv(sweep(walks()));
  std::atomic<bool> stop{false};
  options.common.threads = 1;
  options.common.stop = [&] { return stop.load(); };
  options.progress = [&](std::size_t done, std::size_t) { stop = done >= 2; };
  const Sweep part = sweep(options);
  EXPECT_TRUE(part.stopped);
  stop = false;
  options.progress = {};
  const Sweep rest = sweep(options);
  EXPECT_EQ(rest.taken_over, 2U);
  EXPECT_EQ(to_csv(rest), table);
}

TEST(Sweep, SaysWhatIsUnknown) {
  SweepOptions options = walks();
  options.results = {"walker.distanse"};
  EXPECT_THROW((void)sweep(options), SetupError);
  options = walks();
  options.axes = {parse_axis("walker.comand=1,2")};
  EXPECT_THROW((void)sweep(options), SetupError);
  options.axes = {parse_axis("walker.level=kinematic_walking,no_such_level")};
  EXPECT_THROW((void)sweep(options), SetupError) << "only the second value is wrong";
}

}  // namespace
}  // namespace murosimf
