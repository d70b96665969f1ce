/// urdf_schema.h - the elements and attributes of URDF.
///
/// Sources: URDF XML specification; XML reference of the MuJoCo documentation, "URDF extensions", for `mujoco`;
/// manual of Bullet ("PyBullet Quickstart Guide", "loadURDF") for `contact`.
/// Contents of `gazebo` blocks have their own schema (gazebo_schema.h).
#pragma once

#include "murosimf/files/xml_schema.h"

namespace murosimf::robot_formats::urdf {

[[nodiscard]] const files::XmlVocabulary& urdf_schema();

/// Throws SetupError if a file still has elements of the macro language xacro.
void refuse_xacro(const files::XmlElement& robot);

}  // namespace murosimf::robot_formats::urdf
