/// lane_jobs.h - what the threads do of a wave: algorithms one by one, and groups of equal ones that step in lanes.
///
/// Algorithms of a wave that go together (Algorithm::goes_with) and have the same period are shared out evenly among as many groups
/// as eight lanes demand, or more if there are threads for them. What each of them makes of its step does not depend on it.
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "murosimf/model/lane_group.h"
#include "murosimf/runtime/plan.h"

namespace murosimf {

/// Done by one thread: a single algorithm, or a group of them.
struct Job {
  std::vector<std::size_t> algorithms;  ///< indices, as in a wave
  LaneGroup* lanes = nullptr;           ///< that steps them, if there is more than one
};

class LaneJobs {
 public:
  /// An algorithm by its index. Null: it steps alone.
  struct Member {
    Algorithm* algorithm = nullptr;
    Duration period{};
  };
  LaneJobs() = default;
  LaneJobs(std::vector<Member> members, int threads) : members_(std::move(members)), threads_(threads) {}

  /// The jobs of each of these waves, which are a Plan's. Made once, and kept.
  [[nodiscard]] const std::vector<std::vector<Job>>& of(const std::vector<Wave>& waves);
  /// How many of the members are in a group; of what has been asked for so far.
  [[nodiscard]] std::size_t members_in_groups() const;

 private:
  [[nodiscard]] std::vector<Job> jobs_of(const Wave& wave);
  [[nodiscard]] std::vector<Wave> families(const Wave& wave) const;
  [[nodiscard]] bool go_together(std::size_t a, std::size_t b) const;
  [[nodiscard]] LaneGroup* group(const std::vector<std::size_t>& algorithms);

  std::vector<Member> members_;
  std::size_t threads_ = 1;
  std::unordered_map<const std::vector<Wave>*, std::vector<std::vector<Job>>> jobs_;
  std::map<std::vector<std::size_t>, std::unique_ptr<LaneGroup>> groups_;  // by whom they step
};

}  // namespace murosimf
