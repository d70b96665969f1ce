#include "murosimf/runtime/state_packer.h"

#include <algorithm>
#include <cstring>

#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {
namespace {

using Word = StatePacker::Word;

constexpr std::size_t words_in_block = 4, block_size = words_in_block * sizeof(Word), blocks_in_mask = 64;

struct Block {
  Word words[words_in_block] = {};
};

/// Words that at most stand for so many bytes, with the masks.
std::size_t most_words(std::size_t bytes) {
  const std::size_t blocks = bytes / block_size + 1;
  return words_in_block * blocks + blocks / blocks_in_mask + 1;
}

class Packing {
 public:
  /// Behind what is there; each call of add() has room for it.
  explicit Packing(std::vector<Word>& to) : to_(to) {}

  void add(std::span<const std::byte> bytes) {
    to_.resize(std::max(to_.size(), end_ + most_words(bytes.size())));
    std::size_t at = 0;
    for (; at + block_size <= bytes.size(); at += block_size) {
      Block block;
      std::memcpy(&block, bytes.data() + at, block_size);
      add(block);
    }
    if (at == bytes.size()) return;
    Block block;
    std::memcpy(&block, bytes.data() + at, bytes.size() - at);
    add(block);
  }
  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  void add(const Block& block) {
    if (blocks_++ % blocks_in_mask == 0) {
      mask_ = end_++;
      to_[mask_] = 0;
    }
    if ((block.words[0] | block.words[1] | block.words[2] | block.words[3]) == 0) return;
    to_[mask_] |= Word{1} << (blocks_ - 1) % blocks_in_mask;
    std::memcpy(&to_[end_], &block, block_size);
    end_ += words_in_block;
  }

  std::vector<Word>& to_;
  std::size_t end_ = 1, mask_ = 0, blocks_ = 0;  // the first word is the caller's
};

class Unpacking {
 public:
  explicit Unpacking(std::span<const Word> from) : from_(from) {}

  void take(std::span<std::byte> bytes) {
    for (std::size_t at = 0; at < bytes.size(); at += block_size) {
      if (blocks_ % blocks_in_mask == 0) mask_ = next(1)[0];
      const bool there = (mask_ >> blocks_++ % blocks_in_mask & 1U) != 0;
      const std::size_t size = std::min(block_size, bytes.size() - at);
      if (size == block_size) {
        there ? std::memcpy(&bytes[at], next(words_in_block), block_size) : std::memset(&bytes[at], 0, block_size);
      } else {
        there ? std::memcpy(&bytes[at], next(words_in_block), size) : std::memset(&bytes[at], 0, size);
      }
    }
  }
  [[nodiscard]] bool done() const { return at_ == from_.size(); }

 private:
  [[nodiscard]] const Word* next(std::size_t words) {
    if (at_ + words > from_.size()) throw SetupError("a packed state ends too early");
    at_ += words;
    return from_.data() + (at_ - words);
  }

  std::span<const Word> from_;
  std::size_t at_ = 1, blocks_ = 0;
  Word mask_ = 0;
};

}  // namespace

StatePacker::StatePacker(Simulation& simulation) : simulation_(&simulation) {
  simulation.world().for_all([&](Entity& entity) {
    for (const auto& [name, column] : entity.columns()) {
      if (column->info().scope == Scope::wiring) continue;
      const ColumnBase::Memory memory = column->memory();
      if (memory.data) {
        numbers_.push_back(std::as_writable_bytes(std::span(memory.data, memory.rows * memory.stride)));
      } else {
        others_.push_back(column.get());
      }
    }
  });
}

/// All but columns of numbers.
template <class Archive>
void StatePacker::visit_others(Archive& archive) {
  simulation_->world().for_all([&](Entity& entity) { entity.state(archive); });
  for (ColumnBase* column : others_) column->state(archive);
  for (const auto& task : simulation_->tasks_) task->algorithm->state(archive);
  simulation_->state(archive);
}

void StatePacker::save(std::vector<Word>& packed) {
  plain_.clear();
  StateArchive archive(plain_);
  visit_others(archive);
  Packing packing(packed_);
  for (const std::span<std::byte>& column : numbers_) packing.add(column);
  packing.add(plain_);
  packed_[0] = plain_.size();
  packed.assign(packed_.begin(), packed_.begin() + static_cast<std::ptrdiff_t>(packing.end()));
}

void StatePacker::load(std::span<const Word> packed) {
  if (packed.empty()) throw SetupError("a packed state is empty");
  Unpacking unpacking(packed);
  for (const std::span<std::byte>& column : numbers_) unpacking.take(column);
  plain_.resize(packed[0]);
  unpacking.take(plain_);
  StateArchive archive{std::span<const std::byte>(plain_)};
  visit_others(archive);
  if (archive.left() > 0 || !unpacking.done())
    throw SetupError("a packed state is longer than those of this simulation");
  simulation_->scheduler_.restart_checks();
}

}  // namespace murosimf
