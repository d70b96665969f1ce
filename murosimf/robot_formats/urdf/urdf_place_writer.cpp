#include "murosimf/robot_formats/urdf/urdf_place_writer.h"

#include "murosimf/math/roll_pitch_yaw.h"

namespace murosimf::robot_formats::urdf {

void write_origin(files::XmlText& xml, const Transformd& place) {
  const bool turned = !is_identity(place.orientation);
  if (!turned && is_zero(place.position)) return;
  xml.begin("origin").vector("xyz", place.position);
  if (turned) xml.vector("rpy", roll_pitch_yaw(place.orientation));
  xml.end();
}

}  // namespace murosimf::robot_formats::urdf
