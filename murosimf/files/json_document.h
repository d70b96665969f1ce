/// json_document.h - common parts of the JSON documents of this program (docs/json.md): the key "schema", which names the kind and
/// the version of a document, and their text.
///
/// Sources that make a document include <nlohmann/json.hpp>, in their .cpp file only: that header takes seconds to compile.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace murosimf::files {

/// "murosimf/run/1". The number grows when a key is removed or changes its meaning, not when one is added.
[[nodiscard]] inline std::string json_schema(std::string_view document, int version = 1) {
  return "murosimf/" + std::string(document) + "/" + std::to_string(version);
}

/// Lines with keys in alphabetical order. JSON has only finite numbers: others become the texts "NaN", "Infinity" and
/// "-Infinity". Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(nlohmann::json document);

}  // namespace murosimf::files
