/// option.h - options of algorithms as data: their descriptions, and the values that users give.
///
///     const OptionTable<DriveOptions> table{{"acceleration", &DriveOptions::acceleration, "m/s^2", "of the car", 0, 100}};
///     table.apply(given, options);
///
/// One row has name, place, unit, meaning and bounds; defaults are those of a new struct, so that they are written once. Readers of
/// files, their checks and `murosimf list options` use these rows.
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/math/vec3.h"

namespace murosimf {

/// A number, a boolean, a text or a vector. Numbers are in the unit of the option, finite.
using OptionValue = std::variant<double, bool, std::string, Vec3d>;

/// Values that have been given, by the names of options; the others keep their defaults.
using OptionValues = std::map<std::string, OptionValue, std::less<>>;

inline constexpr double any_number = std::numeric_limits<double>::infinity();

/// The lowest value of a range.
struct LowestValue {
  double value = -any_number;
  bool open = false;  ///< it is itself too low

  LowestValue() = default;
  LowestValue(double included) : value(included) {}  // NOLINT(google-explicit-constructor): a number means itself
  LowestValue(double at, bool is_open) : value(at), open(is_open) {}
};
[[nodiscard]] inline LowestValue above(double value) { return {value, true}; }

/// Description of an option.
struct OptionInfo {
  std::string name;
  OptionValue fallback;  ///< holds if nothing is given; its type is that of the option. NaN: `meaning` says what holds
  std::string unit;      ///< empty: none
  std::string meaning;
  LowestValue lowest{};                ///< of a number; of a vector: of its length
  double highest = any_number;         ///< the same
  bool whole = false;                  ///< a number without a fraction
  std::vector<std::string> choices{};  ///< of a text; empty: any
};

/// "number", "boolean", "text" or "vector"
[[nodiscard]] std::string_view type_name(const OptionValue& value);
/// The same, or "integer".
[[nodiscard]] std::string_view type_name(const OptionInfo& option);
/// As a file would have it: 0.2, true, camera, [1, 0, 0].
[[nodiscard]] std::string value_text(const OptionValue& value);
/// The text of the default; "-" for NaN.
[[nodiscard]] std::string default_text(const OptionInfo& option);
/// "0 to 2", "from 0", "above 0", "up to 2"; of a text its choices: "a, b"; empty: any.
[[nodiscard]] std::string range_text(const OptionInfo& option);

/// Null if there is none of that name.
[[nodiscard]] const OptionInfo* find_option(const std::vector<OptionInfo>& options, std::string_view name);
/// Those of `values` whose names are among the options.
[[nodiscard]] OptionValues values_among(const std::vector<OptionInfo>& options, const OptionValues& values);
/// The names, for messages.
[[nodiscard]] std::vector<std::string_view> option_names(const std::vector<OptionInfo>& options);

/// Throws SetupError if the value is of another type, out of range, none of the choices, or not finite; an infinite one is taken
/// if the default is infinite.
void check_option(const OptionInfo& option, const OptionValue& value);
/// The same of several; also for the name of one that is not among `options`, with the nearest. `owner` is for the message:
/// "controller 'drive'".
void check_options(std::string_view owner, const std::vector<OptionInfo>& options, const OptionValues& values);

namespace option_detail {

template <class T>
inline constexpr bool is_value =
    std::is_same_v<T, double> || std::is_same_v<T, bool> || std::is_same_v<T, std::string> || std::is_same_v<T, Vec3d>;
template <class T>
inline constexpr bool is_number = std::is_same_v<T, int> || std::is_same_v<T, std::optional<double>>;

template <class T>
[[nodiscard]] OptionValue to_value(const T& member) {
  return member;
}
[[nodiscard]] inline OptionValue to_value(int member) { return static_cast<double>(member); }
[[nodiscard]] inline OptionValue to_value(const std::optional<double>& member) {
  return member.value_or(std::numeric_limits<double>::quiet_NaN());
}

template <class T>
void from_value(const OptionValue& value, T& member) {
  if constexpr (is_value<T>) {
    member = std::get<T>(value);
  } else {
    member = static_cast<int>(std::get<double>(value));
  }
}
inline void from_value(const OptionValue& value, std::optional<double>& member) { member = std::get<double>(value); }

}  // namespace option_detail

/// Options that are parts of a struct: double, bool, std::string, Vec3d, int (whole numbers) or std::optional<double>, whose default
/// hangs on other things.
template <class Target>
class OptionTable {
 public:
  /// One option. `place` is a member, or a function of a struct that returns a reference into it; what reads and writes there is made
  /// for its own type only.
  struct Row {
    template <class Place>
    Row(std::string_view what, Place place, std::string_view in_unit, std::string_view means, LowestValue at_least = {},
        double at_most = any_number)
        : name(what), unit(in_unit), meaning(means), lowest(at_least), highest(at_most) {
      using T = std::remove_cvref_t<std::invoke_result_t<Place, Target&>>;
      static_assert(option_detail::is_value<T> || option_detail::is_number<T>,
                    "an option is a double, bool, std::string, Vec3d, int or std::optional<double>");
      whole = std::is_same_v<T, int>;
      read = [place](const Target& from) { return option_detail::to_value(std::invoke(place, from)); };
      write = [place](const OptionValue& value, Target& to) {
        option_detail::from_value(value, std::invoke(place, to));
      };
    }
    /// A text with a fixed set of choices.
    template <class Place>
    Row(std::string_view what, Place place, std::string_view in_unit, std::string_view means,
        std::vector<std::string> one_of)
        : Row(what, place, in_unit, means) {
      choices = std::move(one_of);
    }

    /// A value whose text differs from its stored form, like degrees.
    Row(std::string_view what, std::function<OptionValue(const Target&)> reader,
        std::function<void(const OptionValue&, Target&)> writer, std::string_view in_unit, std::string_view means)
        : name(what), unit(in_unit), meaning(means), read(std::move(reader)), write(std::move(writer)) {}

    std::string_view name, unit, meaning;
    LowestValue lowest{};
    double highest = any_number;
    bool whole = false;
    std::vector<std::string> choices{};
    std::function<OptionValue(const Target&)> read;
    std::function<void(const OptionValue&, Target&)> write;
  };

  OptionTable(std::initializer_list<Row> rows) : OptionTable(std::vector<Row>(rows)) {}
  explicit OptionTable(std::vector<Row> rows) : rows_(std::move(rows)) {
    const Target fresh{};
    for (const Row& row : rows_) {
      infos_.push_back({std::string(row.name), row.read(fresh), std::string(row.unit), std::string(row.meaning),
                        row.lowest, row.highest, row.whole, row.choices});
    }
    MUROSIMF_ASSERT(infos_.size() == rows_.size());
  }

  /// Defaults are those of a new Target.
  [[nodiscard]] const std::vector<OptionInfo>& infos() const { return infos_; }

  /// Present values of the options of a Target, in the order of the table.
  [[nodiscard]] std::vector<OptionValue> values(const Target& target) const {
    std::vector<OptionValue> all;
    for (const Row& row : rows_) all.push_back(row.read(target));
    return all;
  }

  /// Writes the given values to their places. Throws as check_options does, and then writes nothing.
  void apply(const OptionValues& given, Target& target) const {
    check_options("this algorithm", infos_, given);
    for (const Row& row : rows_) {
      if (const auto value = given.find(row.name); value != given.end()) row.write(value->second, target);
    }
  }

 private:
  std::vector<Row> rows_;
  std::vector<OptionInfo> infos_;
};

}  // namespace murosimf
