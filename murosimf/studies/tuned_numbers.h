/// tuned_numbers.h - numbers with names that a search may change, each within its bounds, as points of the unit cube.
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/model/option.h"
#include "murosimf/studies/cma_es.h"

namespace murosimf::studies {

struct TunedNumber {
  std::string name;
  double value = 0, low = 0, high = 0;  ///< value: where the search begins
};

/// Ten numbers of a walk, `seed` (locomotion/walk_options.h) with bounds around it: what lies outside would be another kind of walk
/// (straight knees, feet that cross) or none. Throws SetupError for a model without legs.
[[nodiscard]] std::vector<TunedNumber> walk_numbers(const Model& model, const OptionValues& seed);

/// The numbers of the feedback (locomotion/gait_feedback.h): each from none to twice what it is, within the bounds of its option;
/// scales of the gait itself less far.
[[nodiscard]] std::vector<TunedNumber> feedback_numbers(const Model& model);

/// 0 to 1.
[[nodiscard]] double place_of(const TunedNumber& number, double value);
/// Rounded to five digits after the point, as files have them.
[[nodiscard]] OptionValues values_at(const std::vector<TunedNumber>& numbers, const std::vector<double>& point);
/// The unit cube, from the numbers' own values; `sigma` [1] of the width of each number's bounds.
[[nodiscard]] CmaEsOptions space_of(const std::vector<TunedNumber>& numbers, double sigma);

[[nodiscard]] double number_in(const OptionValues& values, const std::string& name);

}  // namespace murosimf::studies
