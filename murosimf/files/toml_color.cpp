#include "murosimf/files/toml_color.h"

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::files {

Color read_color(const TomlTable& table, const Color& otherwise) {
  Vec3d rgb{otherwise.red, otherwise.green, otherwise.blue};
  table.read("color", rgb);
  const auto fits = [](double x) { return x >= 0 && x <= 1; };
  if (!fits(rgb.x) || !fits(rgb.y) || !fits(rgb.z)) {
    throw SetupError(
        fmt::format("{}: 'color' must be three numbers from 0 to 1: red, green, blue", table.where("color")));
  }
  return {rgb.x, rgb.y, rgb.z};
}

}  // namespace murosimf::files
