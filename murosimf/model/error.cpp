#include "murosimf/model/error.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace murosimf {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // one row of the table is enough: the row above it is overwritten from the left
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replace});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  std::string_view best;
  // half of a name may be wrong, and two letters of a short one
  std::size_t best_distance = 1 + std::max<std::size_t>(2, name.size() / 2);
  for (const std::string_view candidate : candidates) {
    // 'full' for 'full_dynamics': a beginning counts as one slip
    const bool beginning = name.size() >= 3 && candidate.starts_with(name);
    const std::size_t distance = beginning ? 1 : edit_distance(name, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string_view>& candidates) {
  const std::string_view nearest = nearest_name(name, candidates);
  if (!nearest.empty()) return fmt::format("unknown {} '{}'; did you mean '{}'?", kind, name, nearest);
  if (candidates.empty()) return fmt::format("unknown {} '{}'; there is none", kind, name);
  constexpr std::size_t most = 12;
  const auto shown = std::span(candidates).first(std::min(most, candidates.size()));
  return fmt::format("unknown {} '{}'; known: {}{}", kind, name, fmt::join(shown, ", "),
                     candidates.size() > most ? ", ..." : "");
}

}  // namespace murosimf
