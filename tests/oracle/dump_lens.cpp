/// dump_lens - a lens as JSON, for lenses_against_opencv.py: where points are seen, and along which rays pixels look.
///
///     dump_lens POINTS MODEL WIDTH HEIGHT FX FY CX CY SKEW [COEFFICIENT...]
///
/// POINTS is a file of points x y z [m] in the optical frame. Pixels are those of a grid of 21 x 21 over the picture.
/// What cannot be seen, or looks nowhere, is null.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/imaging/lens.h"
#include "murosimf/model/error.h"

namespace {

using namespace murosimf;

imaging::LensSpec read_lens(const std::vector<std::string>& words) {
  const auto number = [&](std::size_t i) { return std::strtod(words.at(i).c_str(), nullptr); };
  imaging::LensSpec spec{.model = words.at(1),
                         .width = static_cast<int>(number(2)),
                         .height = static_cast<int>(number(3)),
                         .fx = number(4),
                         .fy = number(5),
                         .cx = number(6),
                         .cy = number(7)};
  spec.skew = number(8);
  for (std::size_t i = 9; i < words.size(); ++i) spec.coefficients.push_back(number(i));
  return spec;
}

std::vector<std::string> pixels_of_points(const imaging::Lens& lens, const std::string& file) {
  std::ifstream stream(file);
  std::vector<std::string> pixels;
  for (Vec3d p; stream >> p.x >> p.y >> p.z;) {
    const auto pixel = lens.project(p);
    pixels.push_back(pixel ? fmt::format("[{:.17g}, {:.17g}]", pixel->u, pixel->v) : "null");
  }
  return pixels;
}

std::vector<std::string> rays_of_pixels(const imaging::Lens& lens) {
  constexpr int steps = 20;
  std::vector<std::string> rays;
  for (int j = 0; j <= steps; ++j) {
    for (int i = 0; i <= steps; ++i) {
      const imaging::Pixel pixel{(lens.spec().width - 1.0) * i / steps, (lens.spec().height - 1.0) * j / steps};
      const auto ray = lens.ray(pixel);
      const std::string direction = ray ? fmt::format("[{:.17g}, {:.17g}, {:.17g}]", ray->x, ray->y, ray->z) : "null";
      rays.push_back(fmt::format("{{\"pixel\": [{:.17g}, {:.17g}], \"ray\": {}}}", pixel.u, pixel.v, direction));
    }
  }
  return rays;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    const imaging::Lens lens(read_lens(words));
    fmt::print("{{\"pixels\": [{}],\n \"rays\": [{}]}}\n", fmt::join(pixels_of_points(lens, words[0]), ", "),
               fmt::join(rays_of_pixels(lens), ",\n"));
  } catch (const SetupError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
