/// xml_schema.h - which elements and attributes of an XML format a reader knows, and what it does with the others.
///
/// Every element and attribute of a file is one of
///   used         the reader acts on it,
///   unused       it has no effect here: named, once per kind, by `check` as a line and by `run` as a word,
///   unsupported  it would change the robot and is not supported: refused, as is what nobody knows.
/// to_text() writes the vocabulary down, `murosimf list mjcf` shows it. Tests change every attribute that is `used` and look for
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

/// What one kind of element may have.
struct XmlRule {
  XmlWords used{}, unused{}, unsupported{};                        ///< attributes
  XmlWords children{}, unused_children{}, unsupported_children{};  ///< elements inside
  bool all_act = false;  ///< whatever else is inside would act as well: refused even where unknown words are named
};

/// Rules by tag, or by "parent/tag" where that says more. An element without a rule is not looked into.
using XmlVocabulary = std::map<std::string, XmlRule, std::less<>>;

/// What becomes of words that the schema does not have.
enum class UnknownWords {
  refused,
  named,  ///< as without effect; still refused is what looks like a slip of an acting word, or acts in another place
};

/// Something that a file says and that has no effect here.
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

/// The same for a reader: appends to `warnings` what is refused if it is `lenient`, else throws SetupError for it.
[[nodiscard]] std::vector<XmlUnused> validate(const XmlElement& root, const XmlVocabulary& schema, bool lenient,
                                              std::vector<std::string>& warnings,
                                              UnknownWords unknown = UnknownWords::refused);

/// Three lines per element, of attributes and of `<elements>` inside: which act, which are named without effect, which are refused. Lines
/// without a word are left out.
[[nodiscard]] std::string to_text(const XmlVocabulary& schema);

}  // namespace murosimf::files
