/// xml_schema.h - the elements and attributes of an XML format that a reader uses, and the treatment of others.
///
/// Every element and attribute of a file is one of
///   used         the reader acts on it,
///   unused       it has no effect here: named, once per kind, by `check` as a line and by `run` as a word,
///   unsupported  it would change the robot and is not supported: refused, as are unknown words.
/// to_text() prints the vocabulary, `murosimf list mjcf` shows it. Tests change every attribute that is `used` and look for
/// the difference (tests/robot_formats/mjcf/mjcf_acts_test.cpp).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/files/xml_element.h"

namespace murosimf::files {

using XmlWords = std::vector<std::string_view>;

/// Attributes and children of one kind of element.
struct XmlRule {
  XmlWords used{}, unused{}, unsupported{};                        ///< attributes
  XmlWords children{}, unused_children{}, unsupported_children{};  ///< elements inside
  bool all_act = false;  ///< any other element inside would act as well: refused even where unknown words are named
};

/// Rules by tag, or by "parent/tag" where that is more specific. Elements without a rule are not examined.
using XmlVocabulary = std::map<std::string, XmlRule, std::less<>>;

/// Treatment of words that the schema does not have.
enum class UnknownWords {
  refused,
  named,  ///< as without effect; misspellings of acting words, and words that act in another place, are still refused
};

/// A part of a file that has no effect here.
struct XmlUnused {
  std::string word;  ///< "geom.condim", or "option" for an element
  std::string line;  ///< "robot.xml:12: attribute 'condim' of geom is not used"
};

struct XmlFindings {
  std::vector<XmlUnused> unused;
  std::vector<std::string> refused;  ///< one line each, with file and line number
};

[[nodiscard]] XmlFindings validate(const XmlElement& root, const XmlVocabulary& schema,
                                   UnknownWords unknown = UnknownWords::refused);

/// The same for a reader: appends refused words to `warnings` if it is `lenient`, else throws SetupError for them.
[[nodiscard]] std::vector<XmlUnused> validate(const XmlElement& root, const XmlVocabulary& schema, bool lenient,
                                              std::vector<std::string>& warnings,
                                              UnknownWords unknown = UnknownWords::refused);

/// Three lines per element, of attributes and of `<elements>` inside: acting ones, ones that are named without effect, refused ones. Lines
/// without a word are omitted.
[[nodiscard]] std::string to_text(const XmlVocabulary& schema);

}  // namespace murosimf::files
