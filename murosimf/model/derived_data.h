/// derived_data.h - what others work out from a model that never changes: once for all who have the model, whoever asks first.
///
/// Models are shared by all equal robots, also of many worlds in many threads. So what follows from a model alone (which shapes
/// collide, the layout of their tree) need not be worked out and kept for every robot.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <utility>

namespace murosimf {

class DerivedData {
 public:
  DerivedData() = default;
  /// The copy of a model may get other constants: it begins with nothing.
  DerivedData(const DerivedData&) {}
  DerivedData& operator=(const DerivedData&) = delete;
  ~DerivedData() = default;

  /// make() of the first who asked with this T and key; two who ask at the same time may both work it out, and get the same one.
  /// What make() returns must follow from the model and `key` alone. If it throws, nothing is kept.
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
    return values_.emplace(key, std::move(value)).first->second;
  }

  mutable std::mutex mutex_;
  mutable std::map<Key, Value> values_;
};

}  // namespace murosimf
