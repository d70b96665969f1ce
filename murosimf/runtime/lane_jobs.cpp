#include "murosimf/runtime/lane_jobs.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "murosimf/math/assert.h"

namespace murosimf {
namespace {

/// Number of groups for `members`: at most eight in each, and no fewer than a pack needs to be faster.
std::size_t number_of_groups(std::size_t members) {
  constexpr std::size_t lanes = Pack8::lanes, fewest = Pack8::registers + 1;
  return members < fewest ? members : (members + lanes - 1) / lanes;
}

}  // namespace

const std::vector<WaveJobs>& LaneJobs::of(const std::vector<Wave>& waves) {
  const auto [place, added] = jobs_.try_emplace(&waves);
  if (added) {
    for (const Wave& wave : waves) place->second.push_back(jobs_of(wave));
  }
  return place->second;
}

std::size_t LaneJobs::members_in_groups() const {
  std::set<std::size_t> members;
  for (const auto& [algorithms, group] : groups_) {
    if (group) members.insert(algorithms.begin(), algorithms.end());
  }
  return members.size();
}

WaveJobs LaneJobs::jobs_of(const Wave& wave) {
  WaveJobs result;
  MUROSIMF_ASSERT(std::ranges::all_of(wave, [&](std::size_t one) {
    return one < members_.size() && members_[one].home < threads_;
  }));
  for (std::size_t thread = 0; thread < threads_; ++thread) {
    Wave share;
    std::copy_if(wave.begin(), wave.end(), std::back_inserter(share),
                 [&](std::size_t algorithm) { return members_[algorithm].home == thread; });
    for (const Wave& family : families(share)) add_jobs(family, result.jobs);
    result.ends.push_back(result.jobs.size());
  }
  MUROSIMF_ASSERT(result.ends.size() == threads_ && result.jobs.size() <= wave.size());
  return result;
}

void LaneJobs::add_jobs(const Wave& family, std::vector<Job>& jobs) {
  const std::size_t groups = number_of_groups(family.size());
  for (std::size_t g = 0; g < groups; ++g) {
    const auto at = [&](std::size_t part) {
      return family.begin() + static_cast<std::ptrdiff_t>(part * family.size() / groups);
    };
    Job job{{at(g), at(g + 1)}, nullptr};
    MUROSIMF_ASSERT(!job.algorithms.empty() && job.algorithms.size() <= Pack8::lanes);
    if (job.algorithms.size() > 1) job.lanes = group(job.algorithms);
    if (job.lanes || job.algorithms.size() == 1) {
      jobs.push_back(std::move(job));
    } else {  // the algorithm has declined to step in lanes
      for (const std::size_t algorithm : job.algorithms) jobs.push_back({{algorithm}, nullptr});
    }
  }
}

/// In the order of their first members. Most algorithms go with none, not even with equal ones: these are not compared.
std::vector<Wave> LaneJobs::families(const Wave& wave) const {
  std::vector<Wave> result;
  std::vector<std::size_t> open;  // families of which there may be more
  for (const std::size_t algorithm : wave) {
    const bool goes = go_together(algorithm, algorithm);
    const auto family = std::find_if(open.begin(), open.end(), [&](std::size_t other) {
      return goes && go_together(result[other].front(), algorithm);
    });
    if (family != open.end()) {
      result[*family].push_back(algorithm);
      continue;
    }
    if (goes) open.push_back(result.size());
    result.push_back({algorithm});
  }
  return result;
}

bool LaneJobs::go_together(std::size_t a, std::size_t b) const {
  MUROSIMF_ASSERT(a < members_.size() && b < members_.size());
  const Member &first = members_[a], &second = members_[b];
  return first.algorithm && second.algorithm && first.period == second.period &&
         first.algorithm->goes_with(*second.algorithm);
}

LaneGroup* LaneJobs::group(const std::vector<std::size_t>& algorithms) {
  auto& group = groups_[algorithms];
  if (!group) {
    std::vector<Algorithm*> members;
    for (const std::size_t a : algorithms) {
      MUROSIMF_ASSERT(a < members_.size() && members_[a].algorithm);
      members.push_back(members_[a].algorithm);
    }
    group = members.front()->join(members);
  }
  return group.get();
}

}  // namespace murosimf
