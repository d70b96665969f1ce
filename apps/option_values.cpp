#include "apps/option_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/render/light.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::app {
namespace {

constexpr int largest_side = 8192;  // [px]

}  // namespace

std::optional<PictureSize> size_in(const std::string& text) {
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  const bool good = height.ec == std::errc{} && height.ptr == end;
  if (!good || std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > largest_side)
    return std::nullopt;
  return size;
}

PictureSize read_size(const std::string& text) {
  if (const auto size = size_in(text)) return *size;
  throw SetupError(
      fmt::format("--size '{}': write WIDTHxHEIGHT in pixels, each from 1 to {}, like 1280x720", text, largest_side));
}

void check_rates(double fps, double slow) {
  if (!(fps >= 1 && fps <= 240)) throw SetupError(fmt::format("--fps {}: must be from 1 to 240", fps));
  if (!(slow >= 0.01 && slow <= 1000)) {
    throw SetupError(fmt::format("--slow {}: must be from 0.01 to 1000; 1 shows things as fast as they are", slow));
  }
}

void check_light(const std::string& name) {
  std::vector<std::string_view> names;
  for (const render::NamedLight& light : render::lights()) names.push_back(light.name);
  if (std::ranges::find(names, name) != names.end()) return;
  throw SetupError("--light: " + unknown_name("light", name, names));
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
