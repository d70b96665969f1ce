#include "murosimf/imaging/angle_polynomial.h"

#include <algorithm>

#include "murosimf/math/scalar.h"

namespace murosimf::imaging {

AnglePolynomial AnglePolynomial::equidistant(std::span<const double> k) {
  AnglePolynomial made;
  made.a_[0] = 1;
  for (std::size_t i = 0; i < k.size(); ++i) made.a_[2 * i + 2] = k[i];
  made.find_widest();
  return made;
}

AnglePolynomial AnglePolynomial::powers(std::span<const double> a) {
  AnglePolynomial made;
  std::ranges::copy(a, made.a_.begin());
  made.find_widest();
  return made;
}

Slope AnglePolynomial::at(double angle) const noexcept {
  double value = 0, slope = 0;  // Horner's scheme for the value and its derivative
  for (std::size_t i = a_.size(); i-- > 0;) {
    slope = slope * angle + value;
    value = value * angle + a_[i];
  }
  return {value * angle, slope * angle + value};
}

void AnglePolynomial::find_widest() {
  constexpr int steps = 3600;  // fine enough not to miss a fold; bisection then makes it exact
  int step = 0;
  while (step <= steps && at(pi * step / steps).slope > 0) ++step;
  if (step > steps) {
    widest_ = pi;
    return;
  }
  double low = pi * std::max(0, step - 1) / steps, high = pi * step / steps;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).slope > 0 ? low : high) = middle;
  }
  widest_ = low;
}

std::optional<double> AnglePolynomial::angle(double radius) const noexcept {
  if (!(radius <= at(widest_).value)) return std::nullopt;
  return monotonic_root([this](double t) { return at(t); }, radius, 0, widest_, radius / a_[0]);
}

}  // namespace murosimf::imaging
