#include "murosimf/render/software/look_values.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "murosimf/math/assert.h"

namespace murosimf::render::software {
namespace {

GroundColor ground_color(const Color& color, const Light& light) {
  return {floats(shown_in(color, brightness_upwards(light, true))),
          floats(shown_in(color, brightness_upwards(light, false)))};
}

class Numbers {
 public:
  Numbers(const Light& light, const Markings* markings) : numbers_(look_numbers(light, markings)) {}
  [[nodiscard]] float number(std::string_view name) const { return part(name, 0); }
  [[nodiscard]] std::array<float, 2> two(std::string_view name) const { return {part(name, 0), part(name, 1)}; }
  [[nodiscard]] Float3 three(std::string_view name) const { return {part(name, 0), part(name, 1), part(name, 2)}; }

 private:
  [[nodiscard]] float part(std::string_view name, std::size_t i) const {
    const auto found = std::ranges::find(numbers_, name, &LookNumber::name);
    MUROSIMF_ASSERT(found != numbers_.end() && i < found->values.size());
    return static_cast<float>(found->values[i]);
  }
  std::vector<LookNumber> numbers_;
};

}  // namespace

LookValues::LookValues(const Light& light, const Markings* markings, bool wants_fine)
    : patterns(light.patterns),
      fine(wants_fine),
      kind(light.surroundings.kind),
      background(floats(light.background)),
      floor(ground_color(light.surroundings.floor, light)),
      grass(ground_color(light.field.grass, light)),
      paint(ground_color(light.field.paint, light)),
      net(floats(shown_in(thread, brightness_upwards(light, true)))) {
  if (markings) {
    half_length = static_cast<float>(markings->half_length);
    half_width = static_cast<float>(markings->half_width);
  }
  const Numbers numbers(light, markings);
  lines_reach = numbers.two("lines_reach");
  stripe = numbers.two("stripe");
  pool = numbers.number("pool");
  haze = numbers.number("haze");
  wall_height = numbers.number("wall_height");
  for (auto& [value, name] : std::initializer_list<std::pair<Float3&, std::string_view>>{{wall, "wall"},
                                                                                         {dado, "dado"},
                                                                                         {ceiling, "ceiling"},
                                                                                         {pane, "pane"},
                                                                                         {tube, "tube"},
                                                                                         {zenith, "zenith"},
                                                                                         {horizon, "horizon"},
                                                                                         {hedge, "hedge"},
                                                                                         {sun, "sun"},
                                                                                         {sun_toward, "sun_toward"}}) {
    value = numbers.three(name);
  }
}

}  // namespace murosimf::render::software
