/// lane_jobs.h - what the threads do of a wave: algorithms one by one, and groups of equal ones that step in lanes.
///
/// Every thread has the algorithms that are at home there (thread_affinity.h). Of these, the ones that go together (Algorithm::goes_with) and
/// have the same period are shared out evenly among as many groups as eight lanes demand. What each of them makes of its step does
/// not depend on it.
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "murosimf/runtime/plan.h"
#include "murosimf/world/lane_group.h"

namespace murosimf {

/// Done by one thread: a single algorithm, or a group of them.
struct Job {
  std::vector<std::size_t> algorithms;  ///< indices, as in a wave
  LaneGroup* lanes = nullptr;           ///< that steps them, if there is more than one
};

/// Of one wave, by threads.
struct WaveJobs {
  std::vector<Job> jobs;
  std::vector<std::size_t> ends;  ///< behind the last job of each thread
};

class LaneJobs {
 public:
  /// An algorithm by its index.
  struct Member {
    Algorithm* algorithm = nullptr;  ///< null: it steps alone
    Duration period{};
    std::size_t home = 0;  ///< number of the thread, below that of threads
  };
  LaneJobs() = default;
  LaneJobs(std::vector<Member> members, int threads)
      : members_(std::move(members)), threads_(static_cast<std::size_t>(threads)) {}

  /// The jobs of each of these waves, which are a Plan's. Made once, and kept.
  [[nodiscard]] const std::vector<WaveJobs>& of(const std::vector<Wave>& waves);
  /// How many of the members are in a group; of what has been asked for so far.
  [[nodiscard]] std::size_t members_in_groups() const;

 private:
  [[nodiscard]] WaveJobs jobs_of(const Wave& wave);
  void add_jobs(const Wave& family, std::vector<Job>& jobs);
  [[nodiscard]] std::vector<Wave> families(const Wave& wave) const;
  [[nodiscard]] bool go_together(std::size_t a, std::size_t b) const;
  [[nodiscard]] LaneGroup* group(const std::vector<std::size_t>& algorithms);

  std::vector<Member> members_;
  std::size_t threads_ = 1;
  std::unordered_map<const std::vector<Wave>*, std::vector<WaveJobs>> jobs_;
  std::map<std::vector<std::size_t>, std::unique_ptr<LaneGroup>> groups_;  // by their members
};

}  // namespace murosimf
