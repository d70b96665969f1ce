/// mjcf_references.h - names of some parts of an MJCF file, and the attributes by which other elements mean them.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "murosimf/files/xml_element.h"

namespace murosimf::robot_formats::mjcf {

/// Of copies that a file may make: more are a slip of the pen, not a robot.
inline constexpr std::size_t most_elements = 100'000;

class MjcfReferences {
 public:
  /// The name of the element, and of all in it.
  void add_all(const files::XmlTree& tree);
  /// The name of this element alone.
  void add(const files::XmlTree& tree);

  /// Whether an attribute of the element names one of these parts.
  [[nodiscard]] bool mentioned_in(const files::XmlTree& tree) const;

  /// Puts `prefix` before and `suffix` behind the names of the element and all in it, and of these parts where they are meant.
  void rename(files::XmlTree& tree, const std::string& prefix, const std::string& suffix) const;

 private:
  [[nodiscard]] bool means(const files::XmlTree& tree, const files::XmlAttribute& attribute) const;

  std::map<std::string, std::set<std::string>, std::less<>> names_;  // by kind: body, joint, geom, ...
};

}  // namespace murosimf::robot_formats::mjcf
