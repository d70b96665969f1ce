/// link_model.h - delay, jitter, bandwidth and loss of any link: when a packet arrives, or that it never does.
///
/// Packet n of `size` bytes that is handed over at t is sent from s to e and arrives at a:
///
///     s = max(t, e of the packet before)     lost if s - t > longest_queue
///     e = s + size / bandwidth
///     a = e + delay + jitter u_n             in order: not before the packet before
///
/// and is lost on the way with probability `loss`, after it has occupied the link. u_n and the outcome of a loss are numbers n
/// of separate random streams: they depend on the seed, the link's name and n only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "murosimf/control_software/link_options.h"
#include "murosimf/math/random.h"
#include "murosimf/world/state_archive.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {

class LinkModel {
 public:
  /// `name` distinguishes links of one seed: "blue1 to blue2". Throws SetupError if a number is negative or out of range.
  LinkModel(const LinkOptions& options, std::uint64_t seed, std::string_view name);

  /// Arrival of the next packet, handed over at `time`, which must not precede that of the last one; nothing: it is lost.
  [[nodiscard]] std::optional<Duration> arrival(Duration time, std::size_t bytes) noexcept;

  /// Restores the initial state.
  void restart() noexcept;
  void reseed(std::uint64_t seed) noexcept;
  void state(StateArchive& archive) { archive(packets_, free_at_, last_arrival_); }

 private:
  LinkOptions options_;
  RandomStream delays_, losses_;
  std::uint64_t packets_ = 0;  // so far, the lost ones included
  Duration free_at_{};         // when the last byte of all that was handed over has been sent
  Duration last_arrival_{};
};

}  // namespace murosimf::control_software
