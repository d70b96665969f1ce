/// urdf_vocabulary.h - the elements and attributes of URDF.
///
/// Sources: URDF XML specification; XML reference of the MuJoCo documentation, "URDF extensions", for `mujoco`.
/// Contents of `gazebo` blocks are urdf_gazebo.h's.
#pragma once

#include "murosimf/files/xml_vocabulary.h"

namespace murosimf::formats::urdf {

[[nodiscard]] const files::XmlVocabulary& urdf_vocabulary();

/// Throws SetupError if a file still has elements of the macro language xacro.
void refuse_xacro(const files::XmlElement& robot);

}  // namespace murosimf::formats::urdf
