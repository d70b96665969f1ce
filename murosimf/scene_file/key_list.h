/// key_list.h - every key of a scene file, by section: for `murosimf list keys`, --set and suggestions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace murosimf::scene_file {

struct KeyInfo {
  std::string_view name;
  std::string_view unit;  ///< empty: none, or stated in the meaning
  std::string fallback;   ///< the default; empty: none
  std::string_view meaning;
};

struct SectionInfo {
  std::string_view header;  ///< as written in the file, "[view]", "[[robots]]"; empty: the keys before all sections
  std::string_view like;    ///< the section with the same keys, "[[robots]]"; empty: it has its own
  std::vector<KeyInfo> keys;
};

/// All sections, in the order of the documentation.
[[nodiscard]] const std::vector<SectionInfo>& sections();

/// The section of a key of the file: "view" for [view], "robots" for [[robots]], "" for the keys before all sections.
/// Null if there is none.
[[nodiscard]] const SectionInfo* find_section(std::string_view name);

[[nodiscard]] std::vector<std::string_view> names_of(const SectionInfo& section);

}  // namespace murosimf::scene_file
