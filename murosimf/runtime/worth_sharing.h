/// worth_sharing.h - whether it pays to share waves out among threads, from measured times.
///
/// Where other programs want the cores too, a thread that has begun with something and is taken off its core has all others wait for
/// milliseconds, in which one thread alone makes a hundred waves. So one thread begins alone, learns how long each kind of wave takes
/// it, and then waves are shared out as long as they take less than that:
///
///     listening  one thread; the usual time u of each kind of wave is a running mean, in which no wave counts for more than 2 u, so
///                that it hardly shows when the thread itself was taken off its core
///     sharing    all threads; a balance adds up u - t, t being the time of each wave. Now and then it listens again: waves change
///     resting    one thread, and nothing is timed, after the balance has fallen below zero. Twice as long each time that sharing
///                has lost time altogether, so that trying again costs little; then it listens, and shares
///
/// Results cannot depend on it, because they do not depend on which thread does what.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace murosimf {

class WorthSharing {
 public:
  using Time = std::chrono::nanoseconds;
  using Now = Time (*)();

  /// [wall time] Before sharing is tried for the first time; after it was given up.
  static constexpr Time first_rest = std::chrono::milliseconds(4), shortest_rest = std::chrono::milliseconds(32),
                        longest_rest = std::chrono::milliseconds(512);

  /// `now`: a clock that never goes back; tests bring their own.
  explicit WorthSharing(Now now = steady_now) : now_(now) {}

  [[nodiscard]] bool shares() const { return phase_ == Phase::sharing; }
  /// Before a wave: whether to share it out, which is shares().
  [[nodiscard]] bool begin_wave();
  /// After it. `kind`: any number; waves of one kind usually take equally long, shared out or not.
  void end_wave(std::uint64_t kind);

 private:
  enum class Phase { resting, listening, sharing };
  struct Usual {
    std::uint64_t kind = 0;
    Time alone{};  ///< 0: not known
  };

  static Time steady_now();
  [[nodiscard]] Usual& usual(std::uint64_t kind);
  void begin(Phase phase, Time now);
  void rest(Time now);
  void listen(std::uint64_t kind, Time time, Time now);
  void share(std::uint64_t kind, Time time, Time now);

  Now now_;
  Phase phase_ = Phase::resting;
  std::uint32_t waves_ = 0;    // of the phase
  Time began_{}, in_waves_{};  // the phase; how long its waves took
  Time wave_began_{};
  Time rest_ = first_rest;
  Time credit_{}, won_{};          // by sharing since it last rested: what is left to lose, all
  std::array<Usual, 64> usual_{};  // two kinds that want one place are learned anew by turns
};

}  // namespace murosimf
