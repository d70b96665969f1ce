#include "murosimf/robot/body_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>

#include "murosimf/files/lower_case.h"

namespace murosimf::robot {
namespace {

bool has_one_of(const std::string& name, std::span<const std::string_view> words) {
  const std::string small = files::lower_case(name);
  return std::ranges::any_of(words, [&](std::string_view word) { return small.find(word) != std::string::npos; });
}

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }

/// A letter between underscores or ends, or in front of a word: "l_hand", "LHand".
bool has_letter(const std::string& name, char letter) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(name[i])) != letter || (i > 0 && name[i - 1] != '_')) continue;
    if (i + 1 == name.size() || name[i + 1] == '_') return true;
    if (is_upper(name[i]) && i + 2 < name.size() && is_upper(name[i + 1]) && is_lower(name[i + 2])) return true;
  }
  return false;
}

}  // namespace

Side side_of(const std::string& name) {
  const std::string small = files::lower_case(name);
  const bool left = small.find("left") != std::string::npos || has_letter(name, 'l');
  const bool right = small.find("right") != std::string::npos || has_letter(name, 'r');
  if (left == right) return Side::unknown;
  return left ? Side::left : Side::right;
}

std::string right_name(const std::string& name) {
  constexpr std::array<std::array<const char*, 2>, 3> anywhere{
      {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}}};
  for (const auto& [left, right] : anywhere) {
    if (const auto at = name.find(left); at != std::string::npos) {
      return std::string(name).replace(at, std::string(left).size(), right);
    }
  }
  if (name.size() < 2) return {};
  std::string other = name;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins = i == 0 || name[i - 1] == '_';
    const bool ends = i + 1 == name.size() || name[i + 1] == '_' || (name[i] == 'L' && i == 0);
    if (!begins || !ends || (name[i] != 'l' && name[i] != 'L')) continue;
    other[i] = name[i] == 'l' ? 'r' : 'R';
    return other;
  }
  return {};
}

bool names_hand(const std::string& name) {
  static constexpr std::array<std::string_view, 4> words{"hand", "gripper", "wrist", "palm"};
  return has_one_of(name, words);
}

bool names_finger(const std::string& name) {
  static constexpr std::array<std::string_view, 3> words{"finger", "thumb", "jaw"};
  return has_one_of(name, words);
}

}  // namespace murosimf::robot
