/// constants.h - constant properties of a model: few values, looked up while setting up, never in a loop.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "murosimf/model/error.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"

namespace murosimf {

/// The values of one constant property, by object.
class ConstantColumnBase {
 public:
  ConstantColumnBase(PropertyInfo info, std::type_index type) : info_(info), type_(type) {}
  virtual ~ConstantColumnBase() = default;

  [[nodiscard]] const PropertyInfo& info() const { return info_; }
  [[nodiscard]] std::type_index type() const { return type_; }
  [[nodiscard]] virtual std::unique_ptr<ConstantColumnBase> clone_shifted(int offset) const = 0;
  virtual void append(const ConstantColumnBase& other, int offset) = 0;
  [[nodiscard]] virtual bool has(int object) const = 0;
  /// Numbers of one value; empty where the object has none or the value is no row of numbers.
  [[nodiscard]] virtual std::vector<double> numbers(int object) const = 0;

 private:
  PropertyInfo info_;
  std::type_index type_;
};

template <class T>
class ConstantColumn final : public ConstantColumnBase {
 public:
  explicit ConstantColumn(const PropertyInfo& property) : ConstantColumnBase(property, typeid(T)) {}
  [[nodiscard]] static std::unique_ptr<ConstantColumnBase> make(const PropertyInfo& property) {
    return std::make_unique<ConstantColumn<T>>(property);
  }

  [[nodiscard]] std::unique_ptr<ConstantColumnBase> clone_shifted(int offset) const override {
    auto copy = std::make_unique<ConstantColumn<T>>(info());
    copy->append(*this, offset);
    return copy;
  }
  void append(const ConstantColumnBase& other, int offset) override {
    for (const auto& [object, value] : static_cast<const ConstantColumn<T>&>(other).values) {
      values.insert_or_assign(object + offset, value);
    }
  }
  [[nodiscard]] bool has(int object) const override { return values.contains(object); }
  [[nodiscard]] std::vector<double> numbers([[maybe_unused]] int object) const override {
    std::vector<double> result;
    if constexpr (NumericValue<T>) {
      if (const auto found = values.find(object); found != values.end()) {
        for (std::size_t i = 0; i < ValueTraits<T>::numbers; ++i) {
          result.push_back(ValueTraits<T>::get(found->second, i));
        }
      }
    }
    return result;
  }

  std::map<int, T> values;
};

// Of the values that most properties have: made once, in constants.cpp.
extern template class ConstantColumn<double>;
extern template class ConstantColumn<Vec3d>;
extern template class ConstantColumn<SymMat3d>;

class ConstantTable {
 public:
  ConstantTable() = default;
  ConstantTable(const ConstantTable& other) { append(other, 0); }
  ConstantTable(ConstantTable&&) = default;
  ConstantTable& operator=(ConstantTable other) noexcept {
    columns_.swap(other.columns_);
    return *this;
  }
  ~ConstantTable() = default;

  template <class T>
  void set(const Property<T>& property, int object, T value) {
    auto& column = columns_[std::string(property.name)];
    if (!column) column = ConstantColumn<T>::make(property);
    if (column->type() != typeid(T)) refuse_type(property);
    static_cast<ConstantColumn<T>&>(*column).values.insert_or_assign(object, std::move(value));
  }

  /// Null if the object does not have the property.
  template <class T>
  [[nodiscard]] const T* find(const Property<T>& property, int object) const {
    const ConstantColumn<T>* column = column_of(property);
    if (!column) return nullptr;
    const auto value = column->values.find(object);
    return value == column->values.end() ? nullptr : &value->second;
  }
  /// The objects that have the property, in their order.
  template <class T>
  [[nodiscard]] std::vector<int> having(const Property<T>& property) const {
    std::vector<int> objects;
    if (const ConstantColumn<T>* column = column_of(property)) {
      for (const auto& [object, value] : column->values) objects.push_back(object);
    }
    return objects;
  }

  /// Takes over another table whose objects begin at `offset` here.
  void append(const ConstantTable& other, int offset);

  [[nodiscard]] const auto& columns() const { return columns_; }

 private:
  [[noreturn]] static void refuse_type(const PropertyInfo& property);
  /// Null if no object has the property.
  template <class T>
  [[nodiscard]] const ConstantColumn<T>* column_of(const Property<T>& property) const {
    const auto column = columns_.find(property.name);
    if (column == columns_.end() || column->second->type() != typeid(T)) return nullptr;
    return static_cast<const ConstantColumn<T>*>(column->second.get());
  }

  std::map<std::string, std::unique_ptr<ConstantColumnBase>, std::less<>> columns_;
};

}  // namespace murosimf
