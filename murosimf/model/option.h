/// option.h - options of algorithms as data: what is told about them, and values that somebody gives.
///
///     const OptionTable<DriveOptions> table{{"acceleration", &DriveOptions::acceleration, "m/s^2", "of the car", 0, 100}};
///     table.apply(given, options);
///
/// One row says name, place, unit, meaning and bounds; defaults are those of a new struct, so that they stand once. Readers of
/// files, their checks and `murosimf list options` come from these rows.
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf {

/// A number, a boolean, a text or a vector. Numbers are in the unit of the option, finite.
using OptionValue = std::variant<double, bool, std::string, Vec3d>;

/// What somebody has given, by the names of options; the others keep their defaults.
using OptionValues = std::map<std::string, OptionValue, std::less<>>;

inline constexpr double any_number = std::numeric_limits<double>::infinity();

/// What is told about an option.
struct OptionInfo {
  std::string name;
  OptionValue fallback;  ///< holds if nothing is given; its type is that of the option
  std::string unit;      ///< empty: none
  std::string meaning;
  double lowest = -any_number, highest = any_number;  ///< of a number; of a vector: of its length
};

/// "number", "boolean", "text" or "vector"
[[nodiscard]] std::string_view type_name(const OptionValue& value);
/// As a file would have it: 0.2, true, camera, [1, 0, 0].
[[nodiscard]] std::string value_text(const OptionValue& value);
/// "0 to 2", "from 0", "up to 2"; empty: any.
[[nodiscard]] std::string range_text(const OptionInfo& option);

/// The names, for messages.
[[nodiscard]] std::vector<std::string_view> option_names(const std::vector<OptionInfo>& options);

/// Throws SetupError if the value is of another type, not finite, or out of range.
void check_option(const OptionInfo& option, const OptionValue& value);
/// The same of several; also for the name of one that is not among `options`, with the nearest. `owner` is for the message:
/// "controller 'drive'".
void check_options(std::string_view owner, const std::vector<OptionInfo>& options, const OptionValues& values);

/// Options that are members of a struct: double, bool, std::string or Vec3d.
template <class Target>
class OptionTable {
 public:
  /// One option. What reads and writes the member is made for its own type only.
  struct Row {
    template <class T>
    Row(std::string_view what, T Target::*member, std::string_view in_unit, std::string_view means,
        double at_least = -any_number, double at_most = any_number)
        : name(what), unit(in_unit), meaning(means), lowest(at_least), highest(at_most) {
      static_assert(std::is_same_v<T, double> || std::is_same_v<T, bool> || std::is_same_v<T, std::string> ||
                        std::is_same_v<T, Vec3d>,
                    "an option is a double, a bool, a std::string or a Vec3d");
      read = [member](const Target& from) { return OptionValue(from.*member); };
      write = [member](const OptionValue& value, Target& to) { to.*member = std::get<T>(value); };
    }

    std::string_view name, unit, meaning;
    double lowest, highest;
    std::function<OptionValue(const Target&)> read;
    std::function<void(const OptionValue&, Target&)> write;
  };

  OptionTable(std::initializer_list<Row> rows) : rows_(rows) {}

  /// Defaults are those of a new Target.
  [[nodiscard]] std::vector<OptionInfo> infos() const {
    std::vector<OptionInfo> all;
    const Target fresh{};
    for (const Row& row : rows_) {
      all.push_back({std::string(row.name), row.read(fresh), std::string(row.unit), std::string(row.meaning),
                     row.lowest, row.highest});
    }
    return all;
  }

  /// Writes what is given to its members. Throws as check_options does, and writes nothing then.
  void apply(const OptionValues& given, Target& target) const {
    check_options("this algorithm", infos(), given);
    for (const Row& row : rows_) {
      if (const auto value = given.find(row.name); value != given.end()) row.write(value->second, target);
    }
  }

 private:
  std::vector<Row> rows_;
};

}  // namespace murosimf
