#include "murosimf/scene/remarks.h"

#include <algorithm>

#include <fmt/format.h>

namespace murosimf::scene {

void Remarks::note(std::string_view entity, std::string_view text) { note(fmt::format("{}: {}", entity, text)); }

void Remarks::warn(std::string_view entity, std::string_view text) { warn(fmt::format("{}: {}", entity, text)); }

bool Remarks::has_warning(std::string_view text) const { return std::ranges::find(warnings_, text) != warnings_.end(); }

void add_remark(const std::string& text, const std::string& about, std::vector<SharedRemark>& remarks) {
  if (text.empty()) return;
  auto known = std::ranges::find(remarks, text, &SharedRemark::text);
  if (known == remarks.end()) known = remarks.insert(remarks.end(), {text, {}});
  known->about.push_back(about);
}

std::string to_text(const SharedRemark& remark) {
  return fmt::format("{}: {}", fmt::join(remark.about, ", "), remark.text);
}

}  // namespace murosimf::scene
