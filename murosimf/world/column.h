/// column.h - the values of one property for all objects of one entity.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {

/// A column without its type, for interactive use and protocols. Never used inside a loop.
class ColumnBase {
 public:
  ColumnBase(const PropertyInfo& info, std::type_index type) : name_(info.name), info_(info), type_(type) {
    info_.name = name_;  // the name of a descriptor that was composed for the call may end with it
  }
  virtual ~ColumnBase() = default;
  ColumnBase(const ColumnBase&) = delete;
  ColumnBase& operator=(const ColumnBase&) = delete;

  [[nodiscard]] const PropertyInfo& info() const { return info_; }
  [[nodiscard]] std::type_index type() const { return type_; }

  /// Sets it to the start value of the algorithm that takes it as input; nothing if there is none.
  virtual void restart() = 0;

  /// Numbers per row; 0 if the value is no row of numbers.
  [[nodiscard]] virtual std::size_t numbers() const = 0;
  [[nodiscard]] virtual std::size_t rows() const = 0;
  [[nodiscard]] virtual double get(std::size_t row, std::size_t i) const = 0;
  virtual void set(std::size_t row, std::size_t i, double number) = 0;
  virtual void append_to(Hasher& hasher) const = 0;
  /// Saves or loads all rows. Throws SetupError.
  virtual void state(StateArchive& archive) = 0;
  /// Layout of its numbers; `data` is null if the value is no row of numbers. Rows are `stride` doubles apart.
  struct Memory {
    double* data = nullptr;
    std::size_t rows = 0, stride = 0;
    ValueLayout layout{};
  };
  [[nodiscard]] virtual Memory memory() = 0;
  /// Restores the state of a new column.
  virtual void renew() = 0;
  /// Makes go_back() restore the present values; without a call, it restores those of restart(), or of a new column.
  virtual void keep() = 0;
  virtual void go_back() = 0;
  /// How many of its numbers are NaN or infinite; 0 if the value is no row of numbers.
  [[nodiscard]] virtual std::size_t not_finite() const = 0;

 private:
  std::string name_;
  PropertyInfo info_;
  std::type_index type_;
};

/// How many of `count` doubles, one behind the other in memory, are NaN or infinite.
[[nodiscard]] std::size_t count_not_finite(const void* doubles, std::size_t count) noexcept;

/// Debug builds start a column with NaN, so that values that no algorithm writes are seen at once; release builds with zero.
#ifdef NDEBUG
inline constexpr bool fill_with_nan = false;
#else
inline constexpr bool fill_with_nan = true;
#endif

template <class T>
class Column final : public ColumnBase {
 public:
  Column(const Property<T>& property, std::size_t rows) : ColumnBase(property, typeid(T)), values(rows) { fill(); }
  [[nodiscard]] static std::shared_ptr<ColumnBase> make(const Property<T>& property, std::size_t rows) {
    return std::make_shared<Column<T>>(property, rows);
  }

  [[nodiscard]] std::size_t numbers() const override { return ValueTraits<T>::numbers; }
  [[nodiscard]] std::size_t rows() const override { return values.size(); }
  [[nodiscard]] double get([[maybe_unused]] std::size_t row, [[maybe_unused]] std::size_t i) const override {
    if constexpr (NumericValue<T>) {
      MUROSIMF_ASSERT(row < values.size() && i < ValueTraits<T>::numbers);
      return ValueTraits<T>::get(values[row], i);
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
  void set([[maybe_unused]] std::size_t row, [[maybe_unused]] std::size_t i, [[maybe_unused]] double number) override {
    if constexpr (NumericValue<T>) {
      MUROSIMF_ASSERT(row < values.size() && i < ValueTraits<T>::numbers);
      ValueTraits<T>::set(values[row], i, number);
    }
  }
  void append_to(Hasher& hasher) const override {
    for (const T& value : values) append_hash(hasher, value);
  }
  void state(StateArchive& archive) override { archive.elements(std::span(values)); }

  [[nodiscard]] std::size_t not_finite() const override {
    if constexpr (NumericValue<T>) {
      static_assert(sizeof(T) == ValueTraits<T>::numbers * sizeof(double));
      return count_not_finite(values.data(), values.size() * ValueTraits<T>::numbers);
    }
    return 0;
  }

  [[nodiscard]] Memory memory() override {
    if constexpr (NumericValue<T>) {
      static_assert(std::is_standard_layout_v<T> && sizeof(T) == ValueTraits<T>::numbers * sizeof(double));
      return {reinterpret_cast<double*>(values.data()), values.size(), ValueTraits<T>::numbers, ValueTraits<T>::layout};
    }
    return {};
  }

  void renew() override {
    start.reset();
    kept_.clear();
    fill();
  }

  void keep() override {
    kept_.clear();
    if (!is_as_new()) kept_ = values;
  }
  void go_back() override {
    if (!kept_.empty()) {
      MUROSIMF_ASSERT(kept_.size() == values.size());
      values = kept_;
    } else {
      fill();
      restart();
    }
  }

  void restart() override {
    if (start) std::fill(values.begin(), values.end(), *start);
  }

  std::vector<T> values;
  std::optional<T> start;  ///< set if it is an algorithm's input

 private:
  [[nodiscard]] static T fresh() {
    T value{};
    if constexpr (NumericValue<T>) {
      constexpr double number = fill_with_nan ? std::numeric_limits<double>::quiet_NaN() : 0.0;
      for (std::size_t i = 0; i < ValueTraits<T>::numbers; ++i) ValueTraits<T>::set(value, i, number);
    }
    return value;
  }
  void fill() { std::fill(values.begin(), values.end(), fresh()); }
  /// Whether go_back() can restore it without a copy. False if the value is no row of numbers, which cannot be compared.
  [[nodiscard]] bool is_as_new() const {
    if constexpr (NumericValue<T>) {
      const T usual = start.value_or(fresh());
      return std::all_of(values.begin(), values.end(),
                         [&](const T& value) { return std::memcmp(&value, &usual, sizeof(T)) == 0; });
    }
    return false;
  }

  std::vector<T> kept_;
};

// Of the values that most properties have: made once, in column.cpp.
extern template class Column<double>;
extern template class Column<Vec3d>;
extern template class Column<Mat3d>;

}  // namespace murosimf
