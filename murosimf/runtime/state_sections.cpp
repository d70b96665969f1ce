#include "murosimf/runtime/state_sections.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/runtime/bytes_hash.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {
namespace {

constexpr std::string_view first_line = "MuRoSimF state 4\n";  // the number is that of the format
constexpr std::size_t begin_of_sections = first_line.size() + sizeof(std::uint64_t);

template <class Sections>
bool has(const Sections& sections, const std::string& name) {
  return std::ranges::any_of(sections, [&](const SectionName& section) { return section.name == name; });
}

}  // namespace

StateWriter::StateWriter() : bytes_(begin_of_sections) {}

void StateWriter::add(SectionName section, std::span<const std::byte> content) {
  MUROSIMF_ASSERT(bytes_.size() >= begin_of_sections && "it was finished");
  auto size = static_cast<std::uint64_t>(content.size());
  StateArchive archive(bytes_);
  archive(section.name, section.optional, size);
  bytes_.insert(bytes_.end(), content.begin(), content.end());
}

std::vector<std::byte> StateWriter::finish() {
  const std::uint64_t hash = hash_of(std::span<const std::byte>(bytes_).subspan(begin_of_sections));
  std::memcpy(bytes_.data(), first_line.data(), first_line.size());
  std::memcpy(bytes_.data() + first_line.size(), &hash, sizeof(hash));
  return std::exchange(bytes_, {});
}

StateReader::StateReader(std::span<const std::byte> bytes) {
  const auto line = std::as_bytes(std::span(first_line));
  if (bytes.size() < begin_of_sections || !std::equal(line.begin(), line.end(), bytes.begin())) {
    throw SetupError("these bytes are no state that this version of the library has saved");
  }
  std::uint64_t hash = 0;
  std::memcpy(&hash, bytes.data() + line.size(), sizeof(hash));
  std::span<const std::byte> rest = bytes.subspan(begin_of_sections);
  if (hash_of(rest) != hash) throw SetupError("these bytes of a state are damaged, or not all there");
  while (!rest.empty()) {
    StateArchive archive(rest);
    std::uint64_t size = 0;
    Section& section = sections_.emplace_back();
    archive(section.name, section.optional, size);
    rest = rest.last(archive.left());
    if (size > rest.size()) throw SetupError("the state ends too early");
    section.bytes = rest.first(size);
    rest = rest.subspan(size);
  }
}

void StateReader::check_names(const std::vector<SectionName>& own) const {
  for (const SectionName& section : sections_) {
    if (section.optional || has(own, section.name)) continue;
    throw SetupError(fmt::format("the state has {}, this simulation has not: it was built otherwise", section.name));
  }
  for (const SectionName& section : own) {
    if (section.optional || has(sections_, section.name)) continue;
    throw SetupError(fmt::format("this simulation has {}, the state has not: it was built otherwise", section.name));
  }
}

std::optional<std::span<const std::byte>> StateReader::next(std::string_view name) {
  for (std::size_t i = next_; i < sections_.size(); ++i) {
    if (sections_[i].name != name) continue;
    next_ = i + 1;
    return sections_[i].bytes;
  }
  return std::nullopt;
}

}  // namespace murosimf
