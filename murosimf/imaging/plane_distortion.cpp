#include "murosimf/imaging/plane_distortion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/scalar.h"

namespace murosimf::imaging {
namespace {

constexpr double grazing = 1e-9;  // [rad] from the plane through the lens, where points are too far out for numbers

constexpr double last = pi / 2 - grazing;
constexpr int steps = 900;  // in which a fold is looked for, along a direction of the picture

double angle_of(int step) { return last * step / steps; }

double length(const PlanePoint& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// Of the angles that are looked at.
const std::array<double, steps + 1>& tangents() {
  static const auto table = [] {
    std::array<double, steps + 1> made{};
    for (int step = 1; step <= steps; ++step) made[static_cast<std::size_t>(step)] = std::tan(angle_of(step));
    return made;
  }();
  return table;
}

}  // namespace

PlaneDistortion PlaneDistortion::formula(std::span<const double> coefficients) {
  PlaneDistortion made;
  const std::array<double*, 8> fields{&made.k1_, &made.k2_, &made.p1_, &made.p2_,
                                      &made.k3_, &made.k4_, &made.k5_, &made.k6_};
  for (std::size_t i = 0; i < coefficients.size(); ++i) *fields[i] = coefficients[i];
  return made;
}

PlaneDistortion::PlaneDistortion(std::span<const double> coefficients) : PlaneDistortion(formula(coefficients)) {
  find_widest();
}

void PlaneDistortion::find_widest() {
  const bool tangential = p1_ != 0 || p2_ != 0;
  const int directions = tangential ? 72 : 1;
  widest_ = pi / 2;
  const bool moves = std::ranges::any_of(std::array{k1_, k2_, k3_, k4_, k5_, k6_}, [](double k) { return k != 0; });
  for (int i = 0; i < directions && (moves || tangential); ++i)
    widest_ = std::min(widest_, fold(2 * pi * i / directions));
  reach_ = std::tan(std::min(widest_, pi / 2 - grazing));
}

PlaneDistortion::Scale PlaneDistortion::scale(double r2) const noexcept {
  const double above = 1 + r2 * (k1_ + r2 * (k2_ + r2 * k3_));
  const double below = 1 + r2 * (k4_ + r2 * (k5_ + r2 * k6_));
  const double above_slope = k1_ + r2 * (2 * k2_ + r2 * 3 * k3_);
  const double below_slope = k4_ + r2 * (2 * k5_ + r2 * 3 * k6_);
  const double s = above / below;
  return {s, (above_slope - s * below_slope) / below, below > 0};
}

Slope PlaneDistortion::radial(double r) const noexcept {
  const Scale s = scale(r * r);
  return {r * s.value, s.value + 2 * r * r * s.slope};
}

PlaneMotion PlaneDistortion::at(const PlanePoint& p) const noexcept {
  const auto [x, y] = p;
  const double r2 = x * x + y * y;
  const Scale s = scale(r2);
  const double mixed = 2 * x * y * s.slope + 2 * p1_ * x + 2 * p2_ * y;
  return {{s.value * x + 2 * p1_ * x * y + p2_ * (r2 + 2 * x * x),
           s.value * y + p1_ * (r2 + 2 * y * y) + 2 * p2_ * x * y},
          s.value + 2 * x * x * s.slope + 2 * p1_ * y + 6 * p2_ * x,
          mixed,
          mixed,
          s.value + 2 * y * y * s.slope + 6 * p1_ * y + 2 * p2_ * x};
}

/// At the point that is `r` from the axis in a direction of length 1.
bool PlaneDistortion::folds(double r, const PlanePoint& direction) const {
  const Scale s = scale(r * r);
  const PlaneMotion motion = at({r * direction.x, r * direction.y});
  return !(s.regular && s.value > 0 && motion.determinant() > 0);
}

/// The angle from the axis at which the map folds in one direction of the picture [rad].
double PlaneDistortion::fold(double direction) const {
  const PlanePoint along{std::cos(direction), std::sin(direction)};
  const auto& r = tangents();
  int step = 1;
  while (step <= steps && !folds(r[static_cast<std::size_t>(step)], along)) ++step;
  if (step > steps) return pi / 2;
  double low = angle_of(step - 1), high = angle_of(step);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (folds(std::tan(middle), along) ? high : low) = middle;
  }
  return low;
}

/// Whatever is found within reach is the point, for there is only one: so the quick way may fail, but not err.
std::optional<PlanePoint> PlaneDistortion::undistorted(const PlanePoint& distorted) const noexcept {
  if (const auto quick = refined(distorted, distorted)) return quick;
  return refined(without_tangential(distorted), distorted);
}

/// The point that would go to `distorted`, or as far in its direction as the lens reaches, were p1 = p2 = 0.
PlanePoint PlaneDistortion::without_tangential(const PlanePoint& distorted) const noexcept {
  const double target = length(distorted);
  if (target == 0) return distorted;
  double r = reach_;
  if (target < radial(reach_).value) {
    constexpr double rough = 1e-4;  // it will be refined
    r = monotonic_root([this](double x) { return radial(x); }, target, 0, reach_, target, rough);
  }
  return {distorted.x * (r / target), distorted.y * (r / target)};
}

/// Newton's method in the plane: steps are halved until they come nearer and stay within reach.
std::optional<PlanePoint> PlaneDistortion::refined(PlanePoint p, const PlanePoint& distorted) const noexcept {
  const double enough = 1e-13 * (1 + length(distorted));
  const auto miss = [&](const PlaneMotion& m) { return PlanePoint{distorted.x - m.to.x, distorted.y - m.to.y}; };
  PlaneMotion motion = at(p);
  PlanePoint left = miss(motion);
  for (int i = 0; i < 60 && length(left) > enough; ++i) {
    const double determinant = motion.determinant();
    const PlanePoint step{(motion.yy * left.x - motion.xy * left.y) / determinant,
                          (motion.xx * left.y - motion.yx * left.x) / determinant};
    double share = 1;
    PlanePoint next;
    do {
      next = {p.x + share * step.x, p.y + share * step.y};
      motion = at(next);
      share /= 2;
    } while (share > 1e-6 && !(reaches(next) && length(miss(motion)) < length(left)));
    if (share <= 1e-6) break;
    p = next;
    left = miss(motion);
  }
  if (!(length(left) <= 10 * enough) || !reaches(p)) return std::nullopt;
  return p;
}

}  // namespace murosimf::imaging
