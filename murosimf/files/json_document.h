/// json_document.h - what the JSON documents of this program share (docs/json.md): the key "schema", which says what a document
/// is and in which version, and their text.
///
/// Who makes a document includes <nlohmann/json.hpp>, in its .cpp file only: that header takes seconds to compile.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace murosimf::files {

/// "murosimf/run/1". The number grows when a key goes or changes its meaning, not when one is added.
[[nodiscard]] inline std::string json_schema(std::string_view document, int version = 1) {
  return "murosimf/" + std::string(document) + "/" + std::to_string(version);
}

/// Lines with keys in alphabetical order. JSON has only finite numbers: others become the texts "NaN", "Infinity" and
/// "-Infinity". What is no UTF-8 becomes U+FFFD.
[[nodiscard]] std::string json_text(nlohmann::json document);

}  // namespace murosimf::files
