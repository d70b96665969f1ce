#include "murosimf/recording/state_difference.h"

#include <bit>
#include <cstdint>

#include <fmt/format.h>

namespace murosimf::recording {
namespace {

/// Keeps the first difference and counts the others.
class Differences {
 public:
  void compare(const Entity& first, const Entity& second) {
    note_unless_same(first, "present", first.present() ? "true" : "false", second.present() ? "true" : "false");
    note_unless_same(first, "level", first.level, second.level);
    for (const auto& [name, column] : first.columns()) {
      if (!is_state(column->info().scope)) continue;
      const ColumnBase* other = second.find(name);
      if (!other) {
        note(first, "", name, "there", "not there");
      } else {
        compare(first, *column, *other);
      }
    }
    for (const auto& [name, column] : second.columns()) {
      if (is_state(column->info().scope) && !first.find(name)) note(first, "", name, "not there", "there");
    }
  }

  std::optional<StateDifference> result;

  /// The first difference is enough: all others mostly follow from it.
 private:
  void compare(const Entity& entity, const ColumnBase& first, const ColumnBase& second) {
    const std::string property(first.info().name);
    if (first.rows() != second.rows() || first.numbers() != second.numbers()) {
      return note(entity, "", property, fmt::format("{} rows", first.rows()), fmt::format("{} rows", second.rows()));
    }
    if (first.numbers() == 0) {
      if (hash_of(first) != hash_of(second)) note(entity, "", property, "one value", "another value");
      return;
    }
    for (std::size_t row = 0; row < first.rows(); ++row) {
      for (std::size_t i = 0; i < first.numbers(); ++i) compare(entity, first, second, row, i);
    }
  }

  void compare(const Entity& entity, const ColumnBase& first, const ColumnBase& second, std::size_t row,
               std::size_t i) {
    const double a = first.get(row, i), b = second.get(row, i);
    // bit for bit, as the hash: -0 differs from 0, and equal NaN do not differ
    if (std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b)) return;
    const auto& objects = entity.model().objects();
    const std::string object = of_every_object(first.info().scope) && row < objects.size() ? objects[row].name : "";
    const std::string index = first.numbers() > 1 ? fmt::format("[{}]", i) : "";
    note(entity, object, std::string(first.info().name) + index, fmt::format("{}", a), fmt::format("{}", b));
  }

  static std::uint64_t hash_of(const ColumnBase& column) {
    Hasher hasher;
    column.append_to(hasher);
    return hasher.value();
  }

  void note_unless_same(const Entity& entity, const std::string& what, const std::string& first,
                        const std::string& second) {
    if (first != second) note(entity, "", what, first, second);
  }

  void note(const Entity& entity, const std::string& object, const std::string& property, const std::string& first,
            const std::string& second) {
    if (result) {
      ++result->others;
    } else {
      result = StateDifference{
          .entity = entity.name(), .object = object, .property = property, .first = first, .second = second};
    }
  }
};

}  // namespace

std::optional<StateDifference> state_difference(const World& first, const World& second) {
  Differences differences;
  first.for_all([&](const Entity& entity) {
    const Entity* other = entity.name() == second.common().name() ? &second.common() : second.find(entity.name());
    if (other) differences.compare(entity, *other);
  });
  return differences.result;
}

std::string to_text(const StateDifference& difference) {
  const std::string object = difference.object.empty() ? "" : difference.object + ".";
  std::string text = fmt::format("{}.{}{}: {} and {}", difference.entity, object, difference.property, difference.first,
                                 difference.second);
  if (difference.others > 0) {
    text += fmt::format(", and {} other number{}", difference.others, difference.others == 1 ? "" : "s");
  }
  return text;
}

}  // namespace murosimf::recording
