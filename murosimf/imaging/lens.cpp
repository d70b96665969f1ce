#include "murosimf/imaging/lens.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/imaging/shared_value.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

struct Model {
  std::string_view name;
  std::size_t least, most;  ///< coefficients
  std::string_view coefficients;
};

constexpr std::array<Model, 5> models{{{"perspective", 0, 0, "none"},
                                       {"plumb_bob", 4, 5, "k1 k2 p1 p2 and perhaps k3"},
                                       {"rational_polynomial", 8, 8, "k1 k2 p1 p2 k3 k4 k5 k6"},
                                       {"equidistant", 1, 4, "k1 to k4, the last may be missing"},
                                       {"ray_polynomial", 1, 6, "a1 to a6, the last may be missing"}}};

const Model& model_named(std::string_view name) {
  const auto* const found = std::ranges::find(models, name, &Model::name);
  if (found == models.end()) throw SetupError(unknown_name("lens model", name, lens_models()));
  return *found;
}

void check_size(std::string_view name, int size) {
  constexpr int most = 8192;
  if (size >= 1 && size <= most) return;
  throw SetupError(fmt::format("the picture's {} is {}; it must be 1 to {} pixels", name, size, most));
}

void check_focal_length(std::string_view name, double value) {
  if (std::isfinite(value) && value > 0) return;
  throw SetupError(fmt::format("the focal length {} is {}; it must be above 0, in pixels", name, value));
}

void check_center(std::string_view name, double value, int size) {
  if (value >= -size && value <= 2.0 * size) return;
  throw SetupError(fmt::format("the center {} is {}; it must be {} to {}, in pixels", name, value, -size, 2 * size));
}

void check_skew(double skew, double fx) {
  if (std::abs(skew) < fx) return;
  throw SetupError(fmt::format("the skew is {}; its size must be below the focal length fx, {}, in pixels", skew, fx));
}

void check_coefficients(const Model& model, const std::vector<double>& numbers) {
  if (numbers.size() < model.least || numbers.size() > model.most) {
    throw SetupError(fmt::format("'{}' has {} coefficients; it needs {}: {}", model.name, numbers.size(),
                                 model.least == model.most ? fmt::format("{}", model.most)
                                                           : fmt::format("{} to {}", model.least, model.most),
                                 model.coefficients));
  }
  const auto wrong = std::ranges::find_if_not(numbers, [](double x) { return std::isfinite(x); });
  if (wrong == numbers.end()) return;
  throw SetupError(fmt::format("coefficient {} of '{}' is {}; it must be a finite number", wrong - numbers.begin() + 1,
                               model.name, *wrong));
}

const LensSpec& checked(const LensSpec& spec) {
  const Model& model = model_named(spec.model);
  check_size("width", spec.width);
  check_size("height", spec.height);
  check_focal_length("fx", spec.fx);
  check_focal_length("fy", spec.fy);
  check_center("cx", spec.cx, spec.width);
  check_center("cy", spec.cy, spec.height);
  check_skew(spec.skew, spec.fx);
  check_coefficients(model, spec.coefficients);
  if (spec.model == "ray_polynomial" && !(spec.coefficients[0] > 0)) {
    throw SetupError(fmt::format("coefficient a1 of 'ray_polynomial' is {}; it must be above 0", spec.coefficients[0]));
  }
  return spec;
}

using SharedDistortion = std::shared_ptr<const PlaneDistortion>;

std::variant<SharedDistortion, AnglePolynomial> map_of(const LensSpec& spec) {
  if (spec.model == "equidistant") return AnglePolynomial::equidistant(spec.coefficients);
  if (spec.model == "ray_polynomial") return AnglePolynomial::powers(spec.coefficients);
  // the search for the fold takes long, and a team has a dozen equal cameras: results are shared
  return shared_value<PlaneDistortion>(spec.coefficients, [&] { return PlaneDistortion(spec.coefficients); });
}

std::optional<PlanePoint> seen(const SharedDistortion& map, const Vec3d& p) {
  if (!(p.z > 0)) return std::nullopt;
  const PlanePoint point{p.x / p.z, p.y / p.z};
  if (!map->reaches(point)) return std::nullopt;
  return map->at(point).to;
}

