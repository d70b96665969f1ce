#include "murosimf/robot/finding_groups.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"

namespace murosimf::robot {
namespace {

constexpr std::size_t shown_names = 3;
constexpr std::string_view unused = " is not used", guess = "guessed: ";

bool is_part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// From an opening quote to its closing one, both included; empty if there is none. A quote directly after a letter or digit does not open,
/// one directly before a letter or digit does not close: those are apostrophes.
std::string_view next_quoted(std::string_view text) {
  for (std::size_t begin = text.find('\''); begin != std::string_view::npos; begin = text.find('\'', begin + 1)) {
    if (begin > 0 && is_part_of_word(text[begin - 1])) continue;
    std::size_t end = text.find('\'', begin + 1);
    while (end < text.size() && end + 1 < text.size() && is_part_of_word(text[end + 1])) end = text.find('\'', end + 1);
    if (end != std::string_view::npos) return text.substr(begin, end + 1 - begin);
  }
  return {};
}

/// "'a' and 'b'": the first two quoted names.
std::string quoted_names(std::string_view what) {
  std::vector<std::string_view> names;
  for (std::string_view name = next_quoted(what); !name.empty() && names.size() < 2; name = next_quoted(what)) {
    names.push_back(name);
    MUROSIMF_ASSERT(name.data() >= what.data() && name.data() + name.size() <= what.data() + what.size());
    what.remove_prefix(static_cast<std::size_t>(name.data() + name.size() - what.data()));
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

/// The text without quoted names.
std::string without_names(std::string_view what) {
  std::string rest;
  for (std::string_view name = next_quoted(what); !name.empty(); name = next_quoted(what)) {
    const auto begin = static_cast<std::size_t>(name.data() - what.data());
    MUROSIMF_ASSERT(begin + name.size() <= what.size());
    rest += what.substr(0, begin);
    what.remove_prefix(begin + name.size());
  }
  return rest.append(what);
}

bool is_guessed_name(std::string_view what) {
  return what.starts_with(guess) && what.ends_with('\'') && what.find(" is '") != std::string_view::npos;
}

/// The text without quoted names, and without words that contain digits.
std::string without_details(std::string_view what) {
  std::string kind, word;
  bool has_digit = false;
  for (const char c : without_names(what)) {
    has_digit = has_digit || std::isdigit(static_cast<unsigned char>(c)) != 0;
    word += c;
    if (c != ' ') continue;
    if (!has_digit) kind += word;
    word.clear();
    has_digit = false;
  }
  return has_digit ? kind : kind + word;
}

std::string kind_of(const Finding& finding) {
  // Two kinds of messages have names without quotes.
  if (finding.what.ends_with(unused)) return std::string(unused);
  if (is_guessed_name(finding.what)) return std::string(guess);
  return without_details(finding.what);
}

std::string subject_of(const Finding& finding) {
  const std::string_view what = finding.what;
  if (what.ends_with(unused)) return std::string(what.substr(0, what.size() - unused.size()));
  if (is_guessed_name(what)) return std::string(what.substr(guess.size()));
  const std::string names = quoted_names(what);
  return names.empty() ? finding.where : names;
}

struct Kind {
  Severity severity;
  std::string text;
  bool operator==(const Kind&) const = default;
};

/// "3 more kinds of warnings and notes"; the most severe first, in the order of the groups.
std::string left_out(std::span<const FindingGroup> groups) {
  MUROSIMF_ASSERT(!groups.empty());
  const std::string worst = severity_name(groups.front().first.severity);
  const std::string least = severity_name(groups.back().first.severity);
  return fmt::format("{} more kinds of {}s{}", groups.size(), worst, worst == least ? "" : " and " + least + "s");
}

}  // namespace

std::vector<FindingGroup> grouped(const std::vector<Finding>& findings) {
  std::vector<FindingGroup> groups;
  std::vector<Kind> kinds;
  for (const Finding& finding : findings) {
    const Kind kind{finding.severity, kind_of(finding)};
    MUROSIMF_ASSERT(kinds.size() == groups.size());
    const auto known = std::ranges::find(kinds, kind);
    if (known == kinds.end()) {
      kinds.push_back(kind);
      groups.push_back({finding, {}});
    } else {
      groups[static_cast<std::size_t>(known - kinds.begin())].others.push_back(subject_of(finding));
    }
  }
  std::ranges::stable_sort(groups, std::ranges::greater{},
                           [](const FindingGroup& group) { return group.first.severity; });
  return groups;
}

std::string to_line(const FindingGroup& group) {
  if (group.others.empty()) return to_line(group.first);
  std::vector<std::string> names;
  for (const std::string& name : group.others) {
    if (std::ranges::find(names, name) == names.end() && !name.empty()) names.push_back(name);
  }
  const auto shown = std::span(names).first(std::min(shown_names, names.size()));
  Finding line = group.first;
  line.what += fmt::format(" (and {} more{}{}{})", group.others.size(), shown.empty() ? "" : ": ",
                           fmt::join(shown, ", "), shown.size() < names.size() ? ", ..." : "");
  return to_line(line);
}

std::string grouped_text(const std::vector<Finding>& findings, std::size_t most) {
  const std::vector<FindingGroup> groups = grouped(findings);
  MUROSIMF_ASSERT(most > 0);
  const std::size_t shown = groups.size() <= most ? groups.size() : most - 1;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += to_line(groups[i]) + '\n';
  if (shown == groups.size()) return text;
  return text + fmt::format("and {}; --all shows them\n", left_out(std::span(groups).subspan(shown)));
}

}  // namespace murosimf::robot
