#include "murosimf/dynamics/written_state.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "murosimf/math/assert.h"

namespace murosimf::dynamics {
namespace {

/// By bits: NaN equals itself, and -0 differs from 0.
bool equal(std::span<const double> a, std::span<const double> b) noexcept {
  MUROSIMF_ASSERT(a.size() == b.size());
  return std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace

WrittenState::WrittenState(const PoseColumns& columns) : q_(columns.q.size()), qd_(columns.qd.size()) { forget(); }

WrittenState::Base WrittenState::base_of(const PoseColumns& columns) noexcept {
  return {columns.r[0], columns.v[0], columns.w[0], columns.Q[0]};
}

void WrittenState::remember(const PoseColumns& columns) noexcept {
  base_ = base_of(columns);
  MUROSIMF_ASSERT(columns.q.size() == q_.size() && columns.qd.size() == qd_.size());
  std::copy(columns.q.begin(), columns.q.end(), q_.begin());
  std::copy(columns.qd.begin(), columns.qd.end(), qd_.begin());
}

bool WrittenState::differs(const PoseColumns& columns) const noexcept {
  const Base base = base_of(columns);
  return std::memcmp(&base, &base_, sizeof(base)) != 0 || !equal(columns.q, q_) || !equal(columns.qd, qd_);
}

void WrittenState::forget() noexcept {
  constexpr double no_place = std::numeric_limits<double>::infinity();  // no level leaves an entity there
  base_.r = {no_place, no_place, no_place};
}

}  // namespace murosimf::dynamics
