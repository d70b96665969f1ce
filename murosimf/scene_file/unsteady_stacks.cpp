#include "murosimf/scene_file/unsteady_stacks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/geometry/volume.h"
#include "murosimf/math/assert.h"

namespace murosimf::scene_file {
namespace {

constexpr double gap = 2e-3;         // [m] between bodies that touch
constexpr double most_lambda = 1e3;  // [1] upper end of the search

/// An upright body.
struct Block {
  const BodySpec* spec;
  ModelPtr model;
  geometry::Aabb box;  // [m] world frame
  [[nodiscard]] double bottom() const { return box.center.z - box.half.z; }
  [[nodiscard]] double top() const { return box.center.z + box.half.z; }
};

bool is_flat(const Shape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<Cylinder>(shape) ||
         std::holds_alternative<Convex>(shape);
}

/// Only what rests on a flat face and begins at rest can stand in a stack.
std::optional<Block> block_of(const BodySpec& body) {
  if (!body.shape || body.is_static || !body.present || !is_flat(*body.shape)) return {};
  if (body.roll != 0 || body.pitch != 0 || norm(body.velocity) + norm(body.angular_velocity) > 0) return {};
  if (!catalog::make_contact_law(body.contact)->implicit()) return {};
  auto box = geometry::fit<geometry::Aabb>(*body.shape, {{}, attitude_of(body)});
  box.center += Vec3d{body.position.x, body.position.y, body.position.z + box.half.z} - Vec3d{0, 0, box.center.z};
  return Block{&body, body_model(body), box};
}

bool lies_on(const Block& upper, const Block& lower) {
  if (&upper == &lower || std::abs(upper.bottom() - lower.top()) >= gap) return false;
  const Vec3d apart = upper.box.center - lower.box.center, reach = upper.box.half + lower.box.half;
  return std::abs(apart.x) < reach.x && std::abs(apart.y) < reach.y;
}

/// Sorts from the ground upwards.
using Column = std::vector<const Block*>;

/// The column on a body; empty if several bodies lie on one, or one on several.
Column column_on(const Block& first, const std::vector<Block>& blocks) {
  Column column{&first};
  while (column.size() < blocks.size()) {
    const Block& last = *column.back();
    const auto on_last = [&](const Block& block) { return lies_on(block, last); };
    const auto next = std::ranges::find_if(blocks, on_last);
    if (next == blocks.end()) break;
    if (std::ranges::count_if(blocks, on_last) > 1) return {};
    if (std::ranges::count_if(blocks, [&](const Block& block) { return lies_on(*next, block); }) > 1) return {};
    column.push_back(&*next);
  }
  return column;
}

/// K [N m/rad] of the contact between a body and the one below, for leaning along `axis` (x or y).
double spring(const SceneSpec& spec, const Column& column, std::size_t i, double Vec3d::*axis) {
  MUROSIMF_ASSERT(i < column.size());
  const Block& upper = *column[i];
  const Surface own{.material = upper.spec->material};
  double low = upper.box.center.*axis - upper.box.half.*axis, high = low + 2 * upper.box.half.*axis;
  collision::ContactParameters contact;
  if (i == 0) {
    contact =
        collision::contact_parameters(*upper.model, spec.materials.find(own, {.material = spec.field.surface}), {});
  } else {
    const Block& lower = *column[i - 1];
    const PairSurface pair = spec.materials.find(own, {.material = lower.spec->material});
    contact = collision::contact_parameters(*upper.model, *lower.model, pair, {});
    low = std::max(low, lower.box.center.*axis - lower.box.half.*axis);
    high = std::min(high, lower.box.center.*axis + lower.box.half.*axis);
  }
  const double arm = (high - low) / 2;
  return 4 * contact.stiffness * arm * arm;
}

/// Whether K - lambda G is positive definite: all pivots of its elimination are positive.
bool stands(const std::vector<double>& springs, const std::vector<double>& weights, double lambda) {
  double pivot = 1, coupling = 0;
  MUROSIMF_ASSERT(springs.size() == weights.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const double above = i + 1 < springs.size() ? springs[i + 1] : 0;
    pivot = springs[i] + above - lambda * weights[i] - coupling * coupling / pivot;
    if (pivot <= 0) return false;
    coupling = above;
  }
  return true;
}

/// The least lambda of the header, by bisection; `most_lambda` if it is greater.
double reserve(const SceneSpec& spec, const Column& column, double Vec3d::*axis) {
  std::vector<double> springs, weights(column.size());
  for (std::size_t i = 0; i < column.size(); ++i) springs.push_back(spring(spec, column, i, axis));
  double above = 0;  // [kg]
  for (std::size_t i = column.size(); i-- > 0;) {
    const double height = 2 * column[i]->box.half.z;
    weights[i] = -spec.gravity.z * height * (column[i]->spec->mass / 2 + above);
    above += column[i]->spec->mass;
  }
  double low = 0, high = most_lambda;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (stands(springs, weights, middle) ? low : high) = middle;
  }
  return low;
}

std::string line_of(const Column& column, double lambda) {
  double carried = 0;
  for (const Block* block : column) carried += block->spec->mass;
  const std::string& lowest = column[0]->spec->name;
  constexpr double grain = 10, margin = 1.05;  // [1] of the number that is named
  return fmt::format(
      "{} with {} more on it ({:.3g} kg in all) falls at any rate of steps: the springs of its contacts are too soft "
      "for a column like this; {:.1f} times smaller 'static_deflection' of their pairs of materials would carry it",
      lowest, column.size() - 1, carried, std::ceil(grain * margin / lambda) / grain);
}

}  // namespace

/// Only implicit laws have this limit.
std::vector<std::string> unsteady_stacks(const SceneSpec& spec) {
  if (spec.gravity.z >= 0 || !catalog::make_body_contact_law(spec.body_contact)->implicit()) return {};
  std::vector<Block> blocks;
  for (const BodySpec& body : spec.bodies) {
    if (auto block = block_of(body)) blocks.push_back(std::move(*block));
  }
  std::vector<std::string> lines;
  for (const Block& block : blocks) {
    if (std::abs(block.bottom()) > gap) continue;
    const Column column = column_on(block, blocks);
    if (column.size() < 2) continue;
    const double lambda = std::min(reserve(spec, column, &Vec3d::x), reserve(spec, column, &Vec3d::y));
    if (lambda < 1) lines.push_back(line_of(column, lambda));
  }
  return lines;
}

}  // namespace murosimf::scene_file
