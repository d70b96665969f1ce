/// signal_row.h - a signal (murosimf_signal) in a row that software can only read.
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include <fmt/format.h>

#include "murosimf/control_software/guard/guarded_row.h"
#include "murosimf/control_software/murosimf_controller.h"

namespace murosimf::control_software {

/// "3 numbers"
inline std::string numbers_text(std::size_t count) { return fmt::format("{} number{}", count, count == 1 ? "" : "s"); }

/// Time and count of samples of `now`, and the numbers.
inline void show_numbers(const GuardedRow& row, std::span<const double> numbers, const murosimf_signal& now) noexcept {
  auto& shown = row.head<murosimf_signal>();
  shown.time = now.time;
  shown.samples = now.samples;
  std::ranges::copy(numbers, row.body<double>());
}

/// A new row, which shows them.
inline const GuardedRow& show_numbers(GuardedRows& rows, const std::string& name, std::span<const double> numbers,
                                      const murosimf_signal& now) {
  const GuardedRow& row = rows.add(name, numbers_text(numbers.size()), sizeof(murosimf_signal), numbers.size_bytes(),
                                   GuardedRow::Use::read);
  row.head<murosimf_signal>() = {row.shown_body<const double>(), numbers.size(), 0, 0};
  show_numbers(row, numbers, now);
  return row;
}

}  // namespace murosimf::control_software
