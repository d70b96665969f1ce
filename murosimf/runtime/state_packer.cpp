#include "murosimf/runtime/state_packer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "murosimf/math/inline.h"
#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {
namespace {

using Word = StatePacker::Word;

constexpr std::size_t words_in_block = 4, block_size = words_in_block * sizeof(Word), blocks_in_mask = 64;

struct Block {
  Word words[words_in_block] = {};
};

/// A block as vector registers hold it.
using Bits = Word __attribute__((vector_size(block_size)));

[[nodiscard]] MUROSIMF_INLINE Bits bits_of(const std::byte* at) {
  Bits bits;
  std::memcpy(&bits, at, block_size);
  return bits;
}

[[nodiscard]] MUROSIMF_INLINE bool is_zero(const Bits& bits) { return (bits[0] | bits[1] | bits[2] | bits[3]) == 0; }

[[nodiscard]] constexpr Word lowest_bits(std::size_t count) {
  return count < blocks_in_mask ? (Word{1} << count) - 1 : ~Word{0};
}

/// Calls visit(i) for each bit i of a mask.
template <class Visit>
MUROSIMF_INLINE void for_bits(Word mask, const Visit& visit) {
  for (; mask != 0; mask &= mask - 1) visit(static_cast<std::size_t>(std::countr_zero(mask)));
}

[[nodiscard]] constexpr std::size_t blocks_of(std::size_t bytes) { return (bytes + block_size - 1) / block_size; }

/// The blocks of a piece, from the mask of its group.
template <class Piece>
[[nodiscard]] MUROSIMF_INLINE Word own_bits(const Piece& piece, Word mask) {
  return mask >> piece.first & lowest_bits(piece.whole);
}

template <class Piece>
[[nodiscard]] MUROSIMF_INLINE bool has_end(const Piece& piece, Word mask) {
  return piece.end_size > 0 && (mask >> (piece.first + piece.whole) & 1U) != 0;
}

/// The last block of a piece, which is no whole one.
template <class Piece>
[[nodiscard]] MUROSIMF_INLINE Block end_of(const Piece& piece) {
  Block block;
  std::memcpy(&block, piece.data + piece.whole * block_size, piece.end_size);
  return block;
}

/// Adds the bits of all blocks that a mask does not have.
template <class Piece>
MUROSIMF_INLINE void add_bits_elsewhere(const Piece& piece, Word mask, Bits& bits) {
  for_bits(own_bits(piece, ~mask), [&](std::size_t i) { bits |= bits_of(piece.data + i * block_size); });
  if (!has_end(piece, ~mask)) return;
  const Block end = end_of(piece);
  bits[0] |= end.words[0] | end.words[1] | end.words[2];
}

/// The mask of all blocks that are not zero, where it has those of this piece.
template <class Piece>
[[nodiscard]] Word mask_of(const Piece& piece) {
  Word mask = 0;
  for (std::size_t i = 0; i < piece.whole; ++i) {
    if (!is_zero(bits_of(piece.data + i * block_size))) mask |= Word{1} << i;
  }
  if (piece.end_size > 0) {
    const Block end = end_of(piece);
    if ((end.words[0] | end.words[1] | end.words[2]) != 0) mask |= Word{1} << piece.whole;
  }
  return mask << piece.first;
}

/// The blocks of a mask, one behind the other.
template <class Piece>
[[nodiscard]] MUROSIMF_INLINE Word* save_blocks(const Piece& piece, Word mask, Word* to) {
  for_bits(own_bits(piece, mask), [&](std::size_t i) {
    std::memcpy(to, piece.data + i * block_size, block_size);
    to += words_in_block;
  });
  if (!has_end(piece, mask)) return to;
  const Block end = end_of(piece);
  std::memcpy(to, &end, block_size);
  return to + words_in_block;
}

/// And back; blocks that only `other` has become zero.
template <class Piece>
[[nodiscard]] MUROSIMF_INLINE const Word* load_blocks(const Piece& piece, Word mask, Word other, const Word* from) {
  for_bits(own_bits(piece, other & ~mask),
           [&](std::size_t i) { std::memset(piece.data + i * block_size, 0, block_size); });
  for_bits(own_bits(piece, mask), [&](std::size_t i) {
    std::memcpy(piece.data + i * block_size, from, block_size);
    from += words_in_block;
  });
  std::byte* const end = piece.data + piece.whole * block_size;
  if (has_end(piece, mask)) {
    std::memcpy(end, from, piece.end_size);
    return from + words_in_block;
  }
  if (has_end(piece, other)) std::memset(end, 0, piece.end_size);
  return from;
}

}  // namespace

StatePacker::StatePacker(Simulation& simulation) : simulation_(&simulation) {
  simulation.world().for_all([&](Entity& entity) {
    for (const auto& [name, column] : entity.columns()) {
      if (column->info().scope == Scope::wiring) continue;
      const ColumnBase::Memory memory = column->memory();
      if (memory.data) {
        add_pieces(std::as_writable_bytes(std::span(memory.data, memory.rows * memory.stride)));
      } else {
        others_.push_back(column.get());
      }
    }
  });
  masks_.resize(groups_.size());
}

