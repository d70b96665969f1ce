#include "murosimf/files/json_document.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace murosimf::files {
namespace {

using nlohmann::json;

void name_what_is_not_finite(json& value) {
  if (value.is_structured()) {
    for (json& element : value) name_what_is_not_finite(element);
  } else if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::isnan(number)) value = "NaN";
    if (std::isinf(number)) value = number > 0 ? "Infinity" : "-Infinity";
  }
}

}  // namespace

std::string json_text(json document) {
  name_what_is_not_finite(document);
  return document.dump(4, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace murosimf::files
