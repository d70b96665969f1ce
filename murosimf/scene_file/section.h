/// section.h - one section of a scene file as a table: its keys with unit, default, bounds, meaning and target.
///
///     const Section<ViewSpec> view("[view]", {{"center", &ViewSpec::center, "m", "what is in the middle"}, ...});
///     view.read(*node, spec.view);
///
/// The reader, the check of unknown keys, --set, `murosimf list keys` and docs/scenes.md use these tables. Only for .cpp
/// files: it includes toml++.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "murosimf/files/toml_reader.h"
#include "murosimf/math/scalar.h"
#include "murosimf/scene_file/key_list.h"

namespace murosimf::scene_file {

/// Bounds of numbers, in the unit of the file; for a vector: of its length.
struct Bounds {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool above = false;  ///< `lowest` itself is excluded
};
constexpr Bounds positive{.lowest = 0, .above = true};
constexpr Bounds not_negative{.lowest = 0};
constexpr Bounds between(double lowest, double highest) { return {.lowest = lowest, .highest = highest}; }
constexpr Bounds up_to(double highest) { return {.highest = highest}; }

/// Degrees in the file, radians in the spec.
template <class Spec>
struct Angle {
  double Spec::*radians;
};

/// One of several names. `kind`, for messages: "level".
template <class Spec>
struct Choice {
  std::string Spec::*name;
  std::string_view kind;
  std::vector<std::string_view> (*known)();
};

/// Reads an existing key. Throws SetupError.
template <class Spec>
using Reader = void (*)(const files::TomlTable& table, std::string_view key, Spec& spec);

/// Target of a key's value; none: other code reads it, because it depends on other keys.
template <class Spec>
using Target = std::variant<std::monostate, double Spec::*, std::optional<double> Spec::*, bool Spec::*,
                            std::uint64_t Spec::*, std::string Spec::*, Vec3d Spec::*, std::optional<Vec3d> Spec::*,
                            Angle<Spec>, Choice<Spec>, Reader<Spec>>;

template <class Spec>
struct Key {
  std::string_view name;
  Target<Spec> target;
  std::string_view unit;
  std::string_view meaning;
  Bounds bounds{};
  std::string_view fallback{};  ///< the default, if that is not the value in a new Spec
};

namespace section_detail {

// Each throws SetupError at the key: a wrong type, or out of bounds.
[[nodiscard]] double read_number(const files::TomlTable& table, std::string_view key, const Bounds& bounds,
                                 std::string_view unit);
[[nodiscard]] Vec3d read_vector(const files::TomlTable& table, std::string_view key, const Bounds& bounds,
                                std::string_view unit);
[[nodiscard]] std::string read_text(const files::TomlTable& table, std::string_view key);  ///< not empty
[[nodiscard]] std::string read_choice(const files::TomlTable& table, std::string_view key, std::string_view kind,
                                      const std::vector<std::string_view>& known);

// Values in the notation of a file.
[[nodiscard]] std::string text_of(double value);
[[nodiscard]] std::string text_of(bool value);
[[nodiscard]] std::string text_of(std::uint64_t value);
[[nodiscard]] std::string text_of(const std::string& value);
[[nodiscard]] std::string text_of(const Vec3d& value);

/// Reads one key into its target.
template <class Spec>
struct Read {
  const files::TomlTable& table;
  const Key<Spec>& key;
  Spec& spec;

  void operator()(std::monostate) const {}
  void operator()(double Spec::*to) const { spec.*to = read_number(table, key.name, key.bounds, key.unit); }
  void operator()(std::optional<double> Spec::*to) const {
    spec.*to = read_number(table, key.name, key.bounds, key.unit);
  }
  void operator()(bool Spec::*to) const { table.read(key.name, spec.*to); }
  void operator()(std::uint64_t Spec::*to) const { table.read(key.name, spec.*to); }
  void operator()(std::string Spec::*to) const { spec.*to = read_text(table, key.name); }
  void operator()(Vec3d Spec::*to) const { spec.*to = read_vector(table, key.name, key.bounds, key.unit); }
  void operator()(std::optional<Vec3d> Spec::*to) const {
    spec.*to = read_vector(table, key.name, key.bounds, key.unit);
  }
  void operator()(Angle<Spec> to) const {
    spec.*to.radians = read_number(table, key.name, key.bounds, key.unit) * pi / 180;
  }
  void operator()(const Choice<Spec>& to) const { spec.*to.name = read_choice(table, key.name, to.kind, to.known()); }
  void operator()(Reader<Spec> read) const { read(table, key.name, spec); }
};

/// The value in a new Spec; empty if there is none.
template <class Spec>
struct Fallback {
  Spec spec{};

  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(Reader<Spec>) const { return {}; }
  std::string operator()(Angle<Spec> of) const { return text_of(spec.*of.radians * 180 / pi); }
  std::string operator()(const Choice<Spec>& of) const { return spec.*of.name; }
  template <class T>
  std::string operator()(T Spec::*of) const {
    return text_of(spec.*of);
  }
  template <class T>
  std::string operator()(std::optional<T> Spec::*of) const {
    return spec.*of ? text_of(*(spec.*of)) : "";
  }
};

}  // namespace section_detail

template <class Spec>
class Section {
 public:
  /// `header` as written in the file: "[view]", "[[robots]]".
  Section(std::string_view header, std::vector<Key<Spec>> keys) : header_(header), keys_(std::move(keys)) {
    for (const Key<Spec>& key : keys_) names_.push_back(key.name);
  }

  [[nodiscard]] const std::vector<Key<Spec>>& keys() const { return keys_; }
  [[nodiscard]] const std::vector<std::string_view>& names() const { return names_; }

  /// Reads existing keys, in the order of this section. Throws SetupError with file:line:column: a key that is
  /// not of this section, a value of a wrong type or out of bounds.
  void read(const toml::table& node, Spec& spec) const { read(files::TomlTable(node, names_), spec); }
  void read(const files::TomlTable& table, Spec& spec) const {
    for (const Key<Spec>& key : keys_) {
      if (table.find(key.name)) std::visit(section_detail::Read<Spec>{table, key, spec}, key.target);
    }
  }

  [[nodiscard]] SectionInfo info() const {
    SectionInfo info{header_, {}, {}};
    const section_detail::Fallback<Spec> fallback;
    for (const Key<Spec>& key : keys_) {
      std::string otherwise(key.fallback);
      if (otherwise.empty()) otherwise = std::visit(fallback, key.target);
      info.keys.push_back({key.name, key.unit, std::move(otherwise), key.meaning});
    }
    return info;
  }

 private:
  std::string_view header_;
  std::vector<Key<Spec>> keys_;
  std::vector<std::string_view> names_;
};

}  // namespace murosimf::scene_file
