#include "murosimf/runtime/state_packer.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {
namespace {

using Word = StatePacker::Word;

constexpr std::size_t words_in_block = 4, block_size = words_in_block * sizeof(Word), blocks_in_mask = 64;

std::size_t blocks_of(std::size_t bytes) { return (bytes + block_size - 1) / block_size; }

/// All that a state has, as Simulation::save() visits it.
template <class Visit>
void visit_parts(Simulation& simulation, const Visit& visit) {
  simulation.world().for_all([&](Entity& entity) {
    visit(entity);
    for (const auto& [name, column] : entity.columns()) {
      if (column->info().scope != Scope::wiring) visit(*column);
    }
  });
}

}  // namespace

void StatePacker::save(Simulation& simulation, std::vector<Word>& packed) {
  plain_.clear();
  StateArchive archive(plain_);
  visit_parts(simulation, [&](auto& part) { part.state(archive); });
  for (const auto& task : simulation.tasks_) task->algorithm->state(archive);
  simulation.state(archive);
  pack(packed);
}

void StatePacker::load(Simulation& simulation, std::span<const Word> packed) {
  unpack(packed);
  StateArchive archive{std::span<const std::byte>(plain_)};
  visit_parts(simulation, [&](auto& part) { part.state(archive); });
  for (const auto& task : simulation.tasks_) task->algorithm->state(archive);
  simulation.state(archive);
  if (archive.left() > 0) throw SetupError(fmt::format("{} bytes of a state are left over", archive.left()));
  simulation.restart_checks();
}

/// Into working memory first, so that `packed` takes no more than it needs.
void StatePacker::pack(std::vector<Word>& to) {
  const std::size_t size = plain_.size(), blocks = blocks_of(size);
  std::vector<Word>& packed = packed_;
  packed.resize(1 + words_in_block * blocks +
                (blocks + blocks_in_mask - 1) / blocks_in_mask);  // the most that it may become
  packed[0] = size;
  std::size_t end = 1, mask = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (block % blocks_in_mask == 0) packed[mask = end++] = 0;
    Word words[words_in_block] = {};
    const std::size_t first = block * block_size;
    if (first + block_size <= size) {
      std::memcpy(words, plain_.data() + first, block_size);
    } else {
      std::memcpy(words, plain_.data() + first, size - first);
    }
    if ((words[0] | words[1] | words[2] | words[3]) == 0) continue;
    packed[mask] |= Word{1} << block % blocks_in_mask;
    std::memcpy(&packed[end], words, block_size);
    end += words_in_block;
  }
  to.assign(packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(end));
}

void StatePacker::unpack(std::span<const Word> packed) {
  const std::size_t size = packed[0], blocks = blocks_of(size);
  plain_.resize(blocks * block_size);
  std::size_t next = 1;
  Word mask = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (block % blocks_in_mask == 0) mask = packed[next++];
    std::byte* const to = plain_.data() + block * block_size;
    if ((mask >> block % blocks_in_mask & 1U) == 0) {
      std::memset(to, 0, block_size);
      continue;
    }
    std::memcpy(to, &packed[next], block_size);
    next += words_in_block;
  }
  plain_.resize(size);
}

}  // namespace murosimf
