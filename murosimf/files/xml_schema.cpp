#include "murosimf/files/xml_schema.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

bool contains(const XmlWords& words, std::string_view word) { return std::ranges::find(words, word) != words.end(); }

XmlWords joined(XmlWords a, const XmlWords& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Whether `name` is a misspelling of one of the words: "limmit" for "limit".
bool looks_like(std::string_view name, const XmlWords& words) {
  const std::string_view nearest = nearest_name(name, words);
  const std::size_t longer = std::max(nearest.size(), name.size()), shorter = std::min(nearest.size(), name.size());
  return !nearest.empty() && longer - shorter <= 2;
}

class Checker {
 public:
  Checker(const XmlVocabulary& schema, UnknownWords unknown) : schema_(schema), unknown_(unknown) {
    for (const auto& [element, rule] : schema) acting_.insert(rule.children.begin(), rule.children.end());
  }

  void check(const XmlElement& element, const std::string& parent = {}) {
    // A rule of "parent/tag" precedes that of the tag alone.
    auto found = schema_.find(parent + "/" + element.tag());
    if (found == schema_.end()) found = schema_.find(element.tag());
    if (found == schema_.end()) return;
    check_attributes(element, found->second);
    check_children(element, found->second);
  }

  XmlFindings findings;

 private:
  void check_attributes(const XmlElement& element, const XmlRule& rule) {
    for (const auto& [name, value] : element.attributes()) {
      const bool declares_prefix = name.starts_with("xmlns");  // name spaces have no effect in any format here
      if (contains(rule.used, name) || declares_prefix) continue;
      const auto kind = fmt::format("attribute of {}", element.tag());
      if (contains(rule.unused, name)) {
        note(element, fmt::format("{}.{}", element.tag(), name),
             fmt::format("attribute '{}' of {}", name, element.tag()));
      } else if (contains(rule.unsupported, name)) {
        refuse(element, fmt::format("attribute '{}' of {} is not supported", name, element.tag()));
      } else if (unknown_ == UnknownWords::named && !looks_like(name, rule.used)) {
        note(element, fmt::format("{}.{}", element.tag(), name),
             fmt::format("unknown attribute '{}' of {}", name, element.tag()));
      } else {
        refuse(element, unknown_name(kind, name, joined(rule.used, rule.unused)));
      }
    }
  }

  void check_children(const XmlElement& element, const XmlRule& rule) {
    const auto kind = fmt::format("element in {}", element.tag());
    for (const XmlElement& child : element.children()) {
      const std::string tag = child.tag();
      if (contains(rule.children, tag)) {
        check(child, element.tag());
      } else if (contains(rule.unused_children, tag)) {
        note(child, tag, fmt::format("element '{}'", tag));
      } else if (contains(rule.unsupported_children, tag)) {
        refuse(child, fmt::format("element '{}' is not supported", tag));
      } else if (unknown_ == UnknownWords::named && !rule.all_act && !acting_.contains(tag) &&
                 !looks_like(tag, rule.children)) {
        note(child, fmt::format("{}/{}", element.tag(), tag),
             fmt::format("unknown element '{}' in {}", tag, element.tag()));
      } else {
        refuse(child, unknown_name(kind, tag, joined(rule.children, rule.unused_children)));
      }
    }
  }

  /// Notes each kind once: a file of a thousand geoms must not give a thousand lines.
  void note(const XmlElement& at, const std::string& word, const std::string& what) {
    if (noted_.insert(what).second)
      findings.unused.push_back({one_line(word), one_line(fmt::format("{}: {} is not used", at.where(), what))});
  }

  void refuse(const XmlElement& at, const std::string& what) {
    findings.refused.push_back(one_line(fmt::format("{}: {}", at.where(), what)));
  }

  const XmlVocabulary& schema_;
  UnknownWords unknown_;
  std::set<std::string, std::less<>> acting_;  // elements that act somewhere
  std::set<std::string> noted_;
};

}  // namespace

XmlFindings validate(const XmlElement& root, const XmlVocabulary& schema, UnknownWords unknown) {
  Checker checker(schema, unknown);
  checker.check(root);
  return checker.findings;
}

std::vector<XmlUnused> validate(const XmlElement& root, const XmlVocabulary& schema, bool lenient,
                                std::vector<std::string>& warnings, UnknownWords unknown) {
  auto [unused, refused] = validate(root, schema, unknown);
  if (!refused.empty() && !lenient) {
    MUROSIMF_ASSERT(!refused.front().empty());
    const std::size_t more = refused.size() - 1;
    const std::string count = more > 0 ? fmt::format("and {} more like this; ", more) : "";
    throw SetupError(fmt::format("{} ({}--lenient reads on)", refused.front(), count));
  }
  warnings.insert(warnings.end(), refused.begin(), refused.end());
  return unused;
}

std::string to_text(const XmlVocabulary& schema) {
  std::string text;
  for (const auto& [element, rule] : schema) {
    std::string name = element;
    const auto line = [&](std::string_view what, const XmlWords& attributes, const XmlWords& elements) {
      if (attributes.empty() && elements.empty()) return;
      std::vector<std::string> words(attributes.begin(), attributes.end());
      for (const std::string_view tag : elements) words.push_back(fmt::format("<{}>", tag));
      text += fmt::format("{:<16} {:<8} {}\n", name, what, fmt::join(words, " "));
      name.clear();
    };
    line("acts", rule.used, rule.children);
    line("named", rule.unused, rule.unused_children);
    line("refused", rule.unsupported, rule.unsupported_children);
  }
  return text;
}

}  // namespace murosimf::files