/// Of one column: each has its blocks in one mask, which it shares with other pieces if there is room.
void StatePacker::add_pieces(std::span<std::byte> column) {
  while (!column.empty()) {
    if (groups_.empty() || groups_.back().blocks == blocks_in_mask)
      groups_.push_back({pieces_.size(), pieces_.size(), 0});
    Group& group = groups_.back();
    const std::size_t bytes = std::min(column.size(), (blocks_in_mask - group.blocks) * block_size);
    pieces_.push_back({column.data(), static_cast<std::uint16_t>(bytes / block_size),
                       static_cast<std::uint8_t>(group.blocks), static_cast<std::uint8_t>(bytes % block_size)});
    group.end = pieces_.size();
    group.blocks += blocks_of(bytes);
    column = column.subspan(bytes);
  }
}

/// All but columns of numbers.
void StatePacker::visit_others(StateArchive& archive) {
  simulation_->world().for_all([&](Entity& entity) { entity.state(archive); });
  for (ColumnBase* column : others_) column->state(archive);
  for (const auto& task : simulation_->tasks_) task->algorithm->state(archive);
  simulation_->state(archive);
}

std::span<const StatePacker::Piece> StatePacker::pieces(const Group& group) const {
  return std::span(pieces_).subspan(group.begin, group.end - group.begin);
}

/// The mask that a group had, if all else is still zero; else that of all blocks that are not.
auto StatePacker::renewed_mask(const Group& group, Word mask) const -> Word {
  Bits bits{};
  for (const Piece& piece : pieces(group)) add_bits_elsewhere(piece, mask, bits);
  if (masks_known_ && is_zero(bits)) return mask;
  mask = 0;
  for (const Piece& piece : pieces(group)) mask |= mask_of(piece);
  return mask;
}

auto StatePacker::save_numbers(Word* to) -> Word* {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Word mask = *to++ = masks_[g] = renewed_mask(groups_[g], masks_[g]);
    for (const Piece& piece : pieces(groups_[g])) to = save_blocks(piece, mask, to);
  }
  masks_known_ = is_saved_ = true;
  return to;
}

void StatePacker::save(std::vector<Word>& packed) {
  plain_.clear();
  StateArchive archive(plain_);
  visit_others(archive);
  const std::size_t plain_size = plain_.size(), blocks = blocks_of(plain_size);
  plain_.resize(blocks * block_size);
  packed_.resize(std::max(packed_.size(), 2 + groups_.size() * (blocks_in_mask * words_in_block + 1) +
                                              (blocks + 1) * words_in_block + blocks / blocks_in_mask));
  packed_[0] = plain_size;
  Word* to = save_numbers(packed_.data() + 1);
  for (std::size_t first = 0; first < blocks; first += blocks_in_mask) {
    Word& mask = *to++ = 0;
    for (std::size_t i = first; i < std::min(blocks, first + blocks_in_mask); ++i) {
      const std::byte* const block = plain_.data() + i * block_size;
      const Word there = is_zero(bits_of(block)) ? 0 : 1;
      mask |= there << (i - first);
      std::memcpy(to, block, block_size);
      to += there * words_in_block;  // the next one overwrites zeros
    }
  }
  packed.assign(packed_.data(), to);
}

namespace {

/// Reads words of a packed state.
class Words {
 public:
  explicit Words(std::span<const Word> left) : left_(left) {}
  [[nodiscard]] const Word* take(std::size_t words) {
    if (words > left_.size()) throw SetupError("a packed state ends too early");
    const Word* const from = left_.data();
    left_ = left_.subspan(words);
    return from;
  }
  /// Of blocks that are there, and these blocks.
  [[nodiscard]] std::pair<Word, const Word*> take_blocks() {
    const Word mask = *take(1);
    return {mask, take(words_in_block * static_cast<std::size_t>(std::popcount(mask)))};
  }
  [[nodiscard]] bool done() const { return left_.empty(); }

 private:
  std::span<const Word> left_;
};

}  // namespace

void StatePacker::load(std::span<const Word> packed) {
  if (packed.empty()) throw SetupError("a packed state is empty");
  Words words(packed.subspan(1));
  if (!std::exchange(is_saved_, false)) std::ranges::fill(masks_, ~Word{0});
  masks_known_ = false;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    auto [mask, from] = words.take_blocks();
    const Word other = std::exchange(masks_[g], mask);
    for (const Piece& piece : pieces(groups_[g])) from = load_blocks(piece, mask, other, from);
  }
  masks_known_ = true;
  const std::size_t blocks = blocks_of(packed[0]);
  plain_.assign(blocks * block_size, std::byte{});
  for (std::size_t first = 0; first < blocks; first += blocks_in_mask) {
    auto [mask, from] = words.take_blocks();
    for_bits(mask & lowest_bits(blocks - first), [&](std::size_t i) {
      std::memcpy(plain_.data() + (first + i) * block_size, from, block_size);
      from += words_in_block;
    });
  }
  StateArchive archive{std::span<const std::byte>(plain_).first(packed[0])};
  visit_others(archive);
  if (archive.left() > 0 || !words.done()) throw SetupError("a packed state is longer than those of this simulation");
  simulation_->scheduler_.restart_checks();
}

void StatePacker::forget() { masks_known_ = is_saved_ = false; }

}  // namespace murosimf
