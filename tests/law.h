/// law.h - statements of what a test proves: each one asserts, and is a row of the table of docs/validation.md.
///
///     law::expect_below({.law = "free flight: drift of the center of mass",
///                        .level = "simplified_dynamics",
///                        .source = "no external force moves it"},
///                       drift, 1e-9, "m");
///
/// scripts/validation_table collects the rows. Texts are ASCII, in one line.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace murosimf::law {

/// What is proved, for which level, contact law or kernel, and where the right answer comes from.
struct Statement {
  std::string law, level, source;
};

/// A measured number, and where it was found if it is one of many.
struct Measured {
  Measured(double number) : value(number) {}  // NOLINT(google-explicit-constructor): a number is a measurement
  Measured(double number, std::string place) : value(number), where(std::move(place)) {}
  double value;
  std::string where;
};

/// The largest of many measurements, and where it was. NaN counts as the largest; none at all is NaN and so fails.
class Worst {
 public:
  template <class... Where>
  void see(double value, const Where&... where) {
    const bool first = std::exchange(empty_, false);
    if (!first && (std::isnan(worst_.value) || value <= worst_.value)) return;
    worst_.value = value;
    worst_.where.clear();
    (worst_.where.append(fmt::format("{} ", where)), ...);
  }
  operator Measured() const { return worst_; }  // NOLINT(google-explicit-constructor): it is one

 private:
  Measured worst_ = std::numeric_limits<double>::quiet_NaN();
  bool empty_ = true;
};

/// Where a statement stands (std::source_location, which clang 14 does not have).
struct Line {
  static Line current(const char* file = __builtin_FILE(), int number = __builtin_LINE()) { return {file, number}; }
  const char* file;
  int number;
};

namespace detail {

/// What is demanded: low <= number - expected <= high, without the ends if `open`.
struct Demand {
  std::string text, unit;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double expected = 0;
  bool open = false;

  [[nodiscard]] bool holds(double number) const {
    const double x = number - expected;
    return open ? low < x && x < high : low <= x && x <= high;
  }
};

/// Keeps the row with the test's results: fields in the order of `fields` in scripts/validation_table.
inline void record(const Statement& statement, const Demand& demand, double measured) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const int number = test->result()->test_property_count();
  const std::string words =
      fmt::format("{}\t{}\t{}\t{}\t{}", statement.law, statement.level, statement.source, demand.text, demand.unit);
  const std::string numbers = fmt::format("{}\t{}\t{}", demand.low, demand.high, measured - demand.expected);
  testing::Test::RecordProperty(fmt::format("law_{}", number), words + '\t' + numbers);
}

inline void expect(const Statement& statement, const Measured& measured, const Demand& demand, const Line& line) {
  record(statement, demand, measured.value);
  if (demand.holds(measured.value)) return;
  ADD_FAILURE_AT(line.file, line.number) << statement.law << " (" << statement.level << "): " << measured.value << ' '
                                         << demand.unit << ", demanded is " << demand.text << ' ' << demand.unit
                                         << (measured.where.empty() ? "" : "\n  worst at: ") << measured.where
                                         << "\n  source: " << statement.source;
}

}  // namespace detail

/// measured < limit.
inline void expect_below(const Statement& statement, const Measured& measured, double limit, const std::string& unit,
                         const Line& line = Line::current()) {
  detail::expect(statement, measured,
                 {.text = fmt::format("< {:.6g}", limit), .unit = unit, .high = limit, .open = true}, line);
}

/// measured > limit.
inline void expect_above(const Statement& statement, const Measured& measured, double limit, const std::string& unit,
                         const Line& line = Line::current()) {
  detail::expect(statement, measured,
                 {.text = fmt::format("> {:.6g}", limit), .unit = unit, .low = limit, .open = true}, line);
}

/// low <= measured <= high.
inline void expect_between(const Statement& statement, const Measured& measured, double low, double high,
                           const std::string& unit, const Line& line = Line::current()) {
  const std::string text = fmt::format("{:.6g} to {:.6g}", low, high);
  detail::expect(statement, measured, {.text = text, .unit = unit, .low = low, .high = high}, line);
}

/// |measured - expected| <= tolerance; the table shows the deviation.
inline void expect_near(const Statement& statement, const Measured& measured, double expected, double tolerance,
                        const std::string& unit, const Line& line = Line::current()) {
  const std::string text = fmt::format("{:.6g} +- {:.6g}", expected, tolerance);
  detail::expect(statement, measured,
                 {.text = text, .unit = unit, .low = -tolerance, .high = tolerance, .expected = expected}, line);
}

/// measured == expected, without any tolerance.
inline void expect_equal(const Statement& statement, const Measured& measured, double expected, const std::string& unit,
                         const Line& line = Line::current()) {
  const std::string text = fmt::format("= {:.6g}", expected);
  detail::expect(statement, measured, {.text = text, .unit = unit, .low = 0, .high = 0, .expected = expected}, line);
}

}  // namespace murosimf::law
