// What `murosimf bench collision` prints.
#include "murosimf/scene/collision_report.h"

#include <gtest/gtest.h>

#include <algorithm>

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
  EXPECT_NE(text.find(" 10 to  15 %"), std::string::npos) << text;
  EXPECT_EQ(text.find(" 15 to  20 %"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '#'), 25 + 50 + 25);
}

TEST(CollisionReport, IsOneJsonObject) {
  const std::string json = to_json({report()});
  for (const char* part : {"\"scenes\"", "\"naive_tests\": 200", "\"mean_share\": 0.1", "\"pairs_us\""}) {
    EXPECT_NE(json.find(part), std::string::npos) << part << " is not in " << json;
  }
}

}  // namespace
}  // namespace murosimf::scene
