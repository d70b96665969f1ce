/// setup.h - access of an algorithm to its columns, which also declares its reads and writes.
///
/// An algorithm receives a Setup in its constructor and takes spans from it; taking a span is the declaration. There is
/// no second list that could be forgotten. Spans stay valid for the life of the simulation.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "murosimf/world/access.h"
#include "murosimf/world/time.h"
#include "murosimf/world/world.h"

namespace murosimf {

class Setup {
 public:
  /// All Setups that one algorithm uses share its access set. `period` is the time between two of its steps.
  Setup(World& world, Entity& entity, AccessSet& access, Duration period = std::chrono::milliseconds(1))
      : world_(&world), entity_(&entity), access_(&access), period_(period) {}

  /// Column to read; one row per object, or a single row for properties of the base. Another algorithm must write
  /// it, or the simulation refuses to start.
  template <class T>
  [[nodiscard]] std::span<const T> read(const Property<T>& property) {
    return take(property, AccessMode::read).values;
  }
  /// Column to write (and read). An algorithm that writes a column also sets its first value, in `initialize`.
  template <class T>
  [[nodiscard]] std::span<T> write(const Property<T>& property) {
    return take(property, AccessMode::write).values;
  }
  /// Column to read that users or control software may set at any time, or that only some levels write; `value`
  /// holds until it is set, and again when a level that wrote it is exchanged.
  template <class T>
  [[nodiscard]] std::span<const T> input(const Property<T>& property, const std::type_identity_t<T>& value) {
    const bool has_values = entity_->columns().live() && entity_->find(property);
    Column<T>& column = take(property, AccessMode::input);
    if (!column.start) {
      column.start = value;
      if (!has_values) column.restart();
    }
    return column.values;
  }

  /// Column to read that only some levels write: NaN while none does. It declares no start value: an algorithm with
  /// another start value for the column finds NaN and replaces it.
  [[nodiscard]] std::span<const double> observe(const Property<double>& property) {
    return input(property, std::numeric_limits<double>::quiet_NaN());
  }
  /// Column to write if an algorithm that was attached earlier reads it; otherwise an empty span.
  template <class T>
  [[nodiscard]] std::span<T> write_if_wanted(const Property<T>& property) {
    return entity_->find(property) ? write(property) : std::span<T>{};
  }

  /// Declares that the algorithm executes other algorithms of this entity (an island solver executes the step of
  /// levels): nothing that accesses the entity runs at the same time.
  void claim() { access_->claim(*entity_); }

  [[nodiscard]] const Model& model() const { return entity_->model(); }
  [[nodiscard]] Entity& entity() const { return *entity_; }
  [[nodiscard]] const World& world() const { return *world_; }
  [[nodiscard]] Duration period() const { return period_; }

  /// The same algorithm's access to another entity.
  [[nodiscard]] Setup of(Entity& other) const { return {*world_, other, *access_, period_}; }

 private:
  template <class T>
  Column<T>& take(const Property<T>& property, AccessMode mode) {
    Column<T>& column = entity_->column(property);
    access_->add({entity_, &column, mode});
    return column;
  }

  World* world_;
  Entity* entity_;
  AccessSet* access_;
  Duration period_;
};

}  // namespace murosimf
