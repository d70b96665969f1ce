/// property.h - the descriptor of a property of objects.
///
/// A property is a typed name with unit, frame and meaning. Constant properties are set while modelling and live in
/// the Model; variable ones live in the columns of an Entity and exist only if an algorithm asks for them.
#pragma once

#include <string_view>

namespace murosimf {

enum class Scope {
  object,  ///< every object of the entity has one
  shown,   ///< every object has one; computed from the others for display only, so it is not in the state hash
  base,    ///< one for the whole entity; it belongs to the base
  sensor,  ///< one for the whole entity, output of a sensor; reading changes nothing, so it is not in the state hash
  wiring,  ///< one for the whole entity, by which its algorithms are connected; created anew, never stored or hashed
};

/// Whether a column of that scope has a row for every object, else one for the base.
[[nodiscard]] constexpr bool of_every_object(Scope scope) { return scope == Scope::object || scope == Scope::shown; }

/// Whether columns of that scope are state: input of the next step.
[[nodiscard]] constexpr bool is_state(Scope scope) { return scope == Scope::object || scope == Scope::base; }

/// The part of a descriptor that does not depend on the type.
struct PropertyInfo {
  std::string_view name;     ///< as written in files and on the command line
  std::string_view unit;     ///< SI; "1" for pure numbers
  std::string_view frame;    ///< axes and reference point; "-" where there are none
  std::string_view meaning;  ///< one line
  Scope scope = Scope::object;
  bool fades = false;  ///< it decays to 0 by itself, and is no part of the state hash while all of it is 0
};

template <class T>
struct Property : PropertyInfo {
  using Value = T;
};

namespace properties {

/// One line of the list that every folder has of its properties (catalog/property_catalog.h collects them).
struct CatalogEntry {
  PropertyInfo info;
  bool constant = false;  ///< it lives in the model, else in a column of the entity
};

[[nodiscard]] constexpr CatalogEntry constant(const PropertyInfo& info) { return {info, true}; }
[[nodiscard]] constexpr CatalogEntry variable(const PropertyInfo& info) { return {info, false}; }

}  // namespace properties

}  // namespace murosimf
