/// mjcf_children.h - what is inside a body of an MJCF file, with its `frame` elements resolved.
///
/// A frame turns and shifts what stands in it, and may give it a class; it is no object of its own. Frames nest.
/// Source: MuJoCo documentation, XML reference, "frame".
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfChild {
  files::XmlElement element;
  std::string child_class;  ///< that holds for it, from the body and frames around it
  Transformd frame;         ///< of the frames around it, in the body
};

/// All children of `body` but frames, whose children stand in their place; in the order of the file.
[[nodiscard]] std::vector<MjcfChild> children_in(const files::XmlElement& body, const std::string& child_class,
                                                 const MjcfDefaults& defaults, const MjcfCompiler& compiler);

/// The same without places and classes: elements called `tag`.
[[nodiscard]] std::vector<files::XmlElement> elements_in(const files::XmlElement& body, std::string_view tag);

}  // namespace murosimf::robot_formats::mjcf
