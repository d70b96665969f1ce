/// batch_observations.h - a row of numbers about a robot, put together by names: what policies see.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "murosimf/api/named_rows.h"

namespace murosimf::api {

class BatchObservations {
 public:
  BatchObservations() = default;  ///< rows of no numbers
  /// Throws UnknownName, and InputError for what are no numbers.
  BatchObservations(const Entity& robot, const JointRows& joints, const std::vector<std::string>& names);

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Numbers of a row.
  [[nodiscard]] std::size_t width() const { return width_; }
  /// Of a robot that was built alike.
  void fill(const Entity& robot, float* row) const;

 private:
  using Base = Vec3d (*)(const Entity& robot);
  struct Part {
    Base base = nullptr;  // three numbers of the base; null: those of a property
    NamedRows named;
  };
  [[nodiscard]] static Base base_of(const std::string& name);
  [[nodiscard]] static Part part_of(const Entity& robot, const JointRows& joints, const std::string& name);

  std::vector<std::string> names_;
  std::vector<Part> parts_;
  std::size_t width_ = 0;
};

}  // namespace murosimf::api
