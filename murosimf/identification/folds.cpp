#include "murosimf/identification/folds.h"

#include <algorithm>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

std::string group_of(const ServoLog& log, std::string_view by) {
  return by == "gain" ? fmt::format("{:g}", log.firmware_gain) : log.trajectory;
}

}  // namespace

bool has_other_trajectories(std::span<const ServoLog> logs) {
  return std::ranges::adjacent_find(logs, std::ranges::not_equal_to{}, &ServoLog::trajectory) != logs.end();
}

std::vector<Fold> folds(std::span<const ServoLog> logs, std::string_view by) {
  if (by != "trajectory" && by != "gain") throw SetupError(unknown_name("split", by, {"trajectory", "gain"}));
  std::set<std::string> groups;
  for (const ServoLog& log : logs) groups.insert(group_of(log, by));
  if (groups.size() < 2) throw SetupError(fmt::format("all logs have the same {}; nothing could be left out", by));
  std::vector<Fold> result;
  for (const std::string& group : groups) {
    Fold fold{group, {}, {}};
    for (const ServoLog& log : logs) (group_of(log, by) == group ? fold.left_out : fold.fitted).push_back(log);
    result.push_back(std::move(fold));
  }
  return result;
}

}  // namespace murosimf::identification
