/// plot_book.h - numbers over simulated time that are to be plotted, kept in a bounded memory.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace murosimf::viewer {

/// One number over time.
class Curve {
 public:
  /// Keeps at most so many samples: when they are more, every other one of the older half goes.
  explicit Curve(std::size_t most = 4000) : most_(most) {}

  /// Times [s] that do not grow say that time has jumped back: what is later is forgotten.
  void add(double time, double value);
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// Of the samples since `begin` [s]; 0 to 1 if there are none. NaN does not count.
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
  std::vector<Curve> curves;  ///< by number of the quantity

  void add(double time, const std::vector<double>& numbers);
};

/// Places of ticks between low and high: multiples of 1, 2 or 5 times a power of ten, about `count` of them.
[[nodiscard]] std::vector<double> ticks(double low, double high, int count);

}  // namespace murosimf::viewer
