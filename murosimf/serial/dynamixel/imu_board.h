/// imu_board.h - an IMU on the bus: a device of its own id, whose registers have the last sample of gyroscope and accelerometer.
///
/// Addresses, two bytes each, the lower one first, two's complement:
///     36  counts samples, from 0 again after 65535
///     38  simulated time of the sample [ms], likewise
///     40, 42, 44  gyroscope x, y, z [0.001 rad/s]
///     46, 48, 50  accelerometer x, y, z [0.01 m/s^2]: +9.81 m/s^2 up at rest
/// Model number at 0, firmware, id, baud rate and return delay time where servos of its protocol have them; status return level at 16.
#pragma once

#include "murosimf/serial/dynamixel/bus_device.h"

namespace murosimf::serial::dynamixel {

inline constexpr std::int32_t imu_model_number = 18765;  ///< no product of ROBOTIS

struct ImuSample {
  std::uint64_t count = 0;
  double time = 0;                        ///< [s]
  std::span<const double> gyroscope;      ///< [rad/s] three
  std::span<const double> accelerometer;  ///< [m/s^2] three
};

class ImuBoard final : public BusDevice {
 public:
  /// `answers_broadcast`: whether it answers broadcast pings, which programs for the vendor's products only do not expect.
  ImuBoard(Protocol protocol, std::uint8_t id, bool answers_broadcast = false);
  [[nodiscard]] bool answers_broadcast() const override { return answers_broadcast_; }
  void sense(const ImuSample& sample);

 private:
  bool answers_broadcast_;
};

}  // namespace murosimf::serial::dynamixel
