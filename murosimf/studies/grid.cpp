#include "murosimf/studies/grid.h"

#include <charconv>
#include <limits>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

constexpr std::size_t most_runs = 1'000'000;

/// Parts between commas outside of brackets.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '[') ++depth;
    if (c == ']') --depth;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::uint64_t parse_seed(const std::string& word, const std::string& all) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
  // Scene files have signed numbers.
  const bool fits = seed <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (error == std::errc{} && end == word.data() + word.size() && fits) return seed;
  throw SetupError(fmt::format("--seeds '{}': write numbers and ranges, like 1..20 or 3,5,8", all));
}

[[noreturn]] void refuse_many() { throw SetupError(fmt::format("more than {} runs", most_runs)); }

}  // namespace

GridAxis parse_axis(const std::string& text) {
  const auto equals = text.find('=');
  const std::string usage = fmt::format("--grid '{}': write PATH=VALUE,VALUE,..., like walker.command.0=0.1,0.2", text);
  if (equals == std::string::npos || equals == 0) throw SetupError(usage);
  GridAxis axis{.path = text.substr(0, equals), .values = split(text.substr(equals + 1))};
  for (const std::string& value : axis.values) {
    if (value.empty()) throw SetupError(usage);
  }
  return axis;
}

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  for (const std::string& part : split(text)) {
    const auto dots = part.find("..");
    const std::uint64_t first = parse_seed(part.substr(0, dots), text);
    const std::uint64_t last = dots == std::string::npos ? first : parse_seed(part.substr(dots + 2), text);
    if (last < first) throw SetupError(fmt::format("--seeds '{}': {} is after {}", text, first, last));
    if (last - first >= most_runs) refuse_many();
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
  }
  return seeds;
}

std::vector<GridPoint> points_of(const std::vector<GridAxis>& axes, const std::vector<std::uint64_t>& seeds) {
  std::vector<std::vector<std::string>> combinations(1);
  for (const GridAxis& axis : axes) {
    std::vector<std::vector<std::string>> longer;
    // Checked before they are made: they could fill the memory.
    if (combinations.size() * axis.values.size() > most_runs) refuse_many();
    for (const auto& combination : combinations) {
      for (const std::string& value : axis.values) {
        longer.push_back(combination);
        longer.back().push_back(value);
      }
    }
    combinations = std::move(longer);
  }
  if (combinations.size() * seeds.size() > most_runs) refuse_many();
  std::vector<GridPoint> points;
  for (const auto& combination : combinations) {
    for (const std::uint64_t seed : seeds) points.push_back({.values = combination, .seed = seed});
  }
  MUROSIMF_ASSERT(points.size() == combinations.size() * seeds.size());
  return points;
}

}  // namespace murosimf::studies
