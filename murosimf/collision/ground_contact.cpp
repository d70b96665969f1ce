#include "murosimf/collision/ground_contact.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/collision/ground_lanes.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

constexpr double exchange_speed = 0.05;   // [m/s] 0.05 mm in a step of 1 ms is invisible
constexpr std::size_t usual_points = 12;  // two feet and more; memory for more points is allocated when needed

}  // namespace

GroundContact::GroundContact(Setup& setup, const Entity* environment, std::shared_ptr<const ContactLaw> law,
                             const MaterialTable& materials)
    : entity_(setup.entity()),
      environment_entity_(environment),
      materials_(materials),
      gravity_(setup.world().gravity),
      law_(std::move(law)),
      finder_(setup.entity(), environment),
      number_(setup.world().index_of(&setup.entity())),
      environment_(setup.world().index_of(environment)),
      soft_terms_{{}, setup.entity().options().step_multiple * seconds(setup.period())},
      stiff_terms_(soft_terms_),
      r_(setup.read(properties::position)),
      R_(setup.read(properties::orientation)),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      applied_force_(setup.input(properties::applied_force, {})),
      dynamic_(setup.input(properties::dynamic, 1)[0]),
      external_force_(setup.write(properties::external_force)),
      external_damping_(setup.write(properties::external_damping)),
      set_(setup.write(contacts)[0]),
      interface_(setup.write(contact_interface)[0]) {
  MUROSIMF_ASSERT(law_ && soft_terms_.dt > 0);
  make_terms();
}

void GroundContact::make_terms() {
  for (ContactTerms* terms : {&soft_terms_, &stiff_terms_}) terms->parameters.clear();
  environment_objects_.clear();
  thicknesses_.clear();
  finder_.for_meetings([&](const GroundFinder::Meeting& meeting) {
    const PairSurface pair = materials_.find(meeting.own, meeting.other);
    for (ContactTerms* terms : {&soft_terms_, &stiff_terms_}) {
      ContactParameters p = contact_parameters(model(), pair, {terms->dt, terms == &stiff_terms_});
      p.friction_direction = pair.friction_anisotropy * meeting.friction_direction;
      p.rolling_direction = pair.rolling_anisotropy * meeting.friction_direction;
      terms->parameters.push_back(p);
    }
    environment_objects_.push_back(meeting.object);
    thicknesses_.push_back(meeting.thickness);
  });
  MUROSIMF_ASSERT(soft_terms_.parameters.size() == environment_objects_.size() &&
                  stiff_terms_.parameters.size() == thicknesses_.size());
}

void GroundContact::initialize() {
  terms_are_stiff_ = false;
  interface_ = ContactInterface{.law = law_.get(), .terms = soft_terms_};
  const ContactSet none;
  set_ = none;  // a copy: it keeps its memory for the next start
  set_.environment = environment_;
  set_.environment_objects = environment_objects_;
  set_.rest_force.resize(static_cast<std::size_t>(model().size()));
  const std::size_t most = std::min(finder_.most_on_planes(), usual_points);
  set_.points.reserve(most);
  previous_.reserve(most);
  set_.loaded.reserve(most);
  std::fill(external_force_.begin(), external_force_.end(), Wrenchd{});
  std::fill(external_damping_.begin(), external_damping_.end(), Sym6d{});
}

/// Its points belong to other shapes: they are discarded, and present penetrations are resolved slowly.
void GroundContact::model_exchanged(const Entity& entity) {
  if (&entity != &entity_) return;
  finder_ = GroundFinder(entity_, environment_entity_);
  renew_terms();
  set_.environment_objects = environment_objects_;
  set_.points.clear();
}

void GroundContact::exchange_materials(const MaterialTable& materials) {
  materials_ = materials;
  renew_terms();
}

/// The step stays as long as it is.
void GroundContact::renew_terms() {
  make_terms();
  const double dt = interface_.terms.dt;
  interface_.terms = terms_are_stiff_ ? stiff_terms_ : soft_terms_;
  interface_.terms.dt = dt;
}

void GroundContact::exchange_law(std::shared_ptr<const ContactLaw> law) {
  MUROSIMF_ASSERT(law && law_);
  const bool same_memory = law_->island_use() != IslandUse::never && law->island_use() != IslandUse::never;
  law_ = std::move(law);
  if (interface_.law) interface_.law = law_.get();  // else initialize() is still to come
  if (!same_memory) set_.points.clear();
}

/// Whether motion answers contacts itself; six coordinates are those of a rigid body.
bool GroundContact::wants_stiff_terms() const noexcept {
  return law_->implicit() &&
         (model().joints().empty() || (interface_.response && interface_.response->coordinates() > 6));
}

/// Points keep their tangential force with other constants, and approach their new depth slowly.
void GroundContact::choose_terms() noexcept {
  const bool stiff = wants_stiff_terms();
  const ContactTerms& wanted = stiff ? stiff_terms_ : soft_terms_;
  MUROSIMF_ASSERT(soft_terms_.parameters.size() == stiff_terms_.parameters.size());
  if (stiff != set_.stiff) {
    const ContactTerms& before = stiff ? soft_terms_ : stiff_terms_;
    for (ContactPoint& c : set_.points) {
      const double kt = wanted.parameters[c.surface].tangent_stiffness;
      c.stretch = (before.parameters[c.surface].tangent_stiffness / kt) * c.stretch;
      c.lift = exchange_speed;
    }
    set_.stiff = stiff;
  }
  if (stiff != terms_are_stiff_) interface_.terms = wanted;  // they are not state
  terms_are_stiff_ = stiff;
}

