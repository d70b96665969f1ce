#include "murosimf/dynamics/servo/servo_bus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {

ServoBus::ServoBus(Setup& setup)
    : turning_(setup),
      coupled_(setup.model()),
      linkages_(joints_of_loops(setup.model())),
      commands_linkages_(!setup.model().having(properties::loop_commanded).empty()),
      objects_(setup.model().joints()),
      step_(seconds(setup.period())),
      plain_(false),
      lowest_(static_cast<std::size_t>(setup.model().size()), -std::numeric_limits<double>::infinity()),
      highest_(lowest_.size(), std::numeric_limits<double>::infinity()),
      share_(lowest_.size(), 1.0),
      period_(static_cast<std::size_t>(setup.model().size())),
      delay_(period_.size()),
      target_(setup.input(properties::joint_target, 0.0)),
      delayed_(setup.write(delayed_target)),
      present_(period_.size()) {
  MUROSIMF_ASSERT(step_ > 0);
  if (commands_linkages_) {
    q_ = setup.write(properties::joint_position);
    rates_.resize(period_.size());
  }
  bool holds = false, limits = false, filters = false;
  for (const int i : objects_) {
    const Servo* servo = setup.model().find(properties::servo, i);
    if (const Vec3d* range = setup.model().find(properties::joint_target_range, i); range && !turning_.contains(i)) {
      lowest_[i] = range->x;
      highest_[i] = range->y;
      limits = true;
    }
    if (servo && servo->command_filter > 0) {
      // expm1: exact for filters that are slow against the step
      share_[i] = -std::expm1(-step_ / servo->command_filter);
      filters = true;
    }
    if (servo) delay_[i] = static_cast<std::size_t>(std::lround(servo->command_delay / step_));
    if (!servo || servo->command_period <= 0) continue;
    period_[i] = std::max(1.0, std::round(servo->command_period / step_));
    holds = true;
  }
  plain_ = !holds && !limits && !filters && turning_.joints().empty();  // most robots: one pass over the targets
  if (filters) filtered_ = setup.write(properties::filtered_target);
  if (!holds) return;
  sent_ = setup.write(properties::sent_target);
  age_ = setup.write(properties::sent_target_age);
}

void ServoBus::start() noexcept {
  std::fill(sent_.begin(), sent_.end(), 0.0);
  std::fill(age_.begin(), age_.end(), 0.0);
  std::fill(filtered_.begin(), filtered_.end(), 0.0);
  for (const int i : objects_) {
    present_[i] = wanted(i);
    delayed_[i].reset(delay_[i], present_[i]);
    if (share_[i] < 1) filtered_[i] = present_[i];
    if (period_[i] <= 0) continue;
    sent_[i] = present_[i];
    age_[i] = period_[i];  // the next step sends
  }
  couple();
}

void ServoBus::couple() noexcept {
  for (const auto& pair : coupled_.pairs()) {
    present_[pair.follower] = pair.offset + pair.ratio * present_[pair.leader];
  }
  if (!commands_linkages_) return;
  linkages_.keep(q_);
  // from the present positions: the branch on which the linkages are
  linkages_.follow(present_, rates_);
}

double ServoBus::sent(int i) noexcept {
  if (period_[i] <= 0) return wanted(i);  // sent in every step
  if (age_[i] >= period_[i]) {
    sent_[i] = wanted(i);
    age_[i] = 0;
  }
  age_[i] += 1;
  return sent_[i];
}

void ServoBus::filter(int i) noexcept {
  const double arrived = std::exchange(present_[i], filtered_[i]);  // a step behind, as MuJoCo's activation
  filtered_[i] += share_[i] * (arrived - filtered_[i]);
}

MUROSIMF_INLINE bool ServoBus::pass_on(double now, int i) noexcept {
  constexpr double largest = 1e4;  // [rad | m | rad/s | m/s] beyond it sines lose their precision
  present_[i] = delayed_[i].pass(now);
  return std::abs(now) < largest;  // false for NaN
}

bool ServoBus::step(double dt) noexcept {
  const std::int64_t steps = std::llround(dt / step_);
  MUROSIMF_ASSERT(steps >= 1);
  bool sane = true;
  if (plain_ && steps == 1) {
    for (const int i : objects_) sane &= pass_on(target_[i], i);
  } else {
    for (const int i : objects_) {
      for (std::int64_t step = 0; step < steps; ++step) {
        sane &= pass_on(sent(i), i);
        if (share_[i] < 1) filter(i);
      }
    }
  }
  couple();
  return sane;
}

}  // namespace murosimf::dynamics
