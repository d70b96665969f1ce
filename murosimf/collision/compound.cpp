#include "murosimf/collision/compound.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/collision/interpenetration.h"
#include "murosimf/collision/relief/relief.h"
#include "murosimf/collision/robot_tree.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

geometry::AnyTree make_tree(const Model& model, std::span<const CollidingShape> shapes,
                            const CompoundOptions& options) {
  std::vector<geometry::TreePart> parts;
  for (const CollidingShape& shape : shapes) {
    const PlacedShape& placed = shape.placed;
    parts.push_back({shape.object, &placed.shape, {placed.position, placed.orientation}});
  }
  const auto layout =
      options.structured ? robot_tree(model, shapes) : geometry::split_top_down(rest_spheres(model, shapes));
  // prisms of uneven ground are deep and have narrow sides: spheres about them would mostly be empty
  const bool uneven = !model.having(properties::relief).empty();
  return geometry::make_tree(uneven ? "aabb" : options.volume, parts, layout, options.margin);
}

std::vector<double> thicknesses_of(const Model& model, std::span<const CollidingShape> shapes) {
  std::vector<double> result(static_cast<std::size_t>(model.size()));
  for (const CollidingShape& shape : shapes) {
    MUROSIMF_ASSERT(shape.object >= 0 && shape.object < model.size());
    double& thickest = result[static_cast<std::size_t>(shape.object)];
    const ReliefPtr* relief = model.find(properties::relief, shape.object);
    thickest = std::max(thickest, relief ? (*relief)->thickness() : thickness(shape.placed.shape));
  }
  return result;
}

std::string key_of(const CompoundOptions& options) {
  std::string key = fmt::format("{} {} {} {}", options.volume, options.structured, options.inner, options.margin);
  if (!options.inner) return key;
  for (const auto& [first, second] : options.excluded) key += fmt::format(" {} {}", first, second);
  return key;
}

}  // namespace

Compound::Parts::Parts(const Model& model, const CompoundOptions& options)
    : shapes(colliding_shapes(model)),
      tree(make_tree(model, shapes, options)),
      inner_pairs(options.inner ? InnerPairs(model, shapes, options.excluded) : InnerPairs()),
      reach(farthest_reach(model)),
      thicknesses(thicknesses_of(model, shapes)),
      all_touch(std::ranges::all_of(shapes, is_usual<PlacedShape>, &CollidingShape::placed)) {}

Compound::Compound(const Model& model, const CompoundOptions& options)
    : parts_(model.derived().get<Parts>(key_of(options), [&] { return Parts(model, options); })), tree_(parts_->tree) {}

Compound compound_of(const Entity& entity, const CompoundOptions& options) {
  return with_context("entity '" + entity.name() + "'", [&] { return Compound(entity.model(), options); });
}

bool Compound::still_fits(std::span<const Vec3d> r, std::span<const Mat3d> R) const noexcept {
  return std::visit([&](const auto& tree) { return tree.still_fits(r, R); }, tree_);
}

void Compound::refit(std::span<const Vec3d> r, std::span<const Mat3d> R) noexcept {
  const auto refit_tree = [&](auto& tree) {
    tree.refit(r, R);
    if (!tree.empty()) around_ = sphere_around(tree.volume(0));
  };
  std::visit(refit_tree, tree_);
}

}  // namespace murosimf::collision
