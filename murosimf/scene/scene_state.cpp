// Bytes of a state: a header line, the number of the bytes that follow, their checksum, and these: exchanged algorithms, changed
// constants, and the state of its simulation.
#include "murosimf/scene/scene_state.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/runtime/bytes_hash.h"
#include "murosimf/scene/constant_changes.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/section_changes.h"

namespace murosimf::scene {
namespace {

constexpr std::string_view first_line = "MuRoSimF scene state 6\n";  // the number of the format
constexpr std::string_view older_line = "MuRoSimF state ";  // of its simulation, in formats without a header line

/// Follows the header line.
struct Seal {
  std::uint64_t size = 0, checksum = 0;
};
constexpr std::size_t begin_of_content = first_line.size() + sizeof(Seal);

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

bool begins_with(std::span<const std::byte> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::ranges::equal(bytes.first(text.size()), bytes_of(text));
}

/// Throws SetupError if the bytes are no complete and intact state.
std::span<const std::byte> content_of(std::span<const std::byte> bytes) {
  if (!begins_with(bytes, first_line)) {
    constexpr std::size_t sign = first_line.find('6');
    const bool older =
        begins_with(bytes, first_line.substr(0, sign)) || !std::ranges::search(bytes, bytes_of(older_line)).empty();
    throw SetupError(older ? "this state is of another form than this version of the program has; have it saved again"
                           : "these bytes are no state of a scene");
  }
  Seal seal;
  if (bytes.size() >= begin_of_content) std::memcpy(&seal, bytes.data() + first_line.size(), sizeof(seal));
  if (bytes.size() < begin_of_content || bytes.size() - begin_of_content < seal.size) {
    throw SetupError(fmt::format("the state is cut off: {} bytes of it are there", bytes.size()));
  }
  const std::span<const std::byte> content = bytes.subspan(begin_of_content);
  if (content.size() != seal.size || hash_of(content) != seal.checksum) {
    throw SetupError(
        fmt::format("the state is damaged: its {} bytes do not have the checksum that they were saved with",
                    bytes.size()));
  }
  return content;
}

void load(SceneParts& parts, std::span<const std::byte> bytes) {
  StateArchive archive(bytes);
  std::uint64_t seed = parts.spec.seed;
  archive(seed);
  std::vector<Algorithms> algorithms = algorithms_in_force(parts);
  with_context("state of the scene's moving entities", [&] { archive.elements(std::span(algorithms)); });
  MUROSIMF_ASSERT(algorithms.size() == parts.moving_entities.size());
  // levels first: they create the columns that the simulation's state fills
  for (std::size_t i = 0; i < algorithms.size(); ++i) put_in_force(parts, *parts.moving_entities[i], algorithms[i]);
  ChangedConstants constants;
  archive(constants);
  put_in_force(parts, constants);
  ChangingSections sections;
  archive(sections);
  put_in_force(parts, sections);
  if (seed != parts.spec.seed) parts.simulation->reseed(seed);
  parts.spec.seed = seed;
  parts.simulation->load(bytes.last(archive.left()));
}

}  // namespace

/// Algorithms come first: loading must exchange them before their states are read.
std::vector<std::byte> save_state(SceneParts& parts) {
  std::vector<std::byte> bytes(begin_of_content);
  StateArchive archive(bytes);
  archive(parts.spec.seed);
  std::vector<Algorithms> algorithms = algorithms_in_force(parts);
  archive(algorithms);
  archive(parts.constants);
  ChangingSections sections = sections_in_force(parts);
  archive(sections);
  const std::vector<std::byte> simulation = parts.simulation->save();
  bytes.insert(bytes.end(), simulation.begin(), simulation.end());
  MUROSIMF_ASSERT(bytes.size() >= begin_of_content);
  const std::span content = std::span<const std::byte>(bytes).subspan(begin_of_content);
  const Seal seal{content.size(), hash_of(content)};
  std::ranges::copy(bytes_of(first_line), bytes.begin());
  std::memcpy(bytes.data() + first_line.size(), &seal, sizeof(seal));
  return bytes;
}

void load_state(SceneParts& parts, std::span<const std::byte> bytes) {
  const std::span<const std::byte> content = content_of(bytes);
  // Loading changes the scene piece by piece: on an error the previous state is loaded again.
  const std::vector<std::byte> before = save_state(parts);
  try {
    load(parts, content);
  } catch (const SetupError&) {
    load(parts, content_of(before));
    throw;
  }
}

}  // namespace murosimf::scene
