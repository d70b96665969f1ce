/// state_packer.h - the state of one of many simulations that were built alike, in few bytes and little time.
///
/// What Simulation::save() has, in the same order, but without names and checksum, which all would repeat, and without zeros: most
/// rows of columns are of objects that feel nothing or have no pose. Behind the number of bytes come, for every 64 blocks of 32 bytes,
/// a word that says which of them are not zero, and these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace murosimf {

class Simulation;

class StatePacker {
 public:
  using Word = std::uint64_t;

  /// Of a simulation that has been initialized, between two steps; into `packed`, which keeps its memory.
  void save(Simulation& simulation, std::vector<Word>& packed);
  /// Into one that was built alike. Throws SetupError if it was not, and may have changed it then.
  void load(Simulation& simulation, std::span<const Word> packed);

 private:
  void pack(std::vector<Word>& to);
  void unpack(std::span<const Word> packed);

  std::vector<std::byte> plain_;  // working memory, as the next one
  std::vector<Word> packed_;
};

}  // namespace murosimf
