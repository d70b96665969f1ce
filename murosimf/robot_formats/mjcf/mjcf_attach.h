/// mjcf_attach.h - `attach` elements of an MJCF file: a body of another file, with all that belongs to it.
///
/// The body, or all of the other worldbody but its lights, stands in the place of `attach`; meshes, materials and default classes of that
/// file, and its actuators, sensors, contacts and equalities that name something in it, are in this one, too. All names, those of classes
/// included, begin with `prefix`. Angles, euler sequences and autolimits are those of the other file.
/// Differs: keys of the other file are not taken over, and further settings of its compiler must be those of this file.
/// Source: MuJoCo documentation, XML reference, "attach"; orders and names as MuJoCo 4.0 writes such a file.
#pragma once

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Puts such bodies in the place of all `attach` below `root`, which is of the file or was opened by it; tells `compiler` the units of
/// what comes. What the other file says without effect is named in `description`. Throws SetupError: unknown model or body, a
/// error in the other file.
void attach_models(files::XmlFile& file, const files::XmlElement& root, MjcfCompiler& compiler, bool lenient,
                   robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
