#include "murosimf/render/light.h"

#include <algorithm>
#include <cmath>

#include "murosimf/imaging/srgb.h"
#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

using Around = Surroundings::Kind;

constexpr std::array named{
    NamedLight{"hall",
               "a hall with lamps above, soft shadows' worth of light from everywhere",
               {.lamp = {0.50, 0.49, 0.46},
                .sky = {0.42, 0.43, 0.45},
                .ground = {0.17, 0.19, 0.17},
                .others = {Lamp{{0.7, 0.5, 0.7}, {0.16, 0.17, 0.18}}, Lamp{{-0.6, 0.8, 0.6}, {0.10, 0.10, 0.10}}},
                .gloss = 0.25,
                .patterns = true,
                .surroundings = {.kind = Around::hall}}},
    NamedLight{"day",
               "outdoors, the sun at the side",
               {.toward = {0.7, -0.45, 0.75},
                .lamp = {0.98, 0.93, 0.82},
                .sky = {0.38, 0.43, 0.52},
                .ground = {0.20, 0.22, 0.17},
                .background = {0.62, 0.76, 0.90},
                .gloss = 0.35,
                .patterns = true,
                .surroundings = {.kind = Around::outdoors, .floor = {0.40, 0.47, 0.30}}}},
    NamedLight{"evening",
               "outdoors, a low red sun",
               {.toward = {0.9, -0.35, 0.28},
                .lamp = {1.5, 0.86, 0.42},
                .sky = {0.27, 0.25, 0.31},
                .ground = {0.12, 0.11, 0.10},
                .background = {0.80, 0.60, 0.50},
                .gloss = 0.2,
                .patterns = true,
                .surroundings = {.kind = Around::outdoors,
                                 .floor = {0.38, 0.40, 0.27},
                                 .zenith = {0.26, 0.30, 0.47},
                                 .horizon = {0.95, 0.66, 0.44},
                                 .hedge = {0.20, 0.17, 0.17},
                                 .sun = {1.0, 0.84, 0.55}}}},
    NamedLight{"spots",
               "a dark hall with spotlights on the field",
               {.toward = {-0.5, -0.35, 0.8},
                .lamp = {0.70, 0.68, 0.64},
                .sky = {0.12, 0.12, 0.15},
                .ground = {0.06, 0.06, 0.07},
                .background = {0.05, 0.05, 0.07},
                .others = {Lamp{{0.8, -0.3, 0.7}, {0.30, 0.32, 0.38}}, Lamp{{0.1, 0.9, 0.6}, {0.32, 0.26, 0.20}}},
                .gloss = 0.5,
                .pool = 4.5,
                .patterns = true,
                .surroundings = {.kind = Around::hall,
                                 .floor = {0.25, 0.25, 0.27},
                                 .wall = {0.21, 0.21, 0.25},
                                 .dado = {0.13, 0.14, 0.18},
                                 .ceiling = {0.10, 0.10, 0.12},
                                 .window = {0.10, 0.12, 0.18},
                                 .tube = {0.30, 0.29, 0.26}}}},
    NamedLight{"night",
               "outdoors, one weak lamp in the dark",
               {.toward = {0.2, 0.5, 0.8},
                .lamp = {0.12, 0.11, 0.085},
                .sky = {0.03, 0.032, 0.045},
                .ground = {0.012, 0.013, 0.015},
                .background = {0.04, 0.045, 0.07},
                .gloss = 0.4,
                .patterns = true,
                .surroundings = {.kind = Around::outdoors,
                                 .floor = {0.40, 0.47, 0.30},
                                 .zenith = {0.02, 0.03, 0.06},
                                 .horizon = {0.07, 0.08, 0.13},
                                 .hedge = {0.02, 0.025, 0.03},
                                 .sun = {0.5, 0.5, 0.55}}}},
    NamedLight{"plain", "one lamp, an even field and nothing around it: the cheapest where the processor draws", {}},
};

double height_of(const Vec3d& toward) { return std::max(0.0, toward.z / norm(toward)); }

}  // namespace

std::span<const NamedLight> lights() { return named; }

std::array<double, 3> brightness_upwards(const Light& light, bool lit) {
  std::array<double, 3> sum{light.sky.red, light.sky.green, light.sky.blue};
  const auto add = [&](const Color& lamp, double share) {
    sum = {sum[0] + share * lamp.red, sum[1] + share * lamp.green, sum[2] + share * lamp.blue};
  };
  if (lit) add(light.lamp, height_of(light.toward));
  for (const Lamp& other : light.others) add(other.lamp, height_of(other.toward));
  return sum;
}

Color shown_in(const Color& surface, const std::array<double, 3>& brightness) {
  MUROSIMF_ASSERT(brightness[0] >= 0 && brightness[1] >= 0 && brightness[2] >= 0);
  const auto one = [](double color, double light) {
    return imaging::srgb_of_light(std::clamp(imaging::light_of_srgb(color) * light, 0.0, 1.0));
  };
  return {one(surface.red, brightness[0]), one(surface.green, brightness[1]), one(surface.blue, brightness[2])};
}

}  // namespace murosimf::render
