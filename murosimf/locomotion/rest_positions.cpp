#include "murosimf/locomotion/rest_positions.h"

#include "murosimf/locomotion/gait_properties.h"

namespace murosimf::locomotion {

std::vector<double> rest_positions(const Model& model) {
  std::vector<double> positions(static_cast<std::size_t>(model.size()));
  for (const int joint : model.joints()) {
    if (const double* rest = model.find(properties::rest_position, joint)) positions[joint] = *rest;
  }
  return positions;
}

}  // namespace murosimf::locomotion
