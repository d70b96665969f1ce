/// random_light.h - light, surroundings and field of one picture.
#pragma once

#include <string>

#include "murosimf/dataset/randomisation.h"
#include "murosimf/render/light.h"

namespace murosimf::dataset {

struct RandomLight {
  std::string preset;
  render::Light light;
};

[[nodiscard]] RandomLight random_light(const LightRanges& ranges, const FieldRanges& field, Dice& dice);

}  // namespace murosimf::dataset