std::optional<PlanePoint> seen(const AnglePolynomial& map, const Vec3d& p) {
  const double aside = std::sqrt(p.x * p.x + p.y * p.y);
  // on the axis the direction of the shift is undefined, and zero
  if (aside == 0) return p.z > 0 ? std::optional(PlanePoint{}) : std::nullopt;
  const double angle = std::atan2(aside, p.z);
  if (!(angle <= map.widest_angle())) return std::nullopt;
  const double r = map.at(angle).value / aside;
  return PlanePoint{r * p.x, r * p.y};
}

std::optional<Vec3d> looked(const SharedDistortion& map, const PlanePoint& d) {
  const auto p = map->undistorted(d);
  if (!p) return std::nullopt;
  const double scale = 1 / std::sqrt(1 + p->x * p->x + p->y * p->y);
  return Vec3d{scale * p->x, scale * p->y, scale};
}

std::optional<Vec3d> looked(const AnglePolynomial& map, const PlanePoint& d) {
  const double r = std::sqrt(d.x * d.x + d.y * d.y);
  if (r == 0) return Vec3d{0, 0, 1};
  const auto angle = map.angle(r);
  if (!angle) return std::nullopt;
  const double aside = std::sin(*angle) / r;
  return Vec3d{aside * d.x, aside * d.y, std::cos(*angle)};
}

double widest(const SharedDistortion& map) { return map->widest_angle(); }
double widest(const AnglePolynomial& map) { return map.widest_angle(); }

}  // namespace

const std::vector<std::string_view>& lens_models() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    list.reserve(models.size());
    for (const Model& model : models) list.push_back(model.name);
    return list;
  }();
  return names;
}

Pixel pixel_at(const LensSpec& spec, const PlanePoint& d) noexcept {
  return {spec.fx * d.x + spec.skew * d.y + spec.cx, spec.fy * d.y + spec.cy};
}

Lens::Lens(const LensSpec& spec) : spec_(checked(spec)), map_(map_of(spec)) {}

bool Lens::plain() const noexcept {
  const bool none = std::ranges::all_of(spec_.coefficients, [](double x) { return x == 0; });
  return none && spec_.skew == 0 && std::holds_alternative<SharedDistortion>(map_);
}

std::optional<Pixel> Lens::project(const Vec3d& point) const noexcept {
  const auto d = std::visit([&](const auto& map) { return seen(map, point); }, map_);
  if (!d) return std::nullopt;
  return pixel_at(spec_, *d);
}

std::optional<Vec3d> Lens::ray(const Pixel& pixel) const noexcept {
  const double y = (pixel.v - spec_.cy) / spec_.fy;
  const PlanePoint d{(pixel.u - spec_.cx - spec_.skew * y) / spec_.fx, y};
  return std::visit([&](const auto& map) { return looked(map, d); }, map_);
}

double Lens::widest_angle() const noexcept {
  return std::visit([](const auto& map) { return widest(map); }, map_);
}

double Lens::angle(const Pixel& pixel) const noexcept {
  const auto r = ray(pixel);
  return r ? std::atan2(std::sqrt(r->x * r->x + r->y * r->y), r->z) : widest_angle();
}

double Lens::corner_angle() const noexcept {
  const double right = spec_.width - 0.5, bottom = spec_.height - 0.5;
  return std::max(std::max(angle({-0.5, -0.5}), angle({right, -0.5})),
                  std::max(angle({-0.5, bottom}), angle({right, bottom})));
}

Fov Lens::fov() const noexcept {
  const double right = spec_.width - 0.5, bottom = spec_.height - 0.5;
  const double falling = angle({-0.5, -0.5}) + angle({right, bottom});
  const double rising = angle({-0.5, bottom}) + angle({right, -0.5});
  return {angle({-0.5, spec_.cy}) + angle({right, spec_.cy}), angle({spec_.cx, -0.5}) + angle({spec_.cx, bottom}),
          std::max(falling, rising)};
}

std::string Lens::fold_warning() const {
  if (plain()) return {};
  constexpr int most = 200;  // samples to a side
  const int columns = std::min(spec_.width, most), rows = std::min(spec_.height, most);
  const auto place = [](int i, int count, int size) { return count > 1 ? (size - 1.0) * i / (count - 1) : 0.0; };
  int blind = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (!ray({place(i, columns, spec_.width), place(j, rows, spec_.height)})) ++blind;
    }
  }
  if (blind == 0) return {};
  return fmt::format("the distortion folds over at {:.1f} deg, inside the picture: {:.1f} % of the pixels see nothing",
                     widest_angle() * 180 / pi, 100.0 * blind / (columns * rows));
}

}  // namespace murosimf::imaging
