/// urdf_place_writer.h - writes places as `origin` elements of a URDF file.
#pragma once

#include "murosimf/files/xml_text.h"
#include "murosimf/math/transform.h"

namespace murosimf::robot_formats::urdf {

/// Writes an `origin` in the open element; none for the identity.
void write_origin(files::XmlText& xml, const Transformd& place);

}  // namespace murosimf::robot_formats::urdf
