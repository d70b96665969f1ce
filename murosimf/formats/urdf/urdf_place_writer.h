/// urdf_place_writer.h - places as `origin` elements of a URDF file.
#pragma once

#include "murosimf/files/xml_text.h"
#include "murosimf/math/transform.h"

namespace murosimf::formats::urdf {

/// [rad] Roll, pitch and yaw about the fixed axes x, y, z: R = R_z(yaw) R_y(pitch) R_x(roll). As exact as R, also where pitch is a right
/// angle: roll is that of what is left without yaw. Source: URDF XML specification, "joint".
[[nodiscard]] Vec3d roll_pitch_yaw(const Mat3d& R);

/// An `origin` in the open element; none for the identity.
void write_origin(files::XmlText& xml, const Transformd& place);

}  // namespace murosimf::formats::urdf
