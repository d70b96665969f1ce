#include "murosimf/multibody/spatial_tendon.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/multibody/joint_axis.h"

namespace murosimf::multibody {
namespace {

/// Calls with each link from `a` up to the last one that it has in common with `b`, which is left out.
template <class Call>
void climb(const Tree& tree, int a, int b, const Call& call) {
  while (a != b) {
    int& later = a > b ? a : b;  // parents come first, so the later one is no ancestor of the other
    call(later, &later == &a);
    later = tree.links[later].parent;
  }
}

}  // namespace

TendonPath::TendonPath(const Model& model, const SpatialTendon& tendon) : tree_(&model.tree()) {
  for (const SpatialTendon::Branch& given : tendon.branches) {
    if (!(given.divisor > 0) || !std::isfinite(given.divisor)) {
      throw SetupError(fmt::format("the divisor {} of a branch must be finite and more than 0", given.divisor));
    }
    Branch branch{1 / given.divisor, {}};
    for (const SpatialTendon::Part& one : given.parts) branch.parts.push_back(part(model, one));
    bool after_obstacle = true;
    for (const Part& one : branch.parts) {
      if (one.obstacle.radius > 0 && after_obstacle) throw SetupError("an obstacle needs a point before and behind it");
      after_obstacle = one.obstacle.radius > 0;
    }
    if (after_obstacle) throw SetupError("a branch begins and ends with a point");
    branches_.push_back(std::move(branch));
  }
  if (branches_.empty()) throw SetupError("it has no branch");
  find_joints();
}

TendonPath::Part TendonPath::part(const Model& model, const SpatialTendon::Part& given) {
  const auto placed = [&](const SpatialTendon::Place& at) {
    const FixedObject object = model.placement(model.object_index(at.object));
    return std::pair{object.link, Transformd{object.offset, object.turn} * at.place};
  };
  const auto [link, place] = placed(given.at);
  Part result{link, place, {given.radius, given.cylinder}, -1, {}};
  if (!(given.radius >= 0) || !std::isfinite(given.radius)) {
    throw SetupError(fmt::format("the radius {} of an obstacle must be finite and more than 0", given.radius));
  }
  if (!given.side) return result;
  const auto [side, where] = placed(*given.side);
  result.side_link = side;
  result.side = where.position;
  return result;
}

void TendonPath::find_joints() {
  std::vector<bool> placed(tree_->links.size());
  column_.assign(tree_->links.size(), -1);
  std::size_t longest = 0;
  const auto add = [&](int link) {
    for (int l = link; l > 0; l = tree_->links[l].parent) placed[l] = true;
  };
  for (const Branch& branch : branches_) {
    longest = std::max(longest, branch.parts.size());
    for (std::size_t i = 0; i < branch.parts.size(); ++i) {
      add(branch.parts[i].link);
      add(branch.parts[i].side_link);
      if (i == 0) continue;
      climb(*tree_, branch.parts[i - 1].link, branch.parts[i].link, [&](int link, bool) { column_[link] = 0; });
    }
  }
  for (std::size_t l = 1; l < placed.size(); ++l) {
    if (placed[l]) links_.push_back(static_cast<int>(l));
    if (column_[l] < 0) continue;
    column_[l] = static_cast<int>(joints_.size());
    joints_.push_back(tree_->links[l].object);
  }
  places_.resize(placed.size());
  axes_.resize(placed.size());
  string_.resize(longest);
}

double TendonPath::look(std::span<const double> q, std::span<double> slopes) const noexcept {
  MUROSIMF_ASSERT(slopes.size() == joints_.size());
  std::fill(slopes.begin(), slopes.end(), 0.0);
  place_links(q);
  double whole = 0;
  for (const Branch& branch : branches_) {
    lay(branch);
    double length = 0;
    const auto straight = [&](std::size_t i, const Vec3d& a, std::size_t j, const Vec3d& b) {
      const double piece = norm(b - a);
      length += piece;
      if (!(piece > 0)) return;  // no direction
      const Vec3d force = (branch.share / piece) * (b - a);
      const int one = branch.parts[i].link, other = branch.parts[j].link;
      climb(*tree_, one, other, [&](int link, bool of_first) {
        const Vec3d& axis = axes_[link];
        const Vec3d arm = (of_first ? a : b) - places_[link].position;
        const bool slides = tree_->links[link].kind == LinkKind::prismatic;
        const double slope = dot(force, slides ? axis : cross(axis, arm));
        slopes[column_[link]] += of_first ? -slope : slope;
      });
    };
    lay_string(std::span(string_).first(branch.parts.size()), straight, [&](double piece) { length += piece; });
    whole += branch.share * length;
  }
  return whole;
}

void TendonPath::place_links(std::span<const double> q) const noexcept {
  for (const int l : links_) {
    const Link& link = tree_->links[l];
    MUROSIMF_ASSERT(link.parent >= 0 && static_cast<std::size_t>(link.object) < q.size());
    const Transformd& parent = places_[link.parent];
    Transformd& place = places_[l];
    place = {parent.position + parent.orientation * link.offset,
             link.turned ? parent.orientation * link.turn : parent.orientation};
    axes_[l] = joint_axis(place.orientation, link);
    if (link.kind == LinkKind::prismatic) {
      place.position += q[link.object] * axes_[l];
    } else {
      place.orientation = place.orientation * rotation(link.axis, q[link.object]);
    }
  }
}

void TendonPath::lay(const Branch& branch) const noexcept {
  for (std::size_t i = 0; i < branch.parts.size(); ++i) {
    const Part& part = branch.parts[i];
    MUROSIMF_ASSERT(i < string_.size());
    string_[i] = {places_[part.link] * part.place, part.obstacle};
    if (part.side_link < 0) continue;
    const Transformd& link = places_[part.side_link];
    const Vec3d side = link.position + link.orientation * part.side;
    string_[i].obstacle.sided = true;
    string_[i].obstacle.side = transpose(string_[i].place.orientation) * (side - string_[i].place.position);
  }
}

}  // namespace murosimf::multibody
