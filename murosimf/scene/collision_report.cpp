#include "murosimf/scene/collision_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"

namespace murosimf::scene {
namespace {

using nlohmann::json;

constexpr int bar_width = 50;

/// One line for each bin up to the last that is not empty; `width` tests or percent each.
std::string bars(const auto& steps, std::int64_t width, const std::string& unit) {
  MUROSIMF_ASSERT(std::begin(steps) != std::end(steps));
  std::size_t last = steps.size();
  while (last > 1 && steps[last - 1] == 0) --last;
  const double most = static_cast<double>(*std::max_element(steps.begin(), steps.end()));
  std::string text;
  for (std::size_t i = 0; i < last; ++i) {
    const double part = most > 0 ? static_cast<double>(steps[i]) / most : 0;
    const auto from = width * static_cast<std::int64_t>(i);
    text += fmt::format("{:>5} to {:>5}{} {:>9} {}\n", from, from + width, unit, steps[i],
                        std::string(static_cast<std::size_t>(bar_width * part), '#'));
  }
  return text;
}

std::string histograms_text(const CollisionReport& report) {
  std::string text =
      fmt::format("\n{}: steps by their share of the {} naive tests\n", report.scene, report.naive_tests);
  text += bars(report.histogram, 100 / CollisionReport::bins, " %");
  if (report.volume_tests_anew.steps.empty()) return text;
  text += fmt::format("\n{}: steps by their tests of volumes, if nothing is remembered\n", report.scene);
  text += bars(report.volume_tests_anew.steps, report.volume_tests_anew.bin, "");
  text += fmt::format("\n{}: steps by their tests of shapes\n", report.scene);
  return text + bars(report.object_tests.steps, report.object_tests.bin, "");
}

json object_of(const TestHistogram& histogram) { return {{"bin", histogram.bin}, {"steps", histogram.steps}}; }

json object_of(const CollisionReport& report) {
  return {{"scene", report.scene},
          {"robots", report.robots},
          {"steps", report.steps},
          {"naive_tests", report.naive_tests},
          {"mean_volume_tests", report.mean_volume_tests},
          {"mean_object_tests", report.mean_object_tests},
          {"mean_share", report.mean_share()},
          {"mean_volume_tests_anew", report.mean_volume_tests_anew},
          {"mean_share_anew", report.mean_share_anew()},
          {"volume_tests_anew", object_of(report.volume_tests_anew)},
          {"object_tests", object_of(report.object_tests)},
          {"worst_share", report.worst_share},
          {"histogram", report.histogram},
          {"mean_contacts", report.mean_contacts},
          {"pairs_us", report.pairs_us},
          {"ground_us", report.ground_us},
          {"step_us", report.step_us}};
}

}  // namespace

TestHistogram histogram_of(const std::vector<std::int64_t>& tests) {
  TestHistogram histogram;
  const std::int64_t most = tests.empty() ? 0 : *std::max_element(tests.begin(), tests.end());
  constexpr std::array<std::int64_t, 3> nice{1, 2, 5};
  std::int64_t power = 1;
  // the narrowest round bin width with which all counts fit into `bins` bins
  for (std::size_t i = 0; most / histogram.bin >= CollisionReport::bins; histogram.bin = power * nice[i]) {
    if (++i == nice.size()) {
      i = 0;
      power *= 10;
    }
  }
  MUROSIMF_ASSERT(most >= 0 && most / histogram.bin < CollisionReport::bins);
  histogram.steps.resize(static_cast<std::size_t>(most / histogram.bin) + 1);
  for (const std::int64_t count : tests) ++histogram.steps[static_cast<std::size_t>(count / histogram.bin)];
  return histogram;
}

std::string to_text(const std::vector<CollisionReport>& reports) {
  std::string text = fmt::format("{:<16} {:>6} {:>8} {:>8} {:>8} {:>7} {:>7} {:>8} {:>7} {:>9} {:>11} {:>11} {:>11}\n",
                                 "scene", "robots", "naive", "volumes", "objects", "share", "worst", "v. anew", "share",
                                 "contacts", "pairs", "ground", "step");
  for (const CollisionReport& r : reports) {
    text += fmt::format(
        "{:<16} {:>6} {:>8} {:>8.1f} {:>8.1f} {:>5.1f} % {:>5.1f} % {:>8.1f} {:>5.1f} % {:>9.1f} {:>8.2f} us {:>8.2f} "
        "us {:>8.1f} us\n",
        r.scene, r.robots, r.naive_tests, r.mean_volume_tests, r.mean_object_tests, 100 * r.mean_share(),
        100 * r.worst_share, r.mean_volume_tests_anew, 100 * r.mean_share_anew(), r.mean_contacts, r.pairs_us,
        r.ground_us, r.step_us);
  }
  if (!reports.empty()) text += histograms_text(reports.front());
  return text;
}

std::string to_json(const std::vector<CollisionReport>& reports) {
  json scenes = json::array();
  for (const CollisionReport& report : reports) scenes.push_back(object_of(report));
  return files::json_text({{"schema", files::json_schema("bench")}, {"scenes", std::move(scenes)}});
}

}  // namespace murosimf::scene
