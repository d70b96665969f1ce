/// mjcf_children.h - the contents of a body of an MJCF file, with `frame` elements resolved.
///
/// A frame turns and shifts its contents, and may give them a class; it is not an object itself. Frames nest.
/// Source: MuJoCo documentation, XML reference, "frame".
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfChild {
  files::XmlElement element;
  std::string child_class;  ///< class that applies to it, from the body and frames around it
  Transformd frame;         ///< of the frames around it, in the body
};

/// All children of `body`; frames are replaced by their children; in the order of the file.
[[nodiscard]] std::vector<MjcfChild> children_in(const files::XmlElement& body, const std::string& child_class,
                                                 const MjcfDefaults& defaults, const MjcfCompiler& compiler);

/// The same without places and classes: elements with the tag `tag`.
[[nodiscard]] std::vector<files::XmlElement> elements_in(const files::XmlElement& body, std::string_view tag);

}  // namespace murosimf::robot_formats::mjcf
