/// model.h - a frozen tree of objects with its constant properties; shared by all equal robots.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/chain.h"
#include "murosimf/model/derived_data.h"
#include "murosimf/model/tree.h"

namespace murosimf {

class Model {
 public:
  /// Freezes a chain. Throws SetupError if it does not begin with its only base, if a name appears twice, or if a
  /// mass or inertia is impossible; the message names the object.
  Model(std::string name, Chain chain);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::span<const Object> objects() const { return objects_; }
  [[nodiscard]] int size() const { return static_cast<int>(objects_.size()); }
  [[nodiscard]] const Tree& tree() const { return tree_; }

  /// Indices of all revolute and prismatic joints (paper 3.1).
  [[nodiscard]] std::span<const int> joints() const { return joints_; }
  /// Indices of all objects with mass or shape: those that can feel external forces (paper 3.1).
  [[nodiscard]] std::span<const int> bodies() const { return bodies_; }
  /// Indices of all objects that have the constant property.
  template <class T>
  [[nodiscard]] std::vector<int> having(const Property<T>& property) const {
    return constants_.having(property);
  }

  /// Index of the object with this name or alias. Throws SetupError with the nearest name.
  [[nodiscard]] int object_index(std::string_view name) const;
  [[nodiscard]] std::optional<int> find_object(std::string_view name) const;
  /// All names that object_index accepts.
  [[nodiscard]] std::vector<std::string_view> object_names() const;

  /// Null if the object does not have the constant property.
  template <class T>
  [[nodiscard]] const T* find(const Property<T>& property, int object) const {
    return constants_.find(property, object);
  }
  [[nodiscard]] const ConstantTable& constants() const { return constants_; }
  /// The same tree with other values of its constants. Throws SetupError if a mass or inertia is impossible.
  [[nodiscard]] Model with(ConstantTable constants) const;

  /// Cache of data that follow from the model alone; they live as long as the model.
  [[nodiscard]] const DerivedData& derived() const { return derived_; }

  /// Where an object stands in the frame of the link it is fixed to.
  [[nodiscard]] FixedObject placement(int object) const;

 private:
  void name_all_objects();
  void index_names(const std::vector<std::pair<std::string, int>>& aliases);
  void check_structure() const;
  void check_masses() const;
  void use_constants();

  std::string name_;
  std::vector<Object> objects_;
  ConstantTable constants_;
  Tree tree_;
  std::vector<int> joints_, bodies_;
  std::map<std::string, int, std::less<>> index_;
  DerivedData derived_;
};

using ModelPtr = std::shared_ptr<const Model>;

}  // namespace murosimf
