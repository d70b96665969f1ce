/// sdf_schema.h - the elements and attributes of SDF: models, their contents, and the used parts of a world.
///
/// Source: SDFormat specification 1.9; of `mimic` 1.11.
#pragma once

#include "murosimf/files/xml_schema.h"

namespace murosimf::robot_formats::sdf {

[[nodiscard]] const files::XmlVocabulary& sdf_schema();

}  // namespace murosimf::robot_formats::sdf
