// What a sweep has shown, as tables.
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/studies/statistics.h"
#include "murosimf/studies/sweep.h"
#include "murosimf/studies/text_table.h"

namespace murosimf::studies {
namespace {

/// The runs of one combination of values.
struct Group {
  std::vector<std::string> values;
  std::vector<const SweepRun*> runs;  // that have been done
};

std::vector<Group> groups_of(const Sweep& sweep) {
  std::vector<Group> groups;
  // The seed changes before the values: runs of one combination follow each other.
  for (const SweepRun& run : sweep.runs) {
    if (groups.empty() || groups.back().values != run.point.values) groups.push_back({run.point.values, {}});
    if (!run.values.empty()) groups.back().runs.push_back(&run);
  }
  return groups;
}

/// Whether no two runs of any combination differ in any result, and there are two of one.
bool seeds_do_nothing(const std::vector<Group>& groups) {
  bool compared = false;
  for (const Group& group : groups) {
    for (const SweepRun* run : group.runs) {
      const bool same = std::ranges::equal(run->values, group.runs[0]->values, [](double a, double b) {
        return a == b || (std::isnan(a) && std::isnan(b));
      });
      if (!same) return false;
      compared = compared || run != group.runs[0];
    }
  }
  return compared;
}

std::string cell_of(const MeanInterval& interval, bool alone) {
  if (alone || interval.count < 2) return fmt::format("{:.4g}", interval.mean);
  const double below = interval.mean - interval.low, above = interval.high - interval.mean;
  if (std::abs(above - below) > 1e-9 * above) {
    return fmt::format("{:.4g} ({:.2g} to {:.2g})", interval.mean, interval.low, interval.high);
  }
  return fmt::format("{:.4g} +- {:.2g}", interval.mean, interval.half);
}

MeanInterval interval_of(const Group& group, std::size_t result) {
  MUROSIMF_ASSERT(group.runs.empty() || result < group.runs.front()->values.size());
  std::vector<double> values;
  for (const SweepRun* run : group.runs) values.push_back(run->values[result]);
  return mean_interval(values);
}

bool is_number(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::string to_text(const Sweep& sweep) {
  TextTable table;
  std::vector<std::string> head = sweep.axes;
  head.emplace_back("runs");
  head.insert(head.end(), sweep.results.begin(), sweep.results.end());
  table.add(head);
  const std::vector<Group> groups = groups_of(sweep);
  const bool without_chance = seeds_do_nothing(groups);
  for (const Group& group : groups) {
    std::vector<std::string> row = group.values;
    row.push_back(fmt::format("{}", group.runs.size()));
    for (std::size_t i = 0; i < sweep.results.size(); ++i) {
      row.push_back(cell_of(interval_of(group, i), without_chance));
    }
    table.add(row);
  }
  std::string text = table.text();
  if (without_chance) text += "no seed makes a difference to these results: nothing in the scene is left to chance\n";
  return text;
}

std::string to_csv(const Sweep& sweep) {
  std::string text = csv_line([&] {
    std::vector<std::string> head{"run"};
    head.insert(head.end(), sweep.axes.begin(), sweep.axes.end());
    head.emplace_back("seed");
    head.insert(head.end(), sweep.results.begin(), sweep.results.end());
    return head;
  }());
  for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
    const SweepRun& run = sweep.runs[i];
    if (run.values.empty()) continue;
    std::vector<std::string> cells{fmt::format("{}", i)};
    cells.insert(cells.end(), run.point.values.begin(), run.point.values.end());
    cells.push_back(fmt::format("{}", run.point.seed));
    for (const double value : run.values) cells.push_back(fmt::format("{}", value));
    text += csv_line(cells);
  }
  return text;
}

std::string summary_csv(const Sweep& sweep) {
  const std::vector<Group> groups = groups_of(sweep);
  // only numbers can be drawn: axes of others are left out, and the combinations have numbers if none is left
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    if (std::ranges::all_of(groups, [a](const Group& group) { return is_number(group.values[a]); })) axes.push_back(a);
  }
  std::vector<std::string> head;
  for (const std::size_t a : axes) head.push_back(sweep.axes[a]);
  if (axes.empty()) head.emplace_back("combination");
  head.emplace_back("runs");
  for (const std::string& name : sweep.results) {
    const auto unit = std::min(name.find(" ["), name.size());
    for (const char* what : {".mean", ".low", ".high"}) head.push_back(name.substr(0, unit) + what + name.substr(unit));
  }
  std::string text = csv_line(head);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::vector<std::string> cells;
    for (const std::size_t a : axes) cells.push_back(groups[g].values[a]);
    if (axes.empty()) cells.push_back(fmt::format("{}", g));
    cells.push_back(fmt::format("{}", groups[g].runs.size()));
    for (std::size_t i = 0; i < sweep.results.size(); ++i) {
      const MeanInterval one = interval_of(groups[g], i);
      for (const double value : {one.mean, one.low, one.high}) {
        cells.push_back(fmt::format("{}", value));
      }
    }
    text += csv_line(cells);
  }
  return text;
}

std::string to_json(const Sweep& sweep) {
  nlohmann::json runs = nlohmann::json::array(), summary = nlohmann::json::array();
  for (const SweepRun& run : sweep.runs) {
    if (run.values.empty()) continue;
    runs.push_back({{"values", run.point.values}, {"seed", run.point.seed}, {"results", run.values}});
  }
  for (const Group& group : groups_of(sweep)) {
    nlohmann::json results = nlohmann::json::array();
    for (std::size_t i = 0; i < sweep.results.size(); ++i) {
      const MeanInterval one = interval_of(group, i);
      results.push_back({{"count", one.count},
                         {"mean", one.mean},
                         {"half_95", one.half},
                         {"low_95", one.low},
                         {"high_95", one.high}});
    }
    summary.push_back({{"values", group.values}, {"runs", group.runs.size()}, {"results", results}});
  }
  const bool without_chance = seeds_do_nothing(groups_of(sweep));
  return files::json_text({{"schema", files::json_schema("sweep")},
                           {"scene", sweep.scene},
                           {"axes", sweep.axes},
                           {"results", sweep.results},
                           {"seeds_differ", !without_chance},
                           {"runs", runs},
                           {"summary", summary}});
}

}  // namespace murosimf::studies
