#include "murosimf/scene/scene_state.h"

#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/section_changes.h"

namespace murosimf::scene {
namespace {

void load(SceneParts& parts, std::span<const std::byte> bytes) {
  StateArchive archive(bytes);
  std::uint64_t seed = parts.spec.seed;
  archive(seed);
  std::vector<Algorithms> algorithms = algorithms_in_force(parts);
  with_context("state of the scene's moving entities", [&] { archive.elements(std::span(algorithms)); });
  for (std::size_t i = 0; i < algorithms.size(); ++i) put_in_force(parts, *parts.moving_entities[i], algorithms[i]);
  ChangingSections sections;
  archive(sections);
  put_in_force(parts, sections);
  if (seed != parts.spec.seed) parts.simulation->reseed(seed);
  parts.spec.seed = seed;
  parts.simulation->load(bytes.last(archive.left()));
}

}  // namespace

std::vector<std::byte> save_state(SceneParts& parts) {
  std::vector<std::byte> bytes;
  StateArchive archive(bytes);
  archive(parts.spec.seed);
  std::vector<Algorithms> algorithms = algorithms_in_force(parts);
  archive(algorithms);
  ChangingSections sections = sections_in_force(parts);
  archive(sections);
  const std::vector<std::byte> simulation = parts.simulation->save();
  bytes.insert(bytes.end(), simulation.begin(), simulation.end());
  return bytes;
}

void load_state(SceneParts& parts, std::span<const std::byte> bytes) {
  const std::vector<std::byte> before = save_state(parts);
  try {
    load(parts, bytes);
  } catch (const SetupError&) {
    load(parts, before);
    throw;
  }
}

}  // namespace murosimf::scene
