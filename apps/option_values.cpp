#include "apps/option_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::app {
namespace {

constexpr int largest_side = 8192;  // [px]

}  // namespace

PictureSize read_size(const std::string& text) {
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  bool good = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  if (good) {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    good = height.ec == std::errc{} && height.ptr == end;
  }
  if (!good || std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > largest_side) {
    throw SetupError(
        fmt::format("--size '{}': write WIDTHxHEIGHT in pixels, each from 1 to {}, like 1280x720", text, largest_side));
  }
  return size;
}

std::optional<double> read_speed(const std::string& text) {
  if (text == "max") return std::nullopt;
  double speed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), speed);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw SetupError(fmt::format("--speed '{}': write 'max' or a number (1 is real time)", text));
  }
  return speed;
}

Duration read_duration(double s) {
  if (!(s >= 0) || !std::isfinite(s)) throw SetupError(fmt::format("--duration {}: must be a number from 0", s));
  if (s > scene_file::longest_duration)
    throw SetupError(fmt::format("--duration {}: longer than simulated time can count", s));
  return from_seconds(s);
}

}  // namespace murosimf::app
