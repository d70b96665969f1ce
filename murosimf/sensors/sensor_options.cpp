#include "murosimf/sensors/sensor_options.h"

namespace murosimf::sensors {

OptionValues given_options(const SensorSpec& spec, const std::vector<OptionInfo>& options) {
  OptionValues given;
  for (const OptionInfo& option : options) {
    const auto number = spec.numbers.find(option.name);
    const auto text = spec.texts.find(option.name);
    if (number != spec.numbers.end()) {
      // files give booleans as numbers
      const bool flag = std::holds_alternative<bool>(option.fallback);
      given.emplace(option.name, flag ? OptionValue(number->second != 0) : OptionValue(number->second));
    } else if (text != spec.texts.end()) {
      given.emplace(option.name, text->second);
    }
  }
  return given;
}

}  // namespace murosimf::sensors
