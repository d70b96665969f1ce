/// mjcf_replicate.h - expands `replicate` elements of an MJCF file: their contents exist several times.
///
/// Copy i stands in a frame that is i times `offset` and `euler` away, T^i; its names end in `sep` and i, with leading zeros so that all
/// numbers have the digits of `count`. Elements of other sections that refer to a part of it (tendons, actuators, sensors, contacts, equalities)
/// are repeated as well, behind the others of their section, and their names have the same endings. Replicates nest.
/// Source: MuJoCo documentation, XML reference, "replicate"; orders and names as MuJoCo 4.0 writes such a file.
#pragma once

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"

namespace murosimf::robot_formats::mjcf {

/// Replaces all replicates below `root`, which is of the file or was opened by it, by copies. Throws SetupError for impossible counts, and more than 100,000 elements.
void expand_replicates(files::XmlFile& file, const files::XmlElement& root, const MjcfCompiler& compiler);

}  // namespace murosimf::robot_formats::mjcf
