// What `murosimf bench collision` prints.
#include "murosimf/scene/collision_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace murosimf::scene {
namespace {

CollisionReport report() {
  CollisionReport report;
  report.scene = "duel";
  report.robots = 2;
  report.steps = 4;
  report.naive_tests = 200;
  report.mean_volume_tests = 15;
  report.mean_object_tests = 5;
  report.worst_share = 0.12;
  report.histogram = {1, 2, 1};
  return report;
}

TEST(CollisionReport, TellsTheShareOfTheNaiveTests) { EXPECT_DOUBLE_EQ(report().mean_share(), 0.1); }

TEST(CollisionReport, DrawsTheHistogramUpToTheWorst) {
  const std::string text = to_text({report()});
  EXPECT_NE(text.find("10.0 %"), std::string::npos) << text;
  EXPECT_NE(text.find("   10 to    15 %"), std::string::npos) << text;
  EXPECT_EQ(text.find("   15 to    20 %"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '#'), 25 + 50 + 25);
}

// Widths of 1, 2 and 5 times powers of ten, never more than 20 bins; every step counts once.
TEST(CollisionReport, CountsStepsByTheirTests) {
  for (const auto& [most, bin] : {std::pair{0, 1}, {19, 1}, {20, 2}, {39, 2}, {40, 5}, {99, 5}, {100, 10}, {973, 50}}) {
    const TestHistogram histogram = histogram_of({0, most, most});
    EXPECT_EQ(histogram.bin, bin) << most;
    EXPECT_LE(histogram.steps.size(), 20U) << most;
    EXPECT_EQ(histogram.steps.back(), most > 0 ? 2 : 3) << most;
    EXPECT_EQ(std::accumulate(histogram.steps.begin(), histogram.steps.end(), std::int64_t{0}), 3) << most;
  }
}

TEST(CollisionReport, DrawsBothHistogramsOfThePaper) {
  CollisionReport both = report();
  both.volume_tests_anew = histogram_of({10, 50, 55});
  both.object_tests = histogram_of({3, 3});
  both.mean_volume_tests_anew = 35;
  const std::string text = to_text({both});
  for (const char* part : {"by their tests of volumes", "50 to    55         1 ##", "55 to    60         1 ##",
                           "by their tests of shapes", "3 to     4         2 ##", "20.0 %"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in " << text;
  }
}

TEST(CollisionReport, IsOneJsonObject) {
  const std::string json = to_json({report()});
  for (const char* part : {"\"scenes\"", "\"naive_tests\": 200", "\"mean_share\": 0.1", "\"mean_share_anew\"",
                           "\"bin\"", "\"pairs_us\""}) {
    EXPECT_NE(json.find(part), std::string::npos) << part << " is not in " << json;
  }
}

}  // namespace
}  // namespace murosimf::scene
