/// plot_book.h - curves over simulated time for plots, in bounded memory.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace murosimf::viewer {

/// One number over time.
class Curve {
 public:
  /// Keeps at most this number of samples: beyond it, every other one of the older half is dropped.
  explicit Curve(std::size_t most = 4000) : most_(most) {}

  /// A time [s] before the last one means that time has jumped back: later samples are dropped.
  void add(double time, double value);
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// Range of the samples since `begin` [s]; 0 to 1 if there are none. NaN is ignored.
  struct Range {
    double low = 0, high = 1;
  };
  [[nodiscard]] Range range(double begin) const;

 private:
  void thin_out();

  std::size_t most_;
  std::vector<double> times_, values_;
};

/// Curves of one quantity.
struct Plot {
  std::string path;  ///< "blue1.pelvis.position", "blue1.imu.gyroscope"
  std::string unit;
  std::vector<Curve> curves;  ///< by component of the quantity

  void add(double time, const std::vector<double>& numbers);
};

/// Positions of ticks between low and high: multiples of 1, 2 or 5 times a power of ten, about `count` of them.
[[nodiscard]] std::vector<double> ticks(double low, double high, int count);

}  // namespace murosimf::viewer
