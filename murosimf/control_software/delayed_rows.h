/// delayed_rows.h - rows of numbers that are sent over a link periodically: the receiver has the newest row that has arrived.
///
/// A row that is overtaken on the way by a newer one is dropped when it arrives.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/control_software/link_model.h"

namespace murosimf::control_software {

class DelayedRows {
 public:
  /// As LinkModel.
  DelayedRows(const LinkOptions& options, std::uint64_t seed, std::string_view name) : link_(options, seed, name) {}

  void send(Duration now, std::span<const double> numbers);
  /// Returns the newest row, if it has arrived since the last call; null: no new row. The row stays valid until the next call.
  [[nodiscard]] const std::vector<double>* receive(Duration now);

  /// Drops all rows in transit: the sender starts over.
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

}  // namespace murosimf::control_software
