/// mjcf_place_writer.h - pos and quat of an element.
#pragma once

#include "murosimf/description/robot_description.h"
#include "murosimf/files/xml_text.h"

namespace murosimf::formats::mjcf {

/// Adds them to the open element, where they are not zero and no turn.
void write_place(files::XmlText& xml, const Transformd& place);

}  // namespace murosimf::formats::mjcf
