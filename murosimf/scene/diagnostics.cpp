#include "murosimf/scene/diagnostics.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace murosimf::scene {

void Diagnostics::note(std::string_view entity, std::string_view text) { note(fmt::format("{}: {}", entity, text)); }

void Diagnostics::warn(std::string_view entity, std::string_view text) { warn(fmt::format("{}: {}", entity, text)); }

bool Diagnostics::has_warning(std::string_view text) const {
  return std::ranges::find(warnings_, text) != warnings_.end();
}

void add_diagnostic(const std::string& text, const std::string& about, std::vector<SharedDiagnostic>& diagnostics) {
  if (text.empty()) return;
  auto known = std::ranges::find(diagnostics, text, &SharedDiagnostic::text);
  if (known == diagnostics.end()) known = diagnostics.insert(diagnostics.end(), {text, {}});
  known->about.push_back(about);
}

std::string to_text(const SharedDiagnostic& diagnostic) {
  return fmt::format("{}: {}", fmt::join(diagnostic.about, ", "), diagnostic.text);
}

}  // namespace murosimf::scene
