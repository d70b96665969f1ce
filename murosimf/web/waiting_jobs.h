/// waiting_jobs.h - pending requests of clients, executed by the simulation's thread between two steps.
#pragma once

#include <chrono>
#include <deque>
#include <exception>
#include <future>
#include <string>

namespace murosimf::web {

/// Calls answer(job, error) for each completed job, in order, and removes it; error: the reason of a failure, else empty. A Job has a
/// `done`, a std::future<void>.
template <class Job, class Answer>
void answer_ready(std::deque<Job>& jobs, const Answer& answer) {
  for (auto job = jobs.begin(); job != jobs.end();) {
    if (job->done.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      ++job;
      continue;
    }
    std::string error;
    try {
      job->done.get();
    } catch (const std::exception& what) {
      error = what.what();
    }
    answer(*job, error);
    job = jobs.erase(job);
  }
}

}  // namespace murosimf::web
