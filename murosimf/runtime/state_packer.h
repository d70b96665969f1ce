/// state_packer.h - the state of one of many simulations that were built alike, in few bytes and little time.
///
/// What Simulation::save() has, but without names and checksum, which all would repeat, and without zeros: most rows of columns are of
/// objects that feel nothing or have no pose. First come the columns of numbers, then all else, each in blocks of 32 bytes; before every
/// 64 blocks a word says which of them are not zero, and only these follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace murosimf {

class ColumnBase;
class Simulation;

class StatePacker {
 public:
  using Word = std::uint64_t;

  /// Of a simulation that has been initialized, and keeps its columns as long as this is used.
  explicit StatePacker(Simulation& simulation);

  /// Between two steps; into `packed`, which keeps its memory.
  void save(std::vector<Word>& packed);
  /// What the packer of a simulation that was built alike has saved. Throws SetupError if it was not; some of the state is another then.
  void load(std::span<const Word> packed);

 private:
  template <class Archive>
  void visit_others(Archive& archive);

  Simulation* simulation_;
  std::vector<std::span<std::byte>> numbers_;  // of columns
  std::vector<ColumnBase*> others_;            // columns of other values
  std::vector<std::byte> plain_;               // working memory, as the next one
  std::vector<Word> packed_;
};

}  // namespace murosimf
