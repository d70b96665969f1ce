/// json_schema.h - what a JSON document of this program is, and in which version: its key "schema" (docs/json.md).
#pragma once

#include <string>
#include <string_view>

namespace murosimf::files {

/// "murosimf/run/1". The number grows when a key goes or changes its meaning, not when one is added.
[[nodiscard]] inline std::string json_schema(std::string_view document, int version = 1) {
  return "murosimf/" + std::string(document) + "/" + std::to_string(version);
}

}  // namespace murosimf::files
