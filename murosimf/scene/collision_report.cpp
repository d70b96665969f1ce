#include "murosimf/scene/collision_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"

namespace murosimf::scene {
namespace {

using nlohmann::json;

constexpr int bar_width = 50;

std::string histogram_text(const CollisionReport& report) {
  std::string text =
      fmt::format("\n{}: steps by their share of the {} naive tests\n", report.scene, report.naive_tests);
  int last = CollisionReport::bins - 1;
  while (last > 0 && report.histogram[last] == 0) --last;
  const double most = static_cast<double>(*std::max_element(report.histogram.begin(), report.histogram.end()));
  for (int i = 0; i <= last; ++i) {
    const double part = most > 0 ? static_cast<double>(report.histogram[i]) / most : 0;
    text += fmt::format("{:>3} to {:>3} % {:>9} {}\n", 5 * i, 5 * (i + 1), report.histogram[i],
                        std::string(static_cast<std::size_t>(bar_width * part), '#'));
  }
  return text;
}

json object_of(const CollisionReport& report) {
  return {{"scene", report.scene},
          {"robots", report.robots},
          {"steps", report.steps},
          {"naive_tests", report.naive_tests},
          {"mean_volume_tests", report.mean_volume_tests},
          {"mean_object_tests", report.mean_object_tests},
          {"mean_share", report.mean_share()},
          {"worst_share", report.worst_share},
          {"histogram", report.histogram},
          {"mean_contacts", report.mean_contacts},
          {"pairs_us", report.pairs_us},
          {"ground_us", report.ground_us},
          {"step_us", report.step_us}};
}

}  // namespace

std::string to_text(const std::vector<CollisionReport>& reports) {
  std::string text =
      fmt::format("{:<16} {:>6} {:>8} {:>8} {:>8} {:>7} {:>7} {:>9} {:>11} {:>11} {:>11}\n", "scene", "robots", "naive",
                  "volumes", "objects", "share", "worst", "contacts", "pairs", "ground", "step");
  for (const CollisionReport& r : reports) {
    text += fmt::format(
        "{:<16} {:>6} {:>8} {:>8.1f} {:>8.1f} {:>5.1f} % {:>5.1f} % {:>9.1f} {:>8.2f} us {:>8.2f} us {:>8.1f} us\n",
        r.scene, r.robots, r.naive_tests, r.mean_volume_tests, r.mean_object_tests, 100 * r.mean_share(),
        100 * r.worst_share, r.mean_contacts, r.pairs_us, r.ground_us, r.step_us);
  }
  if (!reports.empty()) text += histogram_text(reports.front());
  return text;
}

std::string to_json(const std::vector<CollisionReport>& reports) {
  json scenes = json::array();
  for (const CollisionReport& report : reports) scenes.push_back(object_of(report));
  return files::json_text({{"schema", files::json_schema("bench")}, {"scenes", std::move(scenes)}});
}

}  // namespace murosimf::scene
