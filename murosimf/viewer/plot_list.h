/// plot_list.h - which properties and sensors are plotted, and their curves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/viewer/inspection.h"
#include "murosimf/viewer/plot_book.h"
#include "murosimf/viewer/scene_outline.h"

namespace murosimf::viewer {

struct PlotRequest {
  ObjectPath path;       ///< of a property
  std::string property;  ///< or "imu.gyroscope" of a sensor
  bool sensor = false;
  Plot plot;
};

class PlotList {
 public:
  /// Nothing happens if it is there already.
  void add(const SceneOutline& outline, const ObjectPath& path, const std::string& property, bool sensor);
  void remove(std::size_t number);
  void remove_sensors();

  [[nodiscard]] bool empty() const noexcept { return requests_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return requests_.size(); }
  [[nodiscard]] const PlotRequest& operator[](std::size_t number) const noexcept {
    MUROSIMF_ASSERT(number < requests_.size());
    return requests_[number];
  }

  /// Adds to an inspection what they need of it.
  void request(InspectionRequest& request) const;
  /// Adds to the curves what has been seen.
  void take(const Inspection& seen);

 private:
  std::vector<PlotRequest> requests_;
};

}  // namespace murosimf::viewer
