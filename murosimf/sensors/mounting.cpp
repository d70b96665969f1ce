#include "murosimf/sensors/mounting.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

int mounted_on(const Model& model, const SensorSpec& spec) {
  return spec.frame.empty() ? 0 : model.object_index(spec.frame);
}

Mounting::Mounting(Setup& setup, const SensorSpec& spec)
    : r_(setup.read(properties::position)),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      R_(setup.read(properties::orientation)) {
  const Model& model = setup.model();
  const FixedObject place = model.placement(mounted_on(model, spec));
  link_ = model.tree().links[place.link].object;
  offset_ = place.offset + place.turn * spec.position;
  turn_ = place.turn * spec.orientation;
}

}  // namespace murosimf::sensors
