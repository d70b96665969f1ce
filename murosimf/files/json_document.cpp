#include "murosimf/files/json_document.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace murosimf::files {
namespace {

using nlohmann::json;

void spell_non_finite_numbers(json& value) {
  if (value.is_structured()) {
    for (json& element : value) spell_non_finite_numbers(element);
  } else if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::isnan(number)) value = "NaN";
    if (std::isinf(number)) value = number > 0 ? "Infinity" : "-Infinity";
  }
}

}  // namespace

std::string json_text(json document) {
  spell_non_finite_numbers(document);
  return document.dump(4, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace murosimf::files
