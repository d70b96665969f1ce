#include "murosimf/model/feet.h"

#include "murosimf/model/properties.h"

namespace murosimf {

std::vector<Foot> feet_of(const Model& model) {
  std::vector<Foot> feet;
  for (const int object : model.having(properties::sole)) {
    feet.push_back({object, model.placement(object), *model.find(properties::sole, object)});
  }
  return feet;
}

}  // namespace murosimf
