/// delayed_rows.h - numbers that go over a link again and again: who receives has the newest that have arrived.
///
/// What is overtaken on the way by newer numbers is dropped when it arrives.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/connect/link_model.h"

namespace murosimf::connect {

class DelayedRows {
 public:
  /// As LinkModel.
  DelayedRows(const LinkOptions& options, std::uint64_t seed, std::string_view name) : link_(options, seed, name) {}

  void send(Duration now, std::span<const double> numbers);
  /// The newest numbers, if they have arrived since the last call; null: none have. They stay until the next call.
  [[nodiscard]] const std::vector<double>* receive(Duration now);

  /// What is on its way gets lost: who sends has other numbers from now on.
  void drop() { on_their_way_.clear(); }
  void restart();
  void reseed(std::uint64_t seed) { link_.reseed(seed); }
  void state(StateArchive& archive) { archive(link_, on_their_way_, sent_, newest_, counts_); }

  [[nodiscard]] const LinkCounts& counts() const { return counts_; }

 private:
  struct Packet {
    Duration arrival{};
    std::uint64_t number = 0;
    std::vector<double> numbers{};
    void state(StateArchive& archive) { archive(arrival, number, numbers); }
  };

  LinkModel link_;
  std::vector<Packet> on_their_way_;
  std::vector<double> received_;
  std::uint64_t sent_ = 0, newest_ = 0;  // numbers of packets, from 1 on
  LinkCounts counts_;
};

}  // namespace murosimf::connect
