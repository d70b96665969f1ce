/// mjcf_names.h - names of a robot's bodies, joints and sites, collected before anything is built.
///
/// In MJCF a body and a joint may share a name; in a Model no two objects may. The joint keeps a shared name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/files/xml_element.h"

namespace murosimf::formats::mjcf {

class MjcfNames {
 public:
  /// Walks through the bodies from `base` on. Throws SetupError if two of a kind have the same name.
  /// Who has no name gets one: `body_<n>`, `<body>.joint`, `<body>.joint2`, `<body>.site`, ...
  explicit MjcfNames(const files::XmlElement& base);

  [[nodiscard]] const std::string& of(const files::XmlElement& element) const { return names_.at(element.id()); }
  /// In the order of the file.
  [[nodiscard]] const std::vector<std::string>& bodies() const { return bodies_.names; }
  [[nodiscard]] const std::vector<std::string>& joints() const { return joints_.names; }
  [[nodiscard]] const std::vector<std::string>& sites() const { return sites_.names; }
  [[nodiscard]] bool is_joint(const std::string& name) const { return joints_.lines.contains(name); }
  [[nodiscard]] bool is_body(const std::string& name) const { return bodies_.lines.contains(name); }

 private:
  struct Names {
    std::vector<std::string> names;
    std::map<std::string, int, std::less<>> lines;
  };

  void walk(const files::XmlElement& body);
  /// Names all elements of a kind inside a body.
  void name_all(const files::XmlElement& body, const char* tag, Names& names);
  void add(const files::XmlElement& element, Names& names, const std::string& otherwise);

  Names bodies_, joints_, sites_, geoms_;
  std::map<const void*, std::string> names_;
};

}  // namespace murosimf::formats::mjcf
