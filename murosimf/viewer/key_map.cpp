#include "murosimf/viewer/key_map.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "murosimf/files/toml_reader.h"
#include "murosimf/model/error.h"

namespace murosimf::viewer {
namespace {

constexpr std::array long_names{"Space",  "Tab",  "Enter", "Escape", "Backspace", "Backslash", "Delete",
                                "Insert", "Home", "End",   "PageUp", "PageDown",  "Left",      "Right",
                                "Up",     "Down", "F1",    "F2",     "F3",        "F4",        "F5",
                                "F6",     "F7",   "F8",    "F9",     "F10",       "F11",       "F12"};
constexpr std::string_view short_names = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-=[];',./`";

/// Names of keys may be written in any case.
bool equal_in_any_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

const ActionInfo& action_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const ActionInfo& info : actions()) {
    if (info.name == name) return info;
    names.push_back(info.name);
  }
  throw SetupError(unknown_name("action", name, names));
}

/// The texts of a text or a list of texts.
std::vector<const toml::value<std::string>*> texts_of(const toml::node& node) {
  std::vector<const toml::value<std::string>*> texts;
  if (const auto* text = node.as_string()) texts.push_back(text);
  const toml::array* list = node.as_array();
  if (texts.empty() && !list) files::fail_at(node.source(), "write the name of a key, or a list of them");
  if (!list) return texts;
  for (const toml::node& one : *list) {
    if (!one.is_string()) files::fail_at(one.source(), "write the name of a key, like \"Space\" or \"Ctrl+B\"");
    texts.push_back(one.as_string());
  }
  return texts;
}

}  // namespace

std::vector<std::string_view> key_names() {
  std::vector<std::string_view> names(long_names.begin(), long_names.end());
  for (std::size_t i = 0; i < short_names.size(); ++i) names.push_back(short_names.substr(i, 1));
  return names;
}

/// Modifiers come first, in any order: "Ctrl+Shift+A".
KeyChord read_chord(std::string_view text) {
  KeyChord chord;
  std::string_view rest = text;
  for (std::size_t plus = rest.find('+'); plus != std::string_view::npos; plus = rest.find('+')) {
    const std::string_view held = rest.substr(0, plus);
    if (equal_in_any_case(held, "Ctrl")) {
      chord.ctrl = true;
    } else if (equal_in_any_case(held, "Shift")) {
      chord.shift = true;
    } else if (equal_in_any_case(held, "Alt")) {
      chord.alt = true;
    } else {
      throw SetupError(fmt::format("key '{}': '{}' is not held beside a key; Ctrl, Shift and Alt are", text, held));
    }
    rest.remove_prefix(plus + 1);
  }
  for (const std::string_view name : key_names()) {
    if (equal_in_any_case(name, rest)) chord.key = name;
  }
  if (chord.key.empty()) throw SetupError(unknown_name("key", rest, key_names()));
  return chord;
}

std::string to_text(const KeyChord& chord) {
  return fmt::format("{}{}{}{}", chord.ctrl ? "Ctrl+" : "", chord.shift ? "Shift+" : "", chord.alt ? "Alt+" : "",
                     chord.key);
}

KeyMap::KeyMap() {
  for (const ActionInfo& info : actions()) keys_[read_chord(info.key)] = info.action;
}

KeyMap::KeyMap(const std::filesystem::path& file) : KeyMap() {
  const toml::table table = files::parse_toml_file(file);
  std::map<KeyChord, Action> given;
  for (const auto& [name, node] : table) {
    const Action action = with_context(files::where(node.source()), [&] { return action_named(name.str()).action; });
    // an action in the file loses its default keys, an empty list leaves it without any
    std::erase_if(keys_, [&](const auto& key) { return key.second == action; });
    for (const auto* text : texts_of(node)) {
      const std::string where = files::where(text->source());
      const KeyChord chord = with_context(where, [&] { return read_chord(text->get()); });
      const auto [other, is_new] = given.emplace(chord, action);
      if (is_new) continue;
      throw SetupError(fmt::format("{}: the key {} stands for two actions: {} and {}", where, to_text(chord),
                                   info_of(other->second).name, info_of(action).name));
    }
  }
  for (const auto& [chord, action] : given) keys_[chord] = action;
}

std::optional<Action> KeyMap::action_of(const KeyChord& chord) const {
  const auto found = keys_.find(chord);
  return found == keys_.end() ? std::nullopt : std::optional(found->second);
}

/// All chords of an action, for the help.
std::string KeyMap::keys_of(Action action) const {
  std::string text;
  for (const auto& [chord, meant] : keys_) {
    if (meant == action) text += (text.empty() ? "" : ", ") + to_text(chord);
  }
  return text;
}

}  // namespace murosimf::viewer
