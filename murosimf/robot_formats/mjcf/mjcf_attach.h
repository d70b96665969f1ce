/// mjcf_attach.h - `attach` elements of an MJCF file: a body of another file, with everything that belongs to it.
///
/// The body, or the other worldbody except its lights, replaces `attach`; meshes, materials and default classes of that
/// file, and its tendons, actuators, sensors, contacts and equalities that refer to a part of it, are added to this one. All names, those of classes
/// included, begin with `prefix`. Angles, euler sequences and autolimits are those of the other file.
/// Differs: keys of the other file are ignored, and other settings of its compiler must equal those of this file.
/// Source: MuJoCo documentation, XML reference, "attach"; orders and names as MuJoCo 4.0 writes such a file.
#pragma once

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Replaces all `attach` elements below `root`, which is of the file or was opened by it; adds the units of attached files to
/// `compiler`. Parts of the other file without effect are named in `description`. Throws SetupError: unknown model or body, an
/// error in the other file.
void attach_models(files::XmlFile& file, const files::XmlElement& root, MjcfCompiler& compiler, bool lenient,
                   robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
