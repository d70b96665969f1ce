/// derived_data.h - cache of data that follow from a model alone: computed once for all users of the model.
///
/// Models are shared by all equal robots, also of many worlds in many threads. So data that follow from a model alone (the shapes that
/// collide, the layout of their tree) are computed and stored once instead of for every robot.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf {

class DerivedData {
 public:
  DerivedData() = default;
  /// A copy of a model may get other constants: it starts empty.
  DerivedData(const DerivedData&) {}
  DerivedData& operator=(const DerivedData&) = delete;
  ~DerivedData() = default;

  /// Result of make() at the first call with this T and key; two simultaneous calls may both compute it, and get the same object.
  /// The result of make() must depend on the model and `key` only. If it throws, nothing is stored.
  template <class T, class Make>
  [[nodiscard]] std::shared_ptr<const T> get(const std::string& key, const Make& make) const {
    const Key place{typeid(T), key};
    if (auto known = find(place)) return std::static_pointer_cast<const T>(known);
    return std::static_pointer_cast<const T>(keep(place, std::make_shared<const T>(make())));
  }

 private:
  using Key = std::pair<std::type_index, std::string>;
  using Value = std::shared_ptr<const void>;

  [[nodiscard]] Value find(const Key& key) const {
    const std::scoped_lock lock(mutex_);
    const auto known = values_.find(key);
    return known == values_.end() ? nullptr : known->second;
  }
  Value keep(const Key& key, Value value) const {
    const std::scoped_lock lock(mutex_);
    MUROSIMF_ASSERT(value);
    return values_.emplace(key, std::move(value)).first->second;
  }

  mutable std::mutex mutex_;
  mutable std::map<Key, Value> values_;
};

}  // namespace murosimf
