/// xml_schema.h - which elements and attributes of an XML format a reader knows, and what it does with the others.
///
/// Every element and attribute of a file is one of
///   used         the reader acts on it,
///   unused       it means nothing to this program: a note, once per kind,
///   unsupported  it would change the robot and is not supported: refused, as is what nobody knows.
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
};

/// Rules by tag, or by "parent/tag" where that says more. An element without a rule is not looked into.
using XmlVocabulary = std::map<std::string, XmlRule, std::less<>>;

/// Each entry is one line with file and line number.
struct XmlFindings {
  std::vector<std::string> notes, refused;
};

[[nodiscard]] XmlFindings validate(const XmlElement& root, const XmlVocabulary& schema);

/// The same for a reader: appends to `warnings` what is refused if it is `lenient`, else throws SetupError for it.
void validate(const XmlElement& root, const XmlVocabulary& schema, bool lenient, std::vector<std::string>& warnings,
              std::vector<std::string>& notes);

}  // namespace murosimf::files