void GroundContact::clear_loads() noexcept {
  for (const int object : set_.loaded) external_damping_[object] = Sym6d{};
  for (const auto& [object, damping] : set_.rest_damping) external_damping_[object] = Sym6d{};
  set_.rest_damping.clear();
}

/// Removes its loads from an entity that a level without dynamics moves now.
void GroundContact::rest() noexcept {
  if (set_.loaded.empty() && set_.points.empty()) return;
  clear_loads();
  for (const int object : model().bodies()) external_force_[object] = set_.rest_force[object] = Wrenchd{};
  set_.points.clear();
  set_.loaded.clear();
}

void GroundContact::step(const Instant& instant) noexcept {
  if (!begin_step(instant)) return;
  finder_.find_on_planes(r_, R_, set_.points, set_.tests);
  find_rest(0);
  end_step(instant);
}

bool GroundContact::goes_with(const Algorithm& other) const {
  const auto* same = dynamic_cast<const GroundContact*>(&other);
  return same && finder_.finds_like(same->finder_);
}

std::unique_ptr<LaneGroup> GroundContact::join(std::span<Algorithm* const> members) const {
  return std::make_unique<GroundLanes>(members_of<GroundContact>(members));
}

/// Returns false if the entity needs no contacts.
bool GroundContact::begin_step(const Instant& instant) noexcept {
  MUROSIMF_ASSERT(instant.period > Duration{});
  if (dynamic_ == 0) {
    rest();
    return false;
  }
  clear_loads();
  const Wrenchd* const applied = applied_force_.data();
  Wrenchd *const external = external_force_.data(), *const rest_force = set_.rest_force.data();
  for (const int object : model().bodies()) {
    external[object] = rest_force[object] = applied[object];
  }
  choose_terms();
  interface_.terms.dt = seconds(instant.period);
  previous_.swap(set_.points);
  set_.points.clear();
  set_.tests = {};
  return true;
}

/// Finds the contacts that are not with planes, and the velocities of all points from number `first` on.
void GroundContact::find_rest(std::size_t first) noexcept {
  finder_.find_on_statics(r_, R_, set_.points, set_.tests);
  set_velocities(first);
}

void GroundContact::set_velocities(std::size_t first) noexcept {
  MUROSIMF_ASSERT(first <= set_.points.size());
  for (std::size_t i = first; i < set_.points.size(); ++i) {
    ContactPoint& c = set_.points[i];
    c.velocity = v_[c.object] + cross(w_[c.object], c.point - r_[c.object]);
    c.angular_velocity = w_[c.object];
  }
}

void GroundContact::end_step(const Instant& instant) noexcept {
  remember();
  note_interpenetration(instant.now);
  law_->prepare(set_.points, interface_.terms);
  set_.loaded.clear();
  int last = -1;  // points of one body are adjacent
  for (const ContactPoint& c : set_.points) {
    if (c.object == last) continue;
    last = c.object;
    if (std::find(set_.loaded.begin(), set_.loaded.end(), last) == set_.loaded.end()) set_.loaded.push_back(last);
  }
  write_loads(set_, r_, external_force_, external_damping_);
}

/// A body that has touched the ground already was not placed into it: its new points are resolved as fast as the others.
void GroundContact::begin_lift(ContactPoint& point) const noexcept {
  const auto same_body = [&](const ContactPoint& other) { return other.object == point.object; };
  const auto other = std::find_if(previous_.begin(), previous_.end(), same_body);
  if (other == previous_.end()) return begin_depenetration(point, interface_.terms.dt);
  point.lift = other->lift;
}

/// True if the same shapes touched from the other side in the preceding step.
bool GroundContact::has_crossed(const ContactPoint& c) const noexcept {
  if (GroundFinder::is_on_plane(c)) return false;
  const auto same = [&](const ContactPoint& other) {
    return GroundFinder::are_of_same_shapes(other, c) && other.lift == 0;
  };
  const auto before = std::find_if(previous_.begin(), previous_.end(), same);
  return before != previous_.end() && have_turned(before->normal, c.normal);
}

void GroundContact::note_interpenetration(Duration now) noexcept {
  if (set_.interpenetration) return;
  for (const ContactPoint& c : set_.points) {
    MUROSIMF_ASSERT(c.surface < thicknesses_.size());
    const double thinner = std::min(finder_.own_thickness(c.object), thicknesses_[c.surface]);
    const Depth depth = depth_of(c, thinner, interface_.terms.dt, has_crossed(c));
    if (depth == Depth::usual) continue;
    set_.interpenetration = {
        number_, environment_, c.object, environment_objects_[c.surface], c.depth, thinner, depth == Depth::through,
        now};
    return;
  }
}

void GroundContact::remember() {
  // both lists are sorted by feature: one pass finds the memory of each point
  auto old = previous_.begin();
  for (ContactPoint& c : set_.points) {
    while (old != previous_.end() && old->feature < c.feature) ++old;
    if (old == previous_.end() || old->feature != c.feature) {
      begin_lift(c);
      begin_bounce(c, interface_.terms.parameters[c.surface], gravity_, interface_.terms.dt);
    } else {
      recall(*old, c);
      go_on_bouncing(c);
      end_depenetration(c, interface_.terms.parameters[c.surface], interface_.terms.dt);
    }
  }
}

}  // namespace murosimf::collision
