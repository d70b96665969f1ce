/// diagnostics.h - messages for the user of a scene: notes (nothing is wrong) and warnings (the result may be worthless).
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace murosimf::scene {

class Diagnostics {
 public:
  void note(std::string text) { notes_.push_back(std::move(text)); }
  void warn(std::string text) { warnings_.push_back(std::move(text)); }
  void warn(const std::vector<std::string>& texts) { warnings_.insert(warnings_.end(), texts.begin(), texts.end()); }
  /// Prefixed as "entity: text".
  void note(std::string_view entity, std::string_view text);
  void warn(std::string_view entity, std::string_view text);
  /// True the first time that this text is reported for the entity.
  bool is_new(const std::string& entity, const std::string& text) { return said_.emplace(entity, text).second; }
  [[nodiscard]] bool has_warning(std::string_view text) const;

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::vector<std::string> notes_, warnings_;
  std::set<std::pair<std::string, std::string>> said_;  // entities, and texts
};

/// The same sentence about several entities: "left_foot, right_foot: text".
struct SharedDiagnostic {
  std::string text;
  std::vector<std::string> about;
};

/// Adds the name to the subjects of an existing text, or a new entry; an empty text adds nothing.
void add_diagnostic(const std::string& text, const std::string& about, std::vector<SharedDiagnostic>& diagnostics);

[[nodiscard]] std::string to_text(const SharedDiagnostic& diagnostic);

}  // namespace murosimf::scene
