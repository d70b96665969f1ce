#include "murosimf/control_software/link_model.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

constexpr double longest_time = 1e6;         // [s]
constexpr double greatest_bandwidth = 1e15;  // [byte/s]

void require_within(double number, double highest, std::string_view name) {
  if (number >= 0 && number <= highest) return;  // not if it is NaN
  throw SetupError(fmt::format("the {} of a link is {}; it must be from 0 to {:g}", name, number, highest));
}

const LinkOptions& checked(const LinkOptions& options) {
  require_within(options.delay, longest_time, "delay");
  require_within(options.jitter, longest_time, "jitter");
  require_within(options.longest_queue, longest_time, "longest queue");
  require_within(options.loss, 1, "loss");
  require_within(options.bandwidth, greatest_bandwidth, "bandwidth");
  if (options.bandwidth > 0 && options.bandwidth < 1) {
    throw SetupError("the bandwidth of a link is below 1 byte/s; 0 is any");
  }
  return options;
}

}  // namespace

LinkModel::LinkModel(const LinkOptions& options, std::uint64_t seed, std::string_view name)
    : options_(checked(options)),
      delays_(seed, std::string(name) + "/delay"),
      losses_(seed, std::string(name) + "/loss") {}

std::optional<Duration> LinkModel::arrival(Duration time, std::size_t bytes) noexcept {
  const std::uint64_t number = packets_++;
  const Duration begin = std::max(time, free_at_);
  // The number is consumed even if the packet is dropped here: later packets keep their random numbers.
  if (begin - time > from_seconds(options_.longest_queue)) return std::nullopt;
  free_at_ = begin;
  if (options_.bandwidth > 0) free_at_ += from_seconds(static_cast<double>(bytes) / options_.bandwidth);
  // A lost packet has still used the bandwidth, as on a real channel.
  if (losses_.uniform(number) < options_.loss) return std::nullopt;
  Duration arrival = free_at_ + from_seconds(options_.delay + options_.jitter * delays_.uniform(number));
  if (options_.in_order) arrival = std::max(arrival, last_arrival_);
  MUROSIMF_ASSERT(arrival >= time);
  last_arrival_ = arrival;
  return arrival;
}

void LinkModel::restart() noexcept {
  packets_ = 0;
  free_at_ = last_arrival_ = {};
}

void LinkModel::reseed(std::uint64_t seed) noexcept {
  delays_.reseed(seed);
  losses_.reseed(seed);
}

}  // namespace murosimf::control_software
