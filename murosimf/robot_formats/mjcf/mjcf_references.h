/// mjcf_references.h - names of some parts of an MJCF file, and the attributes of other elements that refer to them.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "murosimf/files/xml_element.h"

namespace murosimf::robot_formats::mjcf {

/// Limit of the copies of a file: more are an error of the file, not a robot.
inline constexpr std::size_t most_elements = 100'000;

class MjcfReferences {
 public:
  /// Adds the names of the element and its contents.
  void add_all(const files::XmlTree& tree);
  /// Adds the name of this element alone.
  void add(const files::XmlTree& tree);

  /// Whether an attribute of the element or of its contents refers to one of these parts.
  [[nodiscard]] bool mentioned_in(const files::XmlTree& tree) const;

  /// Puts `prefix` before and `suffix` behind the names of the element and its contents, and behind references to these parts.
  void rename(files::XmlTree& tree, const std::string& prefix, const std::string& suffix) const;

 private:
  [[nodiscard]] bool refers(const files::XmlTree& tree, const files::XmlAttribute& attribute) const;

  std::map<std::string, std::set<std::string>, std::less<>> names_;  // by kind: body, joint, geom, ...
};

}  // namespace murosimf::robot_formats::mjcf
