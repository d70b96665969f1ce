/// xml_element.h - elements of an XML file that know where they stand, so that every complaint has a file and a line.
///
/// A thin view of tinyxml2, which stays out of the headers. Elements are valid as long as their XmlFile lives.
/// Numbers are plain decimals, whatever the locale; NaN and infinity are errors here.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace murosimf::files {

struct XmlAttribute {
  std::string name, value;
};

struct XmlSource;

class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement* element, const XmlSource* source) : element_(element), source_(source) {}

  [[nodiscard]] std::string tag() const;
  [[nodiscard]] int line() const;
  /// "robot.xml": the file in which it stands, or its original.
  [[nodiscard]] std::string file() const;
  /// "robot.xml:12"
  [[nodiscard]] std::string where() const;
  /// Value of an attribute; nothing if it is not there.
  [[nodiscard]] std::optional<std::string> attribute(const char* name) const;
  [[nodiscard]] std::vector<XmlAttribute> attributes() const;
  /// The text before the first element inside, without blanks around it; empty if there is none.
  [[nodiscard]] std::string text() const;
  /// An `include` that XmlFile has followed is replaced by what it brings in.
  [[nodiscard]] std::vector<XmlElement> children() const;
  [[nodiscard]] std::vector<XmlElement> children(std::string_view tag) const;
  /// Throws a SetupError of one line: where, then `message`.
  [[noreturn]] void fail(std::string_view message) const;

  /// Tells elements apart, for tables by element.
  [[nodiscard]] const void* id() const { return element_; }

 private:
  friend class XmlFile;

  const tinyxml2::XMLElement* element_;
  const XmlSource* source_;
};

/// A copy of an element that a reader may change, and what is to stand inside.
struct XmlTree {
  std::string tag;
  std::vector<XmlAttribute> attributes;
  XmlElement original;  ///< where it stands, for messages
  std::vector<XmlTree> children;

  /// Value of an attribute; null if it is not there.
  [[nodiscard]] std::string* find(std::string_view name);
  void set(const std::string& name, const std::string& value);
  /// Elements of all of it.
  [[nodiscard]] std::size_t size() const;
};

/// The element and all in it.
[[nodiscard]] XmlTree copy_of(const XmlElement& element);

class XmlFile {
 public:
  /// Throws SetupError if the file is missing or is not XML.
  explicit XmlFile(const std::filesystem::path& file);
  /// Of a text that stands for the file: messages give the file's name, and lines of the text.
  XmlFile(const std::filesystem::path& file, const std::string& text);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  [[nodiscard]] XmlElement root() const;

  /// From now on, the children of each `include` element's file stand in its place, in included files, too. Paths are
  /// relative to the folder of this file. Throws SetupError for a file that is missing or is included twice, so that
  /// nothing includes itself. Source: MuJoCo documentation, XML reference, "include".
  void follow_includes();

  /// The root of another file, its includes followed, which lives as long as this one. Throws as both.
  [[nodiscard]] XmlElement open(const std::filesystem::path& file);

  /// From now on, `by` stands in the place of an element of this file, or of one that it has opened. Messages about it name the originals.
  void replace(const XmlElement& element, const std::vector<XmlTree>& by);

 private:
  void follow_includes(XmlSource& source, const XmlElement& element, const std::filesystem::path& folder);

  std::vector<std::unique_ptr<XmlSource>> sources_;  ///< the file itself, then the included ones
};

/// `text` with line breaks and other control characters replaced by spaces: fit for a message of one line.
[[nodiscard]] std::string one_line(std::string_view text);

/// The numbers of a list like "1 -2.5 3e-4"; nothing if a part is no finite number.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(std::string_view text);

}  // namespace murosimf::files
