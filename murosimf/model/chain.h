/// chain.h - fluent construction of a model's tree from the seven basic objects.
///
///     Chain leg = Chain{}.translation({0, 0.05, 0}).revolute("knee", {0, 1, 0}).with(mass, 0.3).endpoint("foot");
///     Model biped("biped", Chain{}.base("pelvis").with(mass, 1.2).fork(leg, other_leg));
///
/// Each call adds one object behind the last; `with` gives the last object a constant property.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "murosimf/model/constants.h"
#include "murosimf/model/object.h"

namespace murosimf {

class Chain {
 public:
  Chain& base(std::string name = "base");
  /// Shift by `offset` [m].
  Chain& translation(const Vec3d& offset, std::string name = {});
  /// Turn by `angle` [rad] about `axis` (any length but zero).
  Chain& rotation(const Vec3d& axis, double angle, std::string name = {});
  Chain& rotation(const Mat3d& turn, std::string name = {});
  /// Hinge about `axis` (any length but zero).
  Chain& revolute(std::string name, const Vec3d& axis);
  /// Slider along `axis` (any length but zero).
  Chain& prismatic(std::string name, const Vec3d& axis);
  Chain& endpoint(std::string name = {});

  /// Two or more branches behind the last object. Three or more become a row of forks, since a fork has two.
  template <class... Chains>
  Chain& fork(const Chain& first, const Chain& second, const Chains&... more) {
    return fork(std::vector<Chain>{first, second, more...});
  }
  /// The same for a number of branches known at run time: none ends the limb, one continues it.
  Chain& fork(const std::vector<Chain>& branches);

  /// Gives the last object a constant property.
  template <class T>
  Chain& with(const Property<T>& property, std::type_identity_t<T> value) {
    constants_.set(property, last_object(), std::move(value));
    objects_[static_cast<std::size_t>(last_object())].structural = false;
    return *this;
  }

  /// The last object only gives the tree its shape (object.h); forks and endpoints without a name do so anyway.
  Chain& structural();
  /// Another name for the last object.
  Chain& alias(std::string name);

  [[nodiscard]] bool empty() const { return objects_.empty(); }
  [[nodiscard]] const std::vector<Object>& objects() const { return objects_; }
  [[nodiscard]] const ConstantTable& constants() const { return constants_; }
  [[nodiscard]] const std::vector<std::pair<std::string, int>>& aliases() const { return aliases_; }

 private:
  Chain& add(Kind kind, std::string name, const Vec3d& vector = {}, const Mat3d& turn = {});
  void append(const Chain& branch, int parent);
  [[nodiscard]] int last_object() const;

  std::vector<Object> objects_;
  ConstantTable constants_;
  std::vector<std::pair<std::string, int>> aliases_;
  int tail_ = -1;        // the object that the next one follows
  bool closed_ = false;  // a fork or an endpoint ends the chain
};

}  // namespace murosimf
