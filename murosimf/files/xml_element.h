/// xml_element.h - elements of an XML file with their places, so that every message has a file and a line.
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
  /// "robot.xml": the file that contains it, or its original.
  [[nodiscard]] std::string file() const;
  /// "robot.xml:12"
  [[nodiscard]] std::string where() const;
  /// Value of an attribute; nothing if it is not there.
  [[nodiscard]] std::optional<std::string> attribute(const char* name) const;
  [[nodiscard]] std::vector<XmlAttribute> attributes() const;
  /// The text before the first element inside, without blanks around it; empty if there is none.
  [[nodiscard]] std::string text() const;
  /// The elements inside. An `include` that XmlFile has followed is replaced by the contents of its file.
  [[nodiscard]] std::vector<XmlElement> children() const;
  [[nodiscard]] std::vector<XmlElement> children(std::string_view tag) const;
  /// Throws a SetupError of one line: where, then `message`.
  [[noreturn]] void fail(std::string_view message) const;

  /// Identifies the element, for tables by element.
  [[nodiscard]] const void* id() const { return element_; }

 private:
  friend class XmlFile;

  const tinyxml2::XMLElement* element_;
  const XmlSource* source_;
};

/// A copy of an element that a reader may change, with its contents.
struct XmlTree {
  std::string tag;
  std::vector<XmlAttribute> attributes;
  XmlElement original;  ///< its source, for messages
  std::vector<XmlTree> children;

  /// Value of an attribute; null if it is not there.
  [[nodiscard]] std::string* find(std::string_view name);
  void set(const std::string& name, const std::string& value);
  /// Number of elements in all of it.
  [[nodiscard]] std::size_t size() const;
};

/// A copy of the element and its contents.
[[nodiscard]] XmlTree copy_of(const XmlElement& element);

class XmlFile {
 public:
  /// Throws SetupError if the file is missing or is not XML.
  explicit XmlFile(const std::filesystem::path& file);
  /// Parses a text instead of the file: messages give the file's name, and lines of the text.
  XmlFile(const std::filesystem::path& file, const std::string& text);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  [[nodiscard]] XmlElement root() const;

  /// Replaces each `include` element by the children of its file, in included files, too. Paths are
  /// relative to the folder of this file. Throws SetupError for a file that is missing or is included twice, so that
  /// nothing includes itself. Source: MuJoCo documentation, XML reference, "include".
  void follow_includes();

  /// The root of another file, its includes followed; valid as long as this one. Throws as both.
  [[nodiscard]] XmlElement open(const std::filesystem::path& file);

  /// Replaces an element of this file, or of one that it has opened, by `by`. Messages about it name the originals.
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
