#include "murosimf/formats/urdf/urdf_place_writer.h"

#include <cmath>

namespace murosimf::formats::urdf {

Vec3d roll_pitch_yaw(const Mat3d& R) {
  const double yaw = std::atan2(R.x.y, R.x.x), s = std::sin(yaw), c = std::cos(yaw);
  // columns of R_z(-yaw) R = R_y(pitch) R_x(roll); its second row is (0, cos roll, -sin roll)
  const double pitch = std::atan2(-R.x.z, c * R.x.x + s * R.x.y);
  const double roll = std::atan2(s * R.z.x - c * R.z.y, c * R.y.y - s * R.y.x);
  return {roll, pitch, yaw};
}

void write_origin(files::XmlText& xml, const Transformd& place) {
  const bool turned = !is_identity(place.orientation);
  if (!turned && is_zero(place.position)) return;
  xml.begin("origin").vector("xyz", place.position);
  if (turned) xml.vector("rpy", roll_pitch_yaw(place.orientation));
  xml.end();
}

}  // namespace murosimf::formats::urdf
