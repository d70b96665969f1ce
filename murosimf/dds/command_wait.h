/// command_wait.h - a cycle waits for a low-level command: a program that computes for longer than a cycle of simulated time is waited for.
#pragma once

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/software_maker.h"
#include "murosimf/dds/inbox.h"
#include "murosimf/world/time.h"

namespace murosimf::dds {

class CommandWait {
 public:
  /// `longest` [s] of wall time; 0: nothing is waited for. `say` is told once when it has passed.
  CommandWait(double longest, control_software::SayLine say) : longest_(from_seconds(longest)), say_(std::move(say)) {}

  /// Until there is a message of `topic`, as long as any program writes.
  void wait(Inbox& inbox, char topic) {
    if (longest_.count() <= 0 || inbox.wait_for(topic, longest_) || std::exchange(told_, true)) return;
    say_(fmt::format("no low-level command came within {} s: a cycle went on without it", seconds(longest_)));
  }

 private:
  std::chrono::nanoseconds longest_;
  control_software::SayLine say_;
  bool told_ = false;
};

}  // namespace murosimf::dds
