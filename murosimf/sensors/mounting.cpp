#include "murosimf/sensors/mounting.h"

#include "murosimf/model/properties.h"

namespace murosimf::sensors {

int mounted_on(const Model& model, const SensorSpec& spec) {
  return spec.frame.empty() ? 0 : model.object_index(spec.frame);
}

Mat3d true_orientation(const SensorSpec& spec) {
  const Vec3d& error = spec.mounting_error;
  // errors about the sensor's own axes: yaw, pitch, roll
  return spec.orientation * rotation_z(error.z) * rotation_y(error.y) * rotation_x(error.x);
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
  // the sensor measures at its true orientation; control software is given the nominal one
  turn_ = place.turn * true_orientation(spec);
}

}  // namespace murosimf::sensors
