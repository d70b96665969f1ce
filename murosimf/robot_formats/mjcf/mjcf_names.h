/// mjcf_names.h - names of a robot's bodies, joints and sites, collected before anything is built, and of other objects in the file.
///
/// The world is a body of a robot that is bolted to it, and has the world's sites; its name is "world".
/// In MJCF a body and a joint may share a name; in a Model no two objects may. The joint keeps a shared name.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "murosimf/robot_formats/mjcf/mjcf_trees.h"

namespace murosimf::robot_formats::mjcf {

class MjcfNames {
 public:
  /// Visits the trees in the order of the file. Throws SetupError if two of a kind have the same name.
  /// Elements without a name get one: `body_<n>`, `<body>.joint`, `<body>.joint2`, `<body>.site`, ...
  MjcfNames(const files::XmlElement& root, const MjcfTrees& trees);

  [[nodiscard]] const std::string& of(const files::XmlElement& element) const { return names_.at(element.id()); }
  /// In the order of the file.
  [[nodiscard]] const std::vector<std::string>& bodies() const { return bodies_.names; }
  [[nodiscard]] const std::vector<std::string>& joints() const { return joints_.names; }
  [[nodiscard]] const std::vector<std::string>& sites() const { return sites_.names; }
  [[nodiscard]] bool is_joint(const std::string& name) const { return joints_.lines.contains(name); }
  [[nodiscard]] bool is_body(const std::string& name) const { return bodies_.lines.contains(name); }
  /// Whether a body, joint, geom or site is in the file, but not part of the robot; `kind` is its tag.
  [[nodiscard]] bool is_elsewhere(const std::string& kind, const std::string& name) const {
    return elsewhere_.contains({kind, name});
  }

 private:
  struct Names {
    std::vector<std::string> names;
    std::map<std::string, int, std::less<>> lines;
  };

  void walk(const files::XmlElement& body);
  void walk_elsewhere(const files::XmlElement& body);
  void name_world(const files::XmlElement& world, bool bolted);
  /// Names all elements of a kind inside a body.
  void name_all(const files::XmlElement& body, const char* tag, Names& names);
  void add(const files::XmlElement& element, Names& names, const std::string& otherwise);

  Names bodies_, joints_, sites_, geoms_;
  std::map<const void*, std::string> names_;
  std::set<std::pair<std::string, std::string>> elsewhere_;  // tag and name
};

}  // namespace murosimf::robot_formats::mjcf
