/// state_packer.h - the state of one of many simulations that were built alike, in few bytes and little time.
///
/// What Simulation::save() has, but without names and checksum, which all would repeat, and without zeros: most rows of columns are of
/// objects that feel nothing or have no pose. First come the columns of numbers, then all else, each in blocks of 32 bytes; before up to
/// 64 blocks a word says which of them follow: the others are zero.
///
/// Which blocks of a simulation are not zero hardly changes. So a block that was there is saved again without a look at it, and loading a
/// state directly after another one was saved clears only what that one had.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace murosimf {

class ColumnBase;
class Simulation;
class StateArchive;

class StatePacker {
 public:
  using Word = std::uint64_t;

  /// Of a simulation that has been initialized, and keeps its columns as long as this is used.
  explicit StatePacker(Simulation& simulation);

  /// Between two steps; into `packed`, which keeps its memory.
  void save(std::vector<Word>& packed);
  /// What the packer of a simulation that was built alike has saved. Throws SetupError if it was not; some of the state is another then.
  /// Between save() and load() no column of the simulation may change.
  void load(std::span<const Word> packed);
  /// To be called where the simulation begins anew: its next state is saved with no more blocks than it needs.
  void forget();

 private:
  /// Blocks of a column, one behind the other.
  struct Piece {
    std::byte* data;
    std::uint16_t whole;    // blocks of 32 bytes
    std::uint8_t first;     // bit of the first in the group's mask
    std::uint8_t end_size;  // bytes behind them, which are a block, too
  };
  /// Pieces whose blocks share a mask.
  struct Group {
    std::size_t begin, end;  // numbers of its pieces
    std::size_t blocks;
  };

  void add_pieces(std::span<std::byte> column);
  [[nodiscard]] std::span<const Piece> pieces(const Group& group) const;
  [[nodiscard]] Word renewed_mask(const Group& group, Word mask) const;
  [[nodiscard]] Word* save_numbers(Word* to);
  void visit_others(StateArchive& archive);

  Simulation* simulation_;
  std::vector<Piece> pieces_;  // of columns of numbers
  std::vector<Group> groups_;
  std::vector<Word> masks_;          // by group: outside of it all was zero when it was saved or loaded
  bool masks_known_ = false;         // they are those of the last state
  bool is_saved_ = false;            // that one is what the simulation has
  std::vector<ColumnBase*> others_;  // columns of other values
  std::vector<std::byte> plain_;     // working memory, as the next one
  std::vector<Word> packed_;
};

}  // namespace murosimf
