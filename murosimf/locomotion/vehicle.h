/// vehicle.h - the wheels of a car, found in a model for Ackermann steering.
///
/// Found by their geometry, not by name, with all joints at zero:
///   * a wheel is a hinge across the car (y) without ends that carries a cylinder about its axis;
///   * it is driven if its servo follows a rate (dynamics/servo/servo_law.h);
///   * it is steered if the last hinge about z between the base and the wheel has ends; this is its pivot.
/// The car turns about a point on the line of the axle that does not steer: the middle of the wheels without pivot, or of
/// all wheels if every one has a pivot.
#pragma once

#include <vector>

#include "murosimf/model/model.h"

namespace murosimf::locomotion {

struct Wheel {
  int joint = 0;    ///< object that turns the wheel
  double sign = 1;  ///< -1 where its axis points to the right
  bool driven = false;
  double radius = 0;         ///< [m]
  int steering = -1;         ///< object that steers it; -1: none
  double steering_sign = 1;  ///< -1 where that axis points down
  double x = 0, y = 0;  ///< [m] of the pivot, or of the wheel if it has none, from the middle of the unsteered axle
  double outside = 0;   ///< [m] distance of the wheel's middle to the left of its pivot
};

struct Vehicle {
  std::vector<Wheel> wheels;
  double least_curvature = 0, greatest_curvature = 0;  ///< [1/m] of its path, left positive; set by the steering's ends
};

/// Throws SetupError if there is no wheel, or if none is driven.
[[nodiscard]] Vehicle find_vehicle(const Model& model);

}  // namespace murosimf::locomotion
