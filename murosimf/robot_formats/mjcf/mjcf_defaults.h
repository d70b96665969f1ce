/// mjcf_defaults.h - default classes of an MJCF file, and the attributes of an element after they are applied.
///
/// Actuators of all kinds share their settings: a default of `position` also applies to a `general` of the class, as far as
/// that has the attribute (MuJoCo has one default actuator per class).
/// A class inherits all settings of the class around it. An element follows, in this order: its own attributes, its
/// `class`, or else the nearest `childclass` of a body around it, or else the outermost class.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/vec3.h"

namespace murosimf::robot_formats::mjcf {

/// Element of the root with the classes of attached models, which inherit nothing from those of the file.
inline constexpr const char* attached_defaults = "attached_defaults";

/// The attributes that apply to one element, its own and those of its class. Every error has file and line of
/// the place where the attribute is written.
class MjcfAttributes {
 public:
  explicit MjcfAttributes(const files::XmlElement& element) : element_(element) {}

  /// Adds those of `element`; they replace present ones.
  void overlay(const files::XmlElement& element);

  [[nodiscard]] const files::XmlElement& element() const { return element_; }
  [[nodiscard]] bool has(std::string_view name) const { return values_.contains(name); }
  /// Where the attribute is written.
  [[nodiscard]] const files::XmlElement& source(std::string_view name) const;

  [[nodiscard]] std::string text(std::string_view name, std::string_view otherwise = {}) const;
  [[nodiscard]] double number(std::string_view name, double otherwise) const;
  [[nodiscard]] Vec3d vector(std::string_view name, const Vec3d& otherwise) const;
  /// Between `least` and `most` numbers; empty if the attribute is missing.
  [[nodiscard]] std::vector<double> numbers(std::string_view name, std::size_t least, std::size_t most) const;
  /// One of `choices`, the first of which is the default.
  [[nodiscard]] std::string choice(std::string_view name, const std::vector<std::string_view>& choices) const;

 private:
  struct Value {
    std::string text;
    files::XmlElement source;
  };

  files::XmlElement element_;
  std::map<std::string, Value, std::less<>> values_;
};

class MjcfDefaults {
 public:
  /// Reads all `default` elements of the file. Throws SetupError for a class without a name or with a taken one.
  explicit MjcfDefaults(const files::XmlElement& root);

  /// The attributes of an element. `child_class`: nearest one of a body around it, empty if there is none.
  [[nodiscard]] MjcfAttributes resolve(const files::XmlElement& element, const std::string& child_class = {}) const;
  /// The settings of the element's class, outermost first; of an actuator those of all kinds.
  [[nodiscard]] std::vector<files::XmlElement> settings(const files::XmlElement& element,
                                                        const std::string& child_class = {}) const;
  /// The class that applies inside a body or worldbody, given the one around it.
  [[nodiscard]] std::string child_class(const files::XmlElement& body, const std::string& outer) const;

 private:
  using Class = std::map<std::string, std::vector<files::XmlElement>, std::less<>>;  // by tag, outermost setting first

  void read(const files::XmlElement& element, const Class& outer, bool outermost);
  void check_known(const files::XmlElement& element, const std::string& name) const;

  std::map<std::string, Class, std::less<>> classes_;
  std::string outermost_ = "main";
};

}  // namespace murosimf::robot_formats::mjcf
