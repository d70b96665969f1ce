/// key_map.h - assignment of keys to actions: the defaults, or those of a file.
///
///     run_or_pause = "Enter"       # TOML: an action of actions.h, and its key
///     place_ball = ["B", "Ctrl+B"] # several
///     reload = []                  # none
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/viewer/actions.h"

namespace murosimf::viewer {

/// A key with its modifiers. Names of keys: one letter, digit or sign; Space, Tab, Enter, Escape, Backspace, Backslash,
/// Delete, Insert, Home, End, PageUp, PageDown, Left, Right, Up, Down, F1 to F12.
struct KeyChord {
  std::string key;
  bool ctrl = false, shift = false, alt = false;
  friend auto operator<=>(const KeyChord&, const KeyChord&) = default;
};

/// "Ctrl+Shift+P"; case-insensitive. Throws SetupError.
[[nodiscard]] KeyChord read_chord(std::string_view text);
[[nodiscard]] std::string to_text(const KeyChord& chord);
/// All names of keys.
[[nodiscard]] std::vector<std::string_view> key_names();

class KeyMap {
 public:
  /// The default keys.
  KeyMap();
  /// The defaults, overridden by the file. A key that the file assigns is removed from its default action. Throws
  /// SetupError with file and line: unknown actions and keys, one key for two actions.
  explicit KeyMap(const std::filesystem::path& file);

  [[nodiscard]] std::optional<Action> action_of(const KeyChord& chord) const;
  /// "Space", "B, Ctrl+B"; empty if there is none.
  [[nodiscard]] std::string keys_of(Action action) const;

 private:
  std::map<KeyChord, Action> keys_;
};

}  // namespace murosimf::viewer
