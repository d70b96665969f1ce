/// lower_case.h - ASCII text in small letters.
#pragma once

#include <cctype>
#include <string>

namespace murosimf::files {

[[nodiscard]] inline std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace murosimf::files
