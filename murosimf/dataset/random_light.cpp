#include "murosimf/dataset/random_light.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dataset/colors.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/find_entry.h"

namespace murosimf::dataset {
namespace {

void shine(Color& lamp, double brightness, double warmth) {
  lamp = {brightness * (1 + warmth) * lamp.red, brightness * lamp.green, brightness * (1 - warmth) * lamp.blue};
}

double brightest(const Color& color) { return std::max({color.red, color.green, color.blue}); }

/// Another color about as bright: dark halls stay dark.
void paint(Color& color, Dice& dice, double most_saturation) {
  color = any_color(dice, {0, most_saturation}, {0.6 * brightest(color), std::min(1.0, 1.25 * brightest(color))});
}

void paint_all(render::Surroundings& around, Dice& dice) {
  paint(around.floor, dice, 0.5);
  paint(around.wall, dice, 0.4);
  paint(around.dado, dice, 0.8);
  paint(around.ceiling, dice, 0.2);
  paint(around.window, dice, 0.3);
  paint(around.hedge, dice, 0.5);
  const double clouds = dice.uniform();  // gray skies
  for (Color* color : {&around.zenith, &around.horizon}) {
    const double gray = (color->red + color->green + color->blue) / 3;
    const auto mix = [&](double part) { return part + clouds * (gray - part); };
    *color = {mix(color->red), mix(color->green), mix(color->blue)};
  }
}

render::FieldLook random_field(const FieldRanges& ranges, Dice& dice) {
  render::FieldLook field;
  const double hue = dice.in(ranges.hue_deg), saturation = dice.in(ranges.saturation), value = dice.in(ranges.value);
  field.grass = hsv(hue, saturation, value);
  const double paint = dice.in(ranges.paint);
  field.paint = {paint, paint, paint};
  field.stripe_width = dice.in(ranges.stripe_width);
  field.stripe_contrast = dice.in(ranges.stripe_contrast);
  return field;
}

}  // namespace

RandomLight random_light(const LightRanges& ranges, const FieldRanges& field, Dice& dice) {
  RandomLight result;
  result.preset = ranges.presets[dice.one_of(ranges.presets.size())];
  render::Light& light = result.light;
  light = find_entry(render::lights(), "light", result.preset).light;
  const double brightness = dice.in(ranges.brightness), warmth = dice.in(ranges.warmth);
  for (Color* lamp : {&light.lamp, &light.sky, &light.ground, &light.others[0].lamp, &light.others[1].lamp}) {
    shine(*lamp, brightness, warmth);
  }
  const double elevation = dice.in(ranges.elevation_deg) * pi / 180, azimuth = dice.in({0, 2 * pi});
  light.toward = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                  std::sin(elevation)};
  light.shadows = dice.chance(ranges.shadows);
  if (dice.chance(ranges.other_colors)) paint_all(light.surroundings, dice);
  light.surroundings.clear = dice.in(ranges.wall_distance);
  light.surroundings.height = dice.in(ranges.wall_height);
  light.field = random_field(field, dice);
  return result;
}

}  // namespace murosimf::dataset
