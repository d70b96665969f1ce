/// json_line.h - JSON for messages: in one line, and valid for any texts.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace murosimf::web {

/// Invalid UTF-8 becomes U+FFFD; numbers that are not finite become null.
[[nodiscard]] inline std::string json_line(const nlohmann::json& document) {
  return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace murosimf::web
