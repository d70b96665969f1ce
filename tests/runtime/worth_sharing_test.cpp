// Waves are shared out as long as that takes less time, on a machine whose times are made up.
#include "murosimf/runtime/worth_sharing.h"

#include <functional>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using Time = WorthSharing::Time;

Time wall{};  // of the machine
Time wall_now() { return wall; }

/// Makes waves, all of one kind unless `kind` says which, and counts what they took.
class Machine {
 public:
  Machine() { wall = 1h; }

  /// How long wave number `n` takes.
  std::function<Time(std::uint64_t n, bool shared)> takes;
  std::function<std::uint64_t(std::uint64_t n)> kind = [](std::uint64_t) { return 7; };

  /// Makes waves for so long, and tells which part of them was shared out.
  double share_of_waves(Time duration) {
    std::uint64_t shared = 0, waves = 0;
    for (const Time end = wall + duration; wall < end; ++waves) shared += static_cast<std::uint64_t>(wave());
    return static_cast<double>(shared) / static_cast<double>(waves);
  }
  /// How many waves are made in that time.
  double waves_in(Time duration) {
    double waves = 0;
    for (const Time end = wall + duration; wall < end; ++waves) wave();
    return waves;
  }

 private:
  bool wave() {
    const bool shared = worth_.begin_wave();
    wall += takes(n_, shared);
    worth_.end_wave(kind(n_++));
    return shared;
  }

  WorthSharing worth_{wall_now};
  std::uint64_t n_ = 0;
};

TEST(WorthSharing, BeginsAloneAndSharesWhatPays) {
  Machine machine;
  machine.takes = [](std::uint64_t, bool shared) { return shared ? 6us : 10us; };
  EXPECT_EQ(machine.share_of_waves(WorthSharing::first_rest), 0);
  EXPECT_GT(machine.waves_in(1s), 0.97 * 1s / 6us);
  EXPECT_GT(machine.share_of_waves(1s), 0.97);
}

TEST(WorthSharing, StaysAloneWhereThatIsFaster) {
  for (const Time together : {11us, 15us, 30us, 500us}) {
    Machine machine;
    machine.takes = [&](std::uint64_t, bool shared) { return shared ? together : 10us; };
    EXPECT_GT(machine.waves_in(25ms), 0.95 * 25ms / 10us) << together.count();
    EXPECT_GT(machine.waves_in(10s), 0.98 * 10s / 10us) << together.count();
  }
}

/// A thread of the pool loses its core for 4 ms every 3 ms that the pool works with all of them.
class Robbed {
 public:
  Time operator()(std::uint64_t, bool shared) {
    if (!shared) return 10us;
    worked_ += 6us;
    if (worked_ < 3ms) return 6us;
    worked_ = {};
    return 4ms;
  }

 private:
  Time worked_{};
};

TEST(WorthSharing, WaitsAreNotWorthIt) {
  Machine machine;
  machine.takes = Robbed();
  EXPECT_GT(machine.waves_in(25ms), 0.9 * 25ms / 10us);
  EXPECT_GT(machine.waves_in(2s), 0.97 * 2s / 10us);
}

TEST(WorthSharing, ComesBackWhenTheOtherProgramEnds) {
  Machine machine;
  bool busy = false;
  Robbed robbed;
  machine.takes = [&](std::uint64_t n, bool shared) { return busy ? robbed(n, shared) : shared ? 6us : 10us; };
  for (int round = 0; round < 3; ++round) {
    busy = true;
    machine.share_of_waves(3s);
    EXPECT_LT(machine.share_of_waves(1s), 0.05);
    busy = false;
    machine.share_of_waves(WorthSharing::longest_rest + 20ms);
    EXPECT_GT(machine.share_of_waves(1s), 0.97);
  }
}

// Time that the one thread itself is without a core must not make its waves look dear.
TEST(WorthSharing, OneThreadThatLosesItsCoreIsNoReason) {
  Machine machine;
  machine.takes = [](std::uint64_t n, bool shared) { return shared ? Time(12us) : n % 300 == 0 ? Time(4ms) : 10us; };
  EXPECT_LT(machine.share_of_waves(5s), 0.05);
}

// Most waves are short; a camera's are five hundred times as long.
TEST(WorthSharing, ComparesWavesOfOneKind) {
  Machine machine;
  machine.kind = [](std::uint64_t n) { return n % 50 == 0 ? 1U : 2 + n % 3; };
  machine.takes = [](std::uint64_t n, bool shared) {
    const auto alone = n % 50 == 0 ? Time(5ms) : Time(10us);
    return shared ? alone * 7 / 10 : alone;
  };
  machine.share_of_waves(1s);
  EXPECT_GT(machine.share_of_waves(3s), 0.9);
}

// When robots fall, all waves get longer: that is no reason to give up, nor to go on.
TEST(WorthSharing, WavesThatChangeAreLearnedAnew) {
  Machine machine;
  int robots = 10;
  machine.takes = [&](std::uint64_t, bool shared) { return robots * (shared ? 600ns : 1000ns); };
  machine.share_of_waves(200ms);
  robots = 30;
  machine.share_of_waves(100ms);
  EXPECT_GT(machine.share_of_waves(1s), 0.97);
}

// Whole worlds are items, too.
TEST(WorthSharing, LongWavesAreShared) {
  Machine machine;
  machine.takes = [](std::uint64_t n, bool shared) { return (shared ? Time(30ms) : Time(50ms)) + (n % 3) * Time(2ms); };
  machine.share_of_waves(2s);
  EXPECT_GT(machine.share_of_waves(20s), 0.9);
}

}  // namespace
}  // namespace murosimf
