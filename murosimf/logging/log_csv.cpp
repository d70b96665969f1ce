#include "murosimf/logging/log_csv.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::logging {
namespace {

using Places = std::vector<std::size_t>;  // next row, by series

std::string quoted_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + '"';
}

void append_number(std::string& text, double number) {
  if (std::isnan(number)) {
    text += "nan";  // without its sign, which has no meaning
  } else {
    fmt::format_to(std::back_inserter(text), "{}", number);
  }
}

/// Series have different rates: each row has the numbers of all that have a sample at its instant.
std::optional<Duration> earliest(const std::vector<const LogSeries*>& series, const Places& places) {
  std::optional<Duration> first;
  for (std::size_t s = 0; s < series.size(); ++s) {
    const auto& times = series[s]->times;
    if (places[s] < times.size() && (!first || times[places[s]] < *first)) first = times[places[s]];
  }
  return first;
}

/// Empty cells where the series has no sample at this instant.
void append_cells(std::string& text, const LogSeries& series, Duration time, std::size_t& place) {
  const std::size_t width = series.names.size();
  MUROSIMF_ASSERT(series.values.size() == series.times.size() * width);
  const bool has_row = place < series.times.size() && series.times[place] == time;
  for (std::size_t i = 0; i < width; ++i) {
    text += ',';
    if (has_row) append_number(text, series.values[place * width + i]);
  }
  if (has_row) ++place;
}

}  // namespace

std::string to_csv(const std::vector<const LogSeries*>& series) {
  std::string text = "time [s]";
  for (const LogSeries* one : series) {
    for (const std::string& name : one->names) text += ',' + quoted_cell(name);
  }
  text += '\n';
  Places places(series.size());
  // a merge of the series by time; equal instants share a row
  while (const auto time = earliest(series, places)) {
    append_number(text, static_cast<double>(time->count()) / 1e9);  // the quotient is the nearest double
    for (std::size_t s = 0; s < series.size(); ++s) append_cells(text, *series[s], *time, places[s]);
    text += '\n';
  }
  return text;
}

}  // namespace murosimf::logging
