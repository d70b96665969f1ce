#include "murosimf/logging/log_npy.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::logging {
namespace {

constexpr std::size_t before_header = 12;  // bytes: mark, version, length
constexpr std::size_t alignment = 64;      // of the data after the header

template <class T>
void append(std::string& bytes, T number) {  // little-endian
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

void append(std::string& bytes, double number) { append(bytes, std::bit_cast<std::uint64_t>(number)); }

/// A text as a literal of Python.
std::string python_text(std::string_view text) {
  std::string literal = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') literal += '\\';
    literal += c;
  }
  return literal + "'";
}

/// Every instant once, although several series have samples at it.
std::vector<Duration> instants(const std::vector<const LogSeries*>& series) {
  std::vector<Duration> times;
  for (const LogSeries* one : series) times.insert(times.end(), one->times.begin(), one->times.end());
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::string header_of(const std::vector<const LogSeries*>& series, std::size_t rows) {
  std::string header = "{'descr': [('time [s]', '<f8')";
  for (const LogSeries* one : series) {
    for (const std::string& name : one->names) header += fmt::format(", ({}, '<f8')", python_text(name));
  }
  header += fmt::format("], 'fortran_order': False, 'shape': ({},), }}", rows);
  header.append(alignment - (before_header + header.size() + 1) % alignment, ' ');
  MUROSIMF_ASSERT((before_header + header.size() + 1) % alignment == 0);
  return header + '\n';
}

/// NaN where the series has no sample at this instant: all rows of the array have the same size.
void append_row(std::string& bytes, const LogSeries& series, Duration time, std::size_t& place) {
  const std::size_t width = series.names.size();
  MUROSIMF_ASSERT(series.values.size() == series.times.size() * width);
  const bool has_row = place < series.times.size() && series.times[place] == time;
  for (std::size_t i = 0; i < width; ++i) {
    append(bytes, has_row ? series.values[place * width + i] : std::numeric_limits<double>::quiet_NaN());
  }
  if (has_row) ++place;
}

}  // namespace

std::string to_npy(const std::vector<const LogSeries*>& series) {
  const std::vector<Duration> times = instants(series);
  const std::string header = header_of(series, times.size());
  const bool is_ascii = std::ranges::none_of(header, [](char c) { return (c & 0x80) != 0; });
  std::string bytes = "\x93NUMPY";
  bytes += is_ascii ? '\x02' : '\x03';  // 2: headers of more than 65 kB; 3: in UTF-8
  bytes += '\0';
  append(bytes, static_cast<std::uint32_t>(header.size()));
  bytes += header;
  std::vector<std::size_t> places(series.size());  // next row, by series
  for (const Duration time : times) {
    append(bytes, static_cast<double>(time.count()) / 1e9);
    for (std::size_t s = 0; s < series.size(); ++s) append_row(bytes, *series[s], time, places[s]);
  }
  return bytes;
}

bool is_named_npy(const std::filesystem::path& file) { return file.extension() == ".npy"; }

}  // namespace murosimf::logging
