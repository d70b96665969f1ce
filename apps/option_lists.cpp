#include "apps/option_lists.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/component_files/sensor_keys.h"
#include "murosimf/model/option.h"

namespace murosimf::app {
namespace {

using OptionCells = std::array<std::string, 7>;  // columns as in the header

std::string meaning_of(const OptionInfo& option) {
  if (option.choices.empty()) return option.meaning;
  return fmt::format("{}; one of {}", option.meaning, fmt::join(option.choices, ", "));
}

OptionCells cells_of(std::string_view owner, const OptionInfo& option) {
  return {std::string(owner), option.name,          std::string(type_name(option)),
          option.unit,        default_text(option), option.choices.empty() ? range_text(option) : "",
          meaning_of(option)};
}

/// Options of several owners of a kind, with columns as wide as they must be.
class OptionList {
 public:
  explicit OptionList(std::string_view kind)
      : rows_{{std::string(kind), "option", "type", "unit", "default", "range", "meaning"}} {}

  OptionList& add(std::string_view owner, const std::vector<OptionInfo>& options) {
    for (const OptionInfo& option : options) rows_.push_back(cells_of(owner, option));
    return *this;
  }
  /// Of all entries of a registry.
  OptionList& add_all(const auto& registry) {
    for (const auto& entry : registry) add(entry.name, entry.options);
    return *this;
  }

  [[nodiscard]] std::string text() const {
    std::string all;
    for (const OptionCells& row : rows_) {
      for (std::size_t i = 0; i + 1 < row.size(); ++i) all += fmt::format("{:<{}}  ", row[i], width(i));
      all += row.back() + "\n";
    }
    return all;
  }

 private:
  [[nodiscard]] std::size_t width(std::size_t column) const {
    std::size_t most = 0;
    for (const OptionCells& row : rows_) most = std::max(most, row[column].size());
    return most;
  }

  std::vector<OptionCells> rows_;
};

}  // namespace

std::string option_lists() {
  return OptionList("controller").add_all(catalog::controllers()).text() + "\n" +
         OptionList("level").add_all(catalog::levels()).text() + "\n" +
         OptionList("contact").add_all(catalog::contacts()).text() + "\n" +
         OptionList("body_contact").add_all(catalog::body_contacts()).text() + "\n" +
         OptionList("sensor")
             .add_all(component_files::sensor_types())
             .add("(every sensor)", component_files::sensor_keys().infos())
             .add("(every output)", component_files::signal_keys())
             .text();
}

}  // namespace murosimf::app
