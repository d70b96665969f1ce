// A search that is ended anywhere goes on as if it had not been, and refuses the states of others.
#include "murosimf/studies/cost_search.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::studies {
namespace {

using Points = std::vector<std::vector<double>>;

/// Least, -1.5, at (0.25, 0.75, 0).
std::vector<double> bowls(const Points& points) {
  std::vector<double> costs;
  for (const auto& x : points)
    costs.push_back(std::pow(x[0] - 0.25, 2) + 2 * std::pow(x[1] - 0.75, 2) + std::abs(x[2]) - 1.5);
  return costs;
}

CostSearchOptions small_search(std::size_t evaluations, const std::string& file = {}) {
  CostSearchOptions options{.space = {.start = {0, 0, 0.5}, .low = {0, 0, 0}, .high = {1, 1, 1}, .population = 8}};
  options.first = {{1, 1, 1}, {0.2, 0.5, 0.5}};
  options.evaluations = evaluations;
  if (!file.empty()) options.state = fixtures::temp_folder() / file;
  options.what = "bowls";
  return options;
}

TEST(CostSearch, FindsTheLeastAndCountsWhatItTook) {
  const CostSearch found = search_cost(small_search(500), bowls);
  EXPECT_NEAR(found.best_cost, -1.5, 1e-3);
  EXPECT_NEAR(found.best[0], 0.25, 0.03);
  EXPECT_EQ(found.start, (std::vector<double>{0, 0, 0.5}));
  EXPECT_EQ(found.start_cost, bowls({found.start})[0]);
  EXPECT_EQ(found.generations, (500u - 3 - 1) / 8) << "three points first, and the middle at the end";
  EXPECT_EQ(found.evaluations, 3 + 8 * found.generations + 1);
  EXPECT_FALSE(found.stopped);
}

TEST(CostSearch, BeginsWithTheBestOfTheFirst) {
  Points second;
  int calls = 0;
  (void)search_cost(small_search(12), [&](const Points& points) {
    if (++calls == 2) second = points;
    return bowls(points);
  });
  double middle = 0;
  for (const auto& x : second) middle += x[0] / static_cast<double>(second.size());
  EXPECT_LT(std::abs(middle - 0.2), std::abs(middle - 1.0)) << "(0.2, 0.5, 0.5) is the best of the three";
}

TEST(CostSearch, GoesOnAsIfItHadNotBeenEnded) {
  const CostSearch through = search_cost(small_search(200), bowls);
  // ended in the middle of a generation, as by kill -9: what the costs had become then is lost
  struct Killed {};
  int calls = 0;
  const auto killed = [&](const Points& points) {
    if (++calls == 8) throw Killed();
    return bowls(points);
  };
  EXPECT_THROW((void)search_cost(small_search(200, "killed.state"), killed), Killed);
  const CostSearch on = search_cost(small_search(200, "killed.state"), bowls);
  EXPECT_EQ(on.taken_over, 3u + 6 * 8);
  EXPECT_EQ(on.best, through.best);
  EXPECT_EQ(on.best_cost, through.best_cost);
  EXPECT_EQ(on.start_cost, through.start_cost);
  EXPECT_EQ(on.evaluations, through.evaluations);
  EXPECT_EQ(on.generations, through.generations);
}

TEST(CostSearch, StopsWithTheBestSoFar) {
  CostSearchOptions options = small_search(1000, "stopped.state");
  int calls = 0;
  options.stop = [&] { return calls >= 5; };
  const auto counted = [&](const Points& points) {
    ++calls;
    return calls > 4 ? std::vector<double>{} : bowls(points);
  };
  const CostSearch found = search_cost(options, counted);
  EXPECT_TRUE(found.stopped);
  EXPECT_EQ(found.evaluations, 3u + 3 * 8);
  EXPECT_LT(found.best_cost, found.start_cost);
  options.stop = {};
  options.evaluations = 100;
  EXPECT_EQ(search_cost(options, bowls).best, search_cost(small_search(100), bowls).best);
}

TEST(CostSearch, EndsByTime) {
  CostSearchOptions options = small_search(1000);
  options.minutes = 0;
  const CostSearch found = search_cost(options, bowls);
  EXPECT_EQ(found.generations, 0u);
  EXPECT_EQ(found.best, (std::vector<double>{0.2, 0.5, 0.5})) << "of the first ones, which are tried in any case";
}

std::string refusal(const CostSearchOptions& options) {
  try {
    (void)search_cost(options, bowls);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(CostSearch, RefusesStatesOfOthers) {
  (void)search_cost(small_search(50, "others.state"), bowls);
  CostSearchOptions other = small_search(50, "others.state");
  other.what = "bowls of another program";
  EXPECT_NE(refusal(other).find("others.state: it is of another search"), std::string::npos) << refusal(other);
  const auto file = fixtures::temp_folder() / "wrong.state";
  for (const char* text : {"", "x = 1", "[]", "{\"kind\": 3}"}) {
    std::ofstream(file) << text;
    EXPECT_NE(refusal(small_search(50, "wrong.state")).find("it is no state of a search"), std::string::npos) << text;
  }
  for (const char* text : {R"({"kind": "MuRoSimF search 1", "what": "bowls"})",
                           R"({"kind": "MuRoSimF search 1", "what": "bowls", "evaluations": "many"})"}) {
    std::ofstream(file) << text;
    EXPECT_NE(refusal(small_search(50, "wrong.state")).find("damaged"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace murosimf::studies
